// SPDX-License-Identifier: MIT
// Random worlds that seek the borders of what Box2D bears. Its asserts end the process, so that nothing that
// passes through the interface may reach them. SHAPES_BORDER_WORLDS says how many.
#include "Box2DTesting.h"
#include "box2d_backend/world/Tuning.h"
#include "contract/Backends.h"
#include "fuzz/WorldTrial.h"
#include "traps/Traps.h"

#include <csignal>
#include <cstdio>

namespace Shapes::Box2D {
namespace {

/// Random values at the borders of what the interface takes, and of what Box2D bears.
class CBorders {
public:
  explicit CBorders(Tests::CRandom& random) : m_cRandom(random) {}

  unsigned Below(unsigned n) { return m_cRandom.Below(n); }
  bool Flag() { return m_cRandom.Coin(); }

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

  /// A point, a segment, a circle, an arc, or a ball.
  CAnyShapeDesc Shape(unsigned what) {
    if (what == 4) return Ball();
    const Vector2 p = Pos();
    const float e = Elasticity();
    switch (what) {
    case 0: return Moving(CPointDesc(p, e));
    case 1: return Moving(LineSeg(p, Pos(), e));
    case 2: return Moving(CCircleDesc(p, Length(), e));
    default: return Moving(Arc(p, e));
    }
  }

  /// Segments and arcs that share ends, or nearly so.
  std::vector<CAnyShapeDesc> Parts() {
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

/// A random world, what is done to it, and how many contacts there are.
std::uint64_t Play(Fuzz::CWorldTrial<CBorders>& trial, CBorders& borders, eProfile profile) {
  CWorldDesc desc;
  do {
    desc = borders.World(profile);
  } while (!trial.Make(*GetBackend(eBackend::Box2D), desc));
  borders.Inside(desc);
  const auto add = [&] {
    const unsigned what = borders.Below(8);
    if (what > 1) return trial.Do(what < 5 ? borders.Below(4) : 4); // a shape, or a ball
    if (what == 1) return trial.Do(5);                              // a compound
    for (const CAnyShapeDesc& part : borders.Parts())
      trial.Add(part);
  };
  const unsigned n = 2 + borders.Below(10), rounds = 1 + borders.Below(4);
  for (unsigned i = 0; i < n; ++i)
    add();
  std::uint64_t contacts = 0;
  const auto step = [&] {
    trial.Step();
    contacts += trial.GetWorld().GetContacts().size();
  };
  // A tuned world parts the steps of what is fast.
  for (unsigned i = 0; i < rounds && trial.GetWorld().GetStats().m_nEngineSteps < 300; ++i) {
    for (unsigned steps = 1 + borders.Below(3); steps > 0; --steps)
      step();
    for (unsigned changes = borders.Below(4); changes > 0; --changes)
      borders.Below(4) == 0 ? add() : trial.Do(10 + borders.Below(Fuzz::g_nOperations - 10));
  }
  step();
  return contacts;
}

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
    Tests::CRandom random(seed);
    CBorders borders(random);
    Fuzz::CWorldTrial trial(borders);
    EXPECT_NO_THROW(contacts += Play(trial, borders, GetParam()));
    accepted += trial.m_nAccepted;
    refused += trial.m_nRefused;
  }
  std::signal(SIGABRT, previous);
  // The borders are met from both sides, and the worlds are not empty.
  EXPECT_GT(accepted, n);
  EXPECT_GT(refused, n / 10);
  EXPECT_GT(contacts, n);
}

// The shapes of a game, one pair at a time: there is no world that would refuse what is too far for Box2D.
TEST(NoAssertRandomPair, ContactsAtTheBordersHaveNumbers) {
  std::map<std::string_view, int> contacts; // of each engine
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
      const CShape& shape = pWorld->GetShape(pWorld->Add(borders.Shape(random.Below(4))));
      const CDynamicCircle ball(borders.Ball());
      // Thousands of chords that turn, each swept in dozens of parts, take half a minute.
      const bool isHuge = shape.GetAABB().GetWidth() > 1e4f;
      if (isHuge && shape.GetShapeType() == eShape::Arc && shape.GetRotating()) continue;
      for (const CBackend& backend : GetBackends()) {
        const auto pMet = shape.Clone();
        CDynamicCircle struck(ball);
        for (int i = 0; i < 3; ++i) {
          pMet->move();
          struck.move();
          CContactDesc c(pMet.get(), &struck);
          if (!backend.CollisionDetected(c)) continue;
          ++contacts[backend.GetName()];
          EXPECT_NO_THROW(Fuzz::RequireSoundContact(c));
          struck.CollisionResponse(c);
          for (const Vector2& v : {struck.GetPos(), struck.GetVel()})
            EXPECT_TRUE(v.allFinite()) << v.transpose();
        }
      }
    } catch (const std::invalid_argument&) { // one of them is beyond the borders
    }
  }
  CGameClock::Set(1.0f / 60.0f, 0.0f);
  EXPECT_GT(contacts["box2d"], 200);
  EXPECT_GT(contacts["native"], 100);
}

} // namespace
} // namespace Shapes::Box2D
