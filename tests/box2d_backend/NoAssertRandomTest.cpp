// SPDX-License-Identifier: MIT
// Random worlds that seek the borders of what Box2D bears. Its asserts end the process, so that nothing that
// passes through the interface may reach them. SHAPES_BORDER_WORLDS says how many.
#include "Box2DTesting.h"
#include "box2d_backend/world/Tuning.h"
#include "contract/Backends.h"
#include "fuzz/Fuzz.h"
#include "traps/Traps.h"

#include <csignal>
#include <cstdio>

namespace Shapes::Box2D {
namespace {

/// Random values at the borders of what the interface takes, and of what Box2D bears.
class CBorders {
public:
  explicit CBorders(Tests::CRandom& random) : m_cRandom(random) {}

  CWorldDesc World(eProfile profile) {
    CWorldDesc desc;
    desc.m_cBox2D.m_eProfile = profile;
    desc.m_cBox2D.m_fLengthUnit =
        Often(1.0f, {1e-45f, 1e-38f, 1e-30f, 1e-18f, 1e-6f, 0.01f, 100.0f, 1e10f, g_fMaxLength});
    desc.m_fTimeStep =
        Often(1.0f / 60.0f, {g_fMinTimeStep, 1e-20f, 1e-6f, 1.0f, 1e3f, g_fMaxTimeStep, 1e-39f, 2e6f});
    desc.m_nSubsteps = m_cRandom.Below(4) > 0 ? 1 : 2;
    // Rarely tiny: thousands of chords for each arc, all at one place, take Box2D seconds.
    desc.m_cBox2D.m_fSagittaTolerance = m_cRandom.Below(16) == 0
                                            ? Often(1e-5f, {1e-45f, 1e-38f})
                                            : Often(g_fSagittaTolerance, {0.001f, 1.0f, 1e9f, g_fMaxLength});
    desc.m_cBox2D.m_nVelocityIterations = Count(8);
    desc.m_cBox2D.m_nPositionIterations = Count(3);
    Inside(desc);
    desc.m_vGravity = Gravity();
    return desc;
  }

  /// From now on values are for such a world.
  void Inside(const CWorldDesc& desc) {
    m_fUnit = desc.m_cBox2D.m_fLengthUnit / GetTuning(desc.m_cBox2D.m_eProfile).m_fScale;
    m_fTimeStep = desc.m_fTimeStep;
  }

  Vector2 Gravity() {
    if (m_cRandom.Below(8) == 0) return Wild(g_fMaxBox2DSpeed);
    return m_cRandom.Coin() ? Vector2(0.0f, 0.0f) : Vector2(0.0f, -10.0f * m_fUnit);
  }

  float Elasticity() {
    return Often(1.0f, {0.0f, 1e-45f, 0.5f, 2.0f, 1e3f, g_fMaxElasticity, 2e6f, -1.0f, g_fNan});
  }

  float RotSpeed() {
    const float f = Often(1.0f, {0.0f, 1e-45f, 1e-20f, 30.0f, 1e4f, g_fMaxRotSpeed, 2e9f, g_fNan});
    return m_cRandom.Coin() ? f : -f;
  }

  float Angle() {
    if (m_cRandom.Below(64) == 0) return m_cRandom.Coin() ? g_fNan : 1e38f;
    const float quarter = 0.5f * g_fPi * static_cast<float>(m_cRandom.Below(5));
    return quarter + (m_cRandom.Coin() ? 0.0f : m_cRandom.SignedScale(-40, 1));
  }

  /// A length in user units, mostly one that means something to Box2D.
  float Length() {
    const float metres = Often(1.0f, {0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-6f, 0.0025f, 0.005f, 0.0075f, 0.01f,
                                      0.015f, 0.1f, 10.0f, 1e3f, 1e6f, g_fMaxBox2DLength});
    return Near(metres * m_fUnit);
  }

  /// Mostly near, or exactly at, what is there already.
  Vector2 Pos() {
    if (m_cRandom.Below(40) == 0) return Wild(g_fMaxBox2DLength);
    if (m_stdPoints.empty() || m_cRandom.Below(8) == 0) return Remember(m_cRandom.InSquare(m_fUnit));
    const Vector2 p = m_stdPoints[m_cRandom.Below(static_cast<std::uint32_t>(m_stdPoints.size()))];
    return m_cRandom.Coin() ? p : Remember(p + Step());
  }

  Vector2 Vel() {
    if (m_cRandom.Below(8) == 0) return Wild(g_fMaxBox2DSpeed);
    // Up to several of Box2D's longest moves a step.
    const Vector2 step = Step();
    return m_cRandom.Coin() ? step : Vector2(step / m_fTimeStep);
  }

  CDynamicCircleDesc Ball() {
    const Vector2 p = Pos(), v = Vel();
    float r = m_cRandom.Coin() ? 0.1f * m_fUnit : Length();
    // Rarely huge: where the digits of a float are used up Box2D looks long for a time of impact.
    if (r > 100.0f * m_fUnit && m_cRandom.Below(8) > 0) r = 0.0f;
    const float e = Elasticity();
    const float m = Often(1.0f, {g_fMinBox2DMass, 1e-6f, 1e6f, g_fMaxBox2DMass, 0.0f, 2e12f, g_fNan});
    CDynamicCircleDesc desc(p, r, v, m, e);
    desc.m_bIsSensor = m_cRandom.Below(12) == 0;
    return desc;
  }

  CAnyShapeDesc Shape() {
    const Vector2 p = Pos();
    const float e = Elasticity();
    switch (m_cRandom.Below(4)) {
    case 0: return Moving(CPointDesc(p, e));
    case 1: return Moving(LineSeg(p, Pos(), e));
    case 2: return Moving(CCircleDesc(p, Length(), e));
    default: return Moving(Arc(p, e));
    }
  }

  /// Segments and arcs that share ends, or nearly so.
  std::vector<CAnyShapeDesc> Chain() {
    std::vector<CAnyShapeDesc> chain;
    Vector2 p = Pos();
    const float e = Elasticity();
    for (std::uint32_t n = 1 + m_cRandom.Below(4); n > 0; --n) {
      Vector2 p0, next = p;
      if (m_cRandom.Below(3) == 0)
        std::get<CArcDesc>(chain.emplace_back(Arc(p, e))).GetEndPts(p0, next);
      else
        chain.emplace_back(LineSeg(p, next += Step(), e));
      p = next;
      if (m_cRandom.Below(4) == 0) p += Step();
    }
    return chain;
  }

private:
  template <std::size_t N>
  float Often(float usual, const float (&borders)[N]) {
    if (m_cRandom.Coin()) return usual;
    return borders[m_cRandom.Below(static_cast<std::uint32_t>(N))];
  }

  unsigned Count(unsigned usual) {
    if (m_cRandom.Below(4) > 0) return usual;
    return m_cRandom.Coin() ? 1 : 20;
  }

  // The value itself, or a float beside it.
  float Near(float f) {
    const std::uint32_t i = m_cRandom.Below(4);
    return i > 1 ? f : std::nextafter(f, i == 0 ? g_fInf : 0.0f);
  }

  // Along an axis or not, and hardly ever a unit vector of neither.
  Vector2 Unit() {
    if (m_cRandom.Coin()) return m_cRandom.Direction();
    const float sign = m_cRandom.Coin() ? 1.0f : -1.0f;
    return m_cRandom.Coin() ? Vector2(sign, 0.0f) : Vector2(0.0f, sign);
  }

  Vector2 Step() {
    const float d = Length(); // drawn before the direction
    return d * Unit();
  }

  // Up to a limit of Box2D, in metres, and one float beyond; or no number at all.
  Vector2 Wild(float most) {
    const float f = Near(most * m_fUnit), share = m_cRandom.Coin() ? 1.0f : 0.5f;
    Vector2 v = share * f * Unit();
    if (m_cRandom.Below(4) == 0) v.x() = m_cRandom.Coin() ? g_fNan : -g_fInf;
    return v;
  }

  const Vector2& Remember(const Vector2& p) { return m_stdPoints.emplace_back(p); }

  CLineSegDesc LineSeg(const Vector2& p0, const Vector2& p1, float e) {
    const CLineSegDesc desc = Sided(CLineSegDesc(p0, p1, e), Sides());
    Remember(p0), Remember(p1), Remember(desc.m_vPos);
    return desc;
  }

  /// With end 0 at p or with its centre there.
  CArcDesc Arc(const Vector2& p, float e) {
    const float r = Length(), a0 = Angle(), a1 = m_cRandom.Coin() ? Angle() : a0 + Near(g_fTwoPi);
    CArcDesc desc(p, r, a0, a1, e);
    Vector2 p0, p1;
    desc.GetEndPts(p0, p1);
    if (m_cRandom.Coin()) {
      desc.m_vPos += p - p0;
      desc.GetEndPts(p0, p1);
    }
    desc.m_eSides = Sides();
    Remember(desc.m_vPos), Remember(p0), Remember(p1);
    return desc;
  }

  eSides Sides() {
    return std::array{eSides::Both, eSides::Both, eSides::Front, eSides::Back}[m_cRandom.Below(4)];
  }

  template <class TDesc>
  TDesc Moving(TDesc desc) {
    desc.m_bIsSensor = m_cRandom.Below(12) == 0;
    if (m_cRandom.Coin()) return desc;
    const float speed = RotSpeed(); // drawn before the centre
    return Turning(desc, speed, Pos());
  }

  Tests::CRandom& m_cRandom;
  float m_fUnit = 1.0f, m_fTimeStep = 1.0f;
  std::vector<Vector2> m_stdPoints;
};

// The seed of the world that is being tried: an assert leaves no other trace.
volatile std::sig_atomic_t g_nSeed = 0;

void TellSeed(int) {
  std::fprintf(stderr, "aborted in the world of seed %d\n", static_cast<int>(g_nSeed)); // is not buffered
}

/// A random world and what is done to it.
class CTrial {
public:
  CTrial(eProfile profile, std::uint64_t seed) : m_cRandom(seed), m_cBorders(m_cRandom) {
    CWorldDesc desc;
    do {
      desc = m_cBorders.World(profile);
      Try([&] { m_pWorld = GetBackend(eBackend::Box2D)->MakeWorld(desc); });
    } while (!m_pWorld);
    m_cBorders.Inside(desc);
  }

  void Run() {
    const std::uint32_t n = 2 + m_cRandom.Below(10), rounds = 1 + m_cRandom.Below(4);
    for (std::uint32_t i = 0; i < n; ++i)
      Add();
    // A tuned world parts the steps of what is fast.
    for (std::uint32_t i = 0; i < rounds && m_pWorld->GetStats().m_nEngineSteps < 300; ++i) {
      for (std::uint32_t steps = 1 + m_cRandom.Below(3); steps > 0; --steps)
        m_pWorld->Step(), ExpectFinite();
      for (std::uint32_t changes = m_cRandom.Below(4); changes > 0; --changes)
        m_cRandom.Below(4) == 0 ? Add() : Try([&] { Change(); });
    }
    m_pWorld->Step();
    ExpectFinite();
  }

  std::uint64_t m_nAccepted = 0, m_nRefused = 0, m_nContacts = 0;

private:
  // A refused call changes nothing, and nothing but std::invalid_argument is thrown.
  template <class F>
  void Try(const F& f) {
    const std::vector<Vector2> before = Positions();
    try {
      f();
      ++m_nAccepted;
    } catch (const std::invalid_argument&) {
      ++m_nRefused;
      EXPECT_EQ(Positions(), before);
    }
  }

  std::vector<Vector2> Positions() const {
    std::vector<Vector2> all;
    if (!m_pWorld) return all;
    for (const CShapeId id : m_stdIds)
      all.push_back(m_pWorld->GetPos(id));
    for (const auto& views : {m_pWorld->GetBallPositions(), m_pWorld->GetBallVelocities()})
      all.insert(all.end(), views.begin(), views.end());
    return all;
  }

  void ExpectFinite() {
    for (const Vector2& v : Positions())
      EXPECT_TRUE(v.allFinite()) << v.transpose();
    EXPECT_NO_THROW(Fuzz::RequireSound(*m_pWorld));
    m_nContacts += m_pWorld->GetContacts().size();
  }

  void Add() {
    const auto add = [&](const CAnyShapeDesc& desc) {
      Try([&] { m_stdIds.push_back(m_pWorld->Add(desc)); });
    };
    const std::uint32_t what = m_cRandom.Below(8);
    if (what == 0) {
      const auto chain = m_cBorders.Chain();
      const Vector2 center = m_cBorders.Pos();
      const float speed = m_cBorders.RotSpeed();
      Try([&] {
        std::ranges::copy(m_pWorld->AddCompound(chain, center, speed), std::back_inserter(m_stdIds));
      });
    } else if (what == 1) {
      for (const CAnyShapeDesc& desc : m_cBorders.Chain())
        add(desc);
    } else {
      add(what < 5 ? m_cBorders.Shape() : m_cBorders.Ball());
    }
    // Thousands of chords that all touch one ball take Box2D seconds a step.
    for (; m_pWorld->GetStats().m_nArcPieces > 30; m_stdIds.pop_back())
      m_pWorld->Remove(m_stdIds.back());
  }

  void Change() {
    if (m_stdIds.empty()) return;
    const std::uint32_t i = m_cRandom.Below(static_cast<std::uint32_t>(m_stdIds.size()));
    const CShapeId id = m_stdIds[i];
    switch (m_cRandom.Below(16)) {
    case 0: m_stdIds.erase(m_stdIds.begin() + i), m_pWorld->Remove(id); break;
    case 1:
    case 2: m_pWorld->SetPos(id, m_cBorders.Pos()); break;
    case 3:
    case 4: m_pWorld->SetVel(id, m_cBorders.Vel()); break;
    case 5: m_pWorld->SetOrientation(id, m_cBorders.Angle()); break;
    case 6: m_pWorld->SetRotSpeed(id, m_cBorders.RotSpeed()); break;
    case 7: m_pWorld->SetRotCenter(id, m_cBorders.Pos()); break;
    case 8: m_pWorld->SetElasticity(id, m_cBorders.Elasticity()); break;
    case 9: m_pWorld->SetSensor(id, m_cRandom.Coin()); break;
    case 10: m_pWorld->SetCanCollide(id, m_cRandom.Coin()); break;
    case 11: m_pWorld->Reset(id); break;
    case 12: m_pWorld->SetGravity(m_cBorders.Gravity()); break;
    case 13: m_cSaved = m_pWorld->SaveState(), m_stdSavedIds = m_stdIds; break;
    case 14: m_pWorld->LoadState(m_cSaved), m_stdIds = m_stdSavedIds; break;
    default: m_pWorld->SetUserPtr(id, this); break;
    }
  }

  Tests::CRandom m_cRandom;
  CBorders m_cBorders;
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdIds, m_stdSavedIds;
  CSavedState m_cSaved;
};

class CNoAssertRandom : public Tests::CEveryProfile {
  // At the limits Box2D's own numbers may be infinite, but not its results.
  const CWithoutTraps m_cInBox2D;
};
SHAPES_ON_EVERY_PROFILE(CNoAssertRandom);

TEST_P(CNoAssertRandom, WorldsAtTheBordersNeitherAbortNorLoseTheirNumbers) {
  const std::uint64_t n = HowMany("SHAPES_BORDER_WORLDS", IsTuned() ? 180 : 400);
  const auto previous = std::signal(SIGABRT, TellSeed);
  std::uint64_t accepted = 0, refused = 0, contacts = 0;
  for (std::uint64_t seed = 1; seed <= n && !HasFailure(); ++seed) {
    g_nSeed = static_cast<std::sig_atomic_t>(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CTrial trial(GetParam(), seed);
    trial.Run();
    accepted += trial.m_nAccepted;
    refused += trial.m_nRefused;
    contacts += trial.m_nContacts;
  }
  std::signal(SIGABRT, previous);
  // The borders are met from both sides, and the worlds are not empty.
  EXPECT_GT(accepted, n);
  EXPECT_GT(refused, n / 10);
  EXPECT_GT(contacts, n);
}

// The shapes of a game, one pair at a time: there is no world that would refuse what is too far for Box2D.
TEST(NoAssertRandomPair, ContactsAtTheBordersHaveNumbers) {
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = 1; seed <= 600 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Tests::CRandom random(seed);
    CBorders borders(random);
    CWorldDesc desc;
    if (random.Below(4) == 0) desc.m_cBox2D.m_fLengthUnit = 1e10f; // up to the largest lengths of a shape
    borders.Inside(desc);
    CGameClock::Set(1.0f / 60.0f, random.Coin() ? 0.0f : -10.0f);
    const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(CWorldDesc());
    try {
      const auto pShape = pWorld->GetShape(pWorld->Add(borders.Shape())).Clone();
      CDynamicCircle ball(borders.Ball());
      // Thousands of chords that turn, each swept in dozens of parts, take half a minute.
      const bool isHuge = pShape->GetAABB().GetWidth() > 1e4f;
      if (isHuge && pShape->GetShapeType() == eShape::Arc && pShape->GetRotating()) continue;
      for (int i = 0; i < 3; ++i) {
        pShape->move();
        ball.move();
        CContactDesc c(pShape.get(), &ball);
        if (!GetBackend(eBackend::Box2D)->CollisionDetected(c)) continue;
        ++contacts;
        EXPECT_TRUE(c.m_vPOI.allFinite()) << c.m_vPOI.transpose();
        EXPECT_NEAR(c.m_vNorm.norm(), 1.0f, 1e-5f) << c.m_vNorm.transpose();
        for (const float f : {c.m_fSetback, c.m_fSpeed})
          EXPECT_TRUE(std::isfinite(f)) << f;
        ball.CollisionResponse(c);
        for (const Vector2& v : {ball.GetPos(), ball.GetVel()})
          EXPECT_TRUE(v.allFinite()) << v.transpose();
      }
    } catch (const std::invalid_argument&) { // one of them is beyond the borders
    }
  }
  CGameClock::Set(1.0f / 60.0f, 0.0f);
  EXPECT_GT(contacts, 200u);
}

} // namespace
} // namespace Shapes::Box2D
