// SPDX-License-Identifier: MIT
// Random piles: 10 to 200 balls, equal, of radii 1:10 or of masses 1:1000, fall into a box, a V, a bowl or an
// hourglass, or are pushed by a paddle, and lie there. None is lost in any step, no energy comes from
// nothing, and after 20 s all but those in bowls are at rest. SHAPES_PILES says how many, 15 by default: one
// of each kind. So it was in 1,000.
#include "NativeTesting.h"

#include "Tolerances.h"

namespace Shapes {
namespace {

enum class eRoom { Box, V, Bowl, Hourglass, Paddle };
enum class eMixture { Equal, Radii, Masses };

constexpr float g_fGravity = 10;
constexpr float g_fNeck = 0.6f; // half of the hourglass's
constexpr int g_nSteps = 900;

/// The middle of the floor is the origin.
struct CRandomPile {
  eRoom m_eRoom;
  eMixture m_eMixture;
  float m_fHalf = 0, m_fHeight = 0; // of the room
  std::unique_ptr<CWorld> m_pWorld;
  CShapeId m_nPaddle;

  CRandomPile(std::uint64_t seed, const CEffectChoice& effects)
      : m_eRoom(static_cast<eRoom>(seed % 5)),
        m_eMixture(static_cast<eMixture>(seed / 5 % 3)),
        m_pWorld(MakeNative(effects, g_fGravity)) {
    CRandom random(seed);
    const int counts[] = {10, 50, 50, 200};
    const float elasticities[] = {0.0f, 0.5f, 0.9f};
    const int balls = counts[random.Below(4)];
    const float e = elasticities[random.Below(3)];
    m_fHalf = std::max(1.0f, 0.3f * std::sqrt(static_cast<float>(balls)));
    AddWalls();
    AddBalls(random, balls, e);
  }

  void AddWalls() {
    const float w = m_fHalf;
    m_fHeight = 5 * w;
    if (m_eRoom == eRoom::Bowl) m_pWorld->Add(CArcDesc({0, w}, w, g_fPi, 2 * g_fPi));
    for (const float side : {-1.0f, 1.0f}) {
      const Vector2 top(side * w, m_fHeight), lid(0, m_fHeight), low(side * w, 0);
      switch (m_eRoom) {
      case eRoom::V: AddPath(*m_pWorld, {lid, top, {side * w, 2 * w}, {0, 0}}); break;
      case eRoom::Bowl: AddPath(*m_pWorld, {lid, top, {side * w, w}}); break;
      case eRoom::Hourglass:
        AddPath(*m_pWorld,
                {lid, top, {side * w, 3 * w}, {side * g_fNeck, 2 * w}, {side * w, w}, low, {0, 0}});
        break;
      default: AddPath(*m_pWorld, {lid, top, low, {0, 0}});
      }
    }
    if (m_eRoom == eRoom::Paddle) m_nPaddle = m_pWorld->Add(Turning(CLineSegDesc({0, 0.05f}, {0, 0.8f * w})));
  }
  void AddBalls(CRandom& random, int balls, float e) {
    const float largest = 0.2f, pitch = 2.1f * largest;
    const bool isHigh = m_eRoom == eRoom::Hourglass || m_eRoom == eRoom::V;
    const float floor = m_eRoom == eRoom::Paddle ? 0.8f * m_fHalf : isHigh ? 3 * m_fHalf : m_fHalf;
    const int columns = static_cast<int>((2 * m_fHalf - 2.1f * largest) / pitch);
    for (int i = 0; i < balls; ++i) {
      const float x = pitch * (static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1));
      const Vector2 shift = random.InSquare(0.04f * largest), v = random.InSquare(0.5f);
      const float r =
          m_eMixture == eMixture::Radii ? largest * std::pow(10.0f, -random.Uniform(0, 1)) : largest;
      const float m = m_eMixture == eMixture::Masses ? std::pow(1000.0f, random.Uniform(0, 1)) : 1.0f;
      const Vector2 p(x, floor + 1.1f * largest + pitch * static_cast<float>(i / columns));
      m_pWorld->Add(CDynamicCircleDesc(p + shift, r, v, m, e));
    }
  }

  /// The paddle goes to and fro for 300 steps, and then stands where it is.
  void Step(int step) {
    if (m_eRoom == eRoom::Paddle) {
      const float x = m_pWorld->GetPos(m_nPaddle).x(), turn = 0.6f * m_fHalf;
      if (step == 0 || x < -turn) m_pWorld->SetVel(m_nPaddle, {3, 0});
      if (x > turn) m_pWorld->SetVel(m_nPaddle, {-3, 0});
      if (step >= 300) m_pWorld->SetVel(m_nPaddle, {0, 0});
    }
    m_pWorld->Step();
  }
  bool IsInside(const Vector2& p) const {
    const float x = std::abs(p.x()), y = p.y(), w = m_fHalf;
    if (!(y > 0 && y < m_fHeight && x < w)) return false;
    switch (m_eRoom) {
    case eRoom::V: return y > 2 * x;
    case eRoom::Bowl: return y > w || (p - Vector2(0, w)).norm() < w;
    case eRoom::Hourglass: return x < g_fNeck + std::abs(y - 2 * w) / w * (w - g_fNeck);
    default: return true;
    }
  }
};

struct CResult {
  std::ptrdiff_t m_nLost = 0;
  double m_fGain = 0; // largest one in a step, in energies at the start
};

CResult PlayPile(CRandomPile& pile) {
  CResult result;
  const double first = GetEnergy(*pile.m_pWorld, g_fGravity);
  double last = first;
  for (int step = 0; step < g_nSteps; ++step) {
    pile.Step(step);
    const double before = std::exchange(last, GetEnergy(*pile.m_pWorld, g_fGravity));
    // The paddle gives energy, until the overlaps that it has pressed balls into are undone.
    if (pile.m_eRoom != eRoom::Paddle || step > 360)
      result.m_fGain = std::max(result.m_fGain, (last - before) / first);
    const std::ptrdiff_t lost =
        CountBalls(*pile.m_pWorld, [&](const Vector2& p) { return !pile.IsInside(p); });
    result.m_nLost = std::max(result.m_nLost, lost);
  }
  return result;
}

// For five seconds more than it was played, as an hourglass takes up to 15 to run through. Without friction
// a pile swings in a bowl as one, like a pendulum.
void ExpectRest(CRandomPile& pile) {
  if (pile.m_eRoom == eRoom::Bowl) return;
  for (int step = 0; step < 300; ++step)
    pile.Step(g_nSteps + step);
  EXPECT_LT(GetFastest(*pile.m_pWorld), 2 * g_fGravity * g_fDt);
  EXPECT_LE(GetOverlap(*pile.m_pWorld), g_fSleepOverlap * 1.01); // measured in floats
}

TEST(RandomPiles, LoseNoBallGainNoEnergyAndComeToRest) {
  const std::uint64_t piles = HowMany("SHAPES_PILES", 15);
  // A step of the first five once gave up to 1.2e-2, the others slept with overlaps of up to .0058.
  std::vector<std::uint64_t> seeds = {356, 867, 1168, 1422, 1559, 26, 281, 1526, 1361, 3446};
  for (std::uint64_t seed = 0; seed < piles; ++seed)
    seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    SCOPED_TRACE(seed);
    CRandomPile pile(seed, g_cAutomatic);
    const CResult result = PlayPile(pile);
    EXPECT_EQ(result.m_nLost, 0);
    EXPECT_LT(result.m_fGain, 5e-4);
    ExpectRest(pile);
  }
}

TEST(RandomPiles, LoseBallsAndGainEnergyInTheApproximateMode) { // the control
  CResult worst;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    CRandomPile pile(seed, g_cApproximate);
    const CResult result = PlayPile(pile);
    worst.m_nLost = std::max(worst.m_nLost, result.m_nLost);
    worst.m_fGain = std::max(worst.m_fGain, result.m_fGain);
  }
  EXPECT_GT(worst.m_nLost, 0);
  EXPECT_GT(worst.m_fGain, 5e-4);
}

} // namespace
} // namespace Shapes
