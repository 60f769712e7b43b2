// SPDX-License-Identifier: MIT
// Balls that press on each other: Box2D's own solver moves them in a tuned world, too.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"
#include "box2d_backend/world/OwnedEngine.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nPileSeed = 83;
constexpr float g_fPileRadius = 0.2f, g_fPileGravity = 10.0f;

enum class eVessel { Box, V, Bowl };

/// A closed vessel, and balls that fall into it.
struct CVessel {
  eVessel m_eKind;
  std::unique_ptr<CWorld> m_pWorld;
  float m_fSize; // width of a box, half the width and height of a V, radius of a bowl

  CVessel(const Box2D::CTuning& tuning, eVessel kind, int balls, float e, const CEffects& forced = {})
      : m_eKind(kind) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -g_fPileGravity};
    desc.m_fTimeStep = g_fDt;
    desc.m_cEffects.m_cForced = forced;
    m_pWorld = Box2D::MakeWorld(desc, tuning);
    m_fSize = std::max(2.0f, 3.4f * g_fPileRadius * std::sqrt(static_cast<float>(balls)));
    const float s = m_fSize;
    if (kind == eVessel::Bowl) {
      m_pWorld->Add(CArcDesc({0, 0}, s, 0, 0));
    } else {
      const Vector2 left(kind == eVessel::V ? 0 : -0.5f * s, 0), right(-left.x(), 0);
      const Vector2 top(kind == eVessel::V ? s : 0.5f * s, 2 * s);
      m_pWorld->Add(CLineSegDesc(left, {-top.x(), top.y()}));
      m_pWorld->Add(CLineSegDesc(right, top));
      m_pWorld->Add(CLineSegDesc({-top.x(), top.y()}, top));
      if (kind == eVessel::Box) m_pWorld->Add(CLineSegDesc(left, right));
    }
    CRandom random(g_nPileSeed);
    const float pitch = 2.1f * g_fPileRadius, bottom = kind == eVessel::Box ? 0.6f * pitch
                                                       : kind == eVessel::V ? s
                                                                            : -0.55f * s;
    const int columns = static_cast<int>(s / pitch - 0.5f);
    for (int i = 0; i < balls; ++i) {
      const float x = pitch * (static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1));
      const float y = bottom + pitch * static_cast<float>(i / columns);
      const float aside = 0.02f * static_cast<float>(random.Unit());
      CDynamicCircleDesc ball({x + aside, y}, g_fPileRadius,
                              {static_cast<float>(EitherSign(random, 0.5)), 0});
      ball.m_fElasticity = e;
      m_pWorld->Add(ball);
    }
  }

  void Step(int steps) {
    for (int i = 0; i < steps; ++i)
      m_pWorld->Step();
  }
  int CountLost() const {
    int lost = 0;
    for (const Vector2& p : m_pWorld->GetBallPositions()) {
      const float half = m_eKind == eVessel::V ? 0.5f * p.y() : 0.5f * m_fSize;
      lost += m_eKind == eVessel::Bowl ? !(p.norm() < m_fSize)
                                       : !(std::abs(p.x()) < half && p.y() > 0 && p.y() < 2 * m_fSize);
    }
    return lost;
  }
  /// Per mass, above the lowest place.
  double GetEnergy() const {
    double energy = 0;
    for (std::size_t i = 0; i < m_pWorld->GetBallIds().size(); ++i)
      energy += 0.5 * m_pWorld->GetBallVelocities()[i].squaredNorm() +
                g_fPileGravity * (m_pWorld->GetBallPositions()[i].y() + m_fSize);
    return energy;
  }
  double GetFastest() const {
    double most = 0;
    for (const Vector2& v : m_pWorld->GetBallVelocities())
      most = std::max<double>(most, v.norm());
    return most;
  }
  /// The largest of two balls, in radii.
  double GetOverlap() const {
    const auto p = m_pWorld->GetBallPositions();
    float most = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        most = std::max(most, 2 * g_fPileRadius - (p[i] - p[j]).norm());
    return most / g_fPileRadius;
  }
};

Box2D::CTuning WithoutLastingContact() {
  Box2D::CTuning tuning = Box2D::g_cTuned;
  tuning.m_bLastingContact = false;
  return tuning;
}

TEST(TunedPileTest, APileSettlesAndLosesNone) {
  for (const eVessel kind : {eVessel::Box, eVessel::V, eVessel::Bowl})
    for (const int balls : {10, 50})
      for (const float e : {0.0f, 0.5f, 0.9f}) {
        if (balls == 50 && e == 0.0f) continue;
        SCOPED_TRACE(testing::Message() << "vessel " << static_cast<int>(kind) << ", " << balls
                                        << " balls, e = " << e << ", seed " << g_nPileSeed);
        CVessel vessel(Box2D::g_cTuned, kind, balls, e);
        const double first = vessel.GetEnergy();
        for (int i = 0; i < 60; ++i) {
          vessel.Step(10);
          ASSERT_EQ(vessel.CountLost(), 0) << 10 * i;
          ASSERT_LE(vessel.GetEnergy(), 1.001 * first) << 10 * i;
        }
        // What slides in a bowl slides on.
        EXPECT_LT(vessel.GetFastest(), kind == eVessel::Bowl ? 1.0 : 0.2);
        EXPECT_LT(vessel.GetOverlap(), 0.1);
      }
}

// The bottom of a V at 30 units per second is where most press on one.
TEST(TunedPileTest, TwoHundredBallsThatFallIntoAWedgeStayInIt) {
  CVessel vessel(Box2D::g_cTuned, eVessel::V, 200, 0.5f);
  for (int i = 0; i < 30; ++i) {
    vessel.Step(10);
    ASSERT_EQ(vessel.CountLost(), 0) << 10 * i;
  }
}

TEST(TunedPileTest, APileIsSolvedAboutAsOftenAsByShippedBox2D) {
  const auto count = [](const Box2D::CTuning& tuning, eVessel kind, int steps) {
    CVessel vessel(tuning, kind, 10, 0.5f, {eEffect::Events}); // for the listener, which counts
    vessel.Step(steps);
    return static_cast<double>(vessel.m_pWorld->GetStats().m_nEngineContacts);
  };
  for (const eVessel kind : {eVessel::Box, eVessel::V, eVessel::Bowl}) {
    SCOPED_TRACE(static_cast<int>(kind));
    EXPECT_LT(count(Box2D::g_cTuned, kind, 600), 3 * count(Box2D::g_cShipped, kind, 600));
  }
  // The control.
  EXPECT_GT(count(WithoutLastingContact(), eVessel::V, 300), 10 * count(Box2D::g_cShipped, eVessel::V, 300));
}

TEST(TunedPileTest, BallsInOnePlaceComeApart) {
  const auto solve = [](const Box2D::CTuning& tuning, int balls, int steps) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -g_fPileGravity};
    desc.m_fTimeStep = g_fDt;
    desc.m_cEffects.m_cForced = {eEffect::Events};
    auto pWorld = Box2D::MakeWorld(desc, tuning);
    pWorld->Add(CArcDesc({0, 0}, 4, 0, 0));
    CRandom random(g_nPileSeed);
    for (int i = 0; i < balls; ++i) {
      CDynamicCircleDesc ball({static_cast<float>(EitherSign(random, 1e-3)), 0}, g_fPileRadius);
      ball.m_fElasticity = 0.5f;
      pWorld->Add(ball);
    }
    for (int i = 0; i < steps; ++i)
      pWorld->Step();
    for (const Vector2& p : pWorld->GetBallPositions())
      EXPECT_LT(p.norm(), 4);
    return static_cast<double>(pWorld->GetStats().m_nEngineContacts);
  };
  EXPECT_LT(solve(Box2D::g_cTuned, 60, 120), 2 * solve(Box2D::g_cShipped, 60, 120));
  EXPECT_GT(solve(WithoutLastingContact(), 12, 12), 10 * solve(Box2D::g_cShipped, 12, 12)); // the control
}

} // namespace
} // namespace Shapes::Tests
