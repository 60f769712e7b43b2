// SPDX-License-Identifier: MIT
// Balls that slide on circles under gravity, held to the exact reference.
#include "NativeTesting.h"

#include "reference/Reference.h"

namespace Shapes {
namespace {

/// A ball that begins to slide on shapes that have no elasticity, in a world and in the exact reference.
struct CSlide {
  std::unique_ptr<CWorld> m_pWorld = MakeNative(g_cAutomatic, 10);
  CShapeId m_nBall;
  Compare::CReference<double> m_cExact;
  double m_fHeight; // where it begins, and where its energy is only kinetic
  double m_fFirst;  // energy
  std::vector<Compare::CExactEvent<double>> m_stdEvents; // of all steps

  CSlide(const std::vector<CAnyShapeDesc>& shapes, const Vector2d& p, float r, const Vector2& v)
      : m_cExact(shapes, std::array{CDynamicCircleDesc({0, 0}, r)}, {0, -10}), m_fHeight(p.y()) {
    for (const CAnyShapeDesc& shape : shapes)
      m_pWorld->Add(shape);
    m_nBall = m_pWorld->Add(CDynamicCircleDesc(p.cast<float>(), r, v));
    m_cExact.SetBall(0, p, Wide(v));
    m_fFirst = GetEnergy();
  }
  double GetEnergy() const { return EnergyOf(*m_pWorld, m_nBall, 10, m_fHeight); }
  /// The world has made its step; how far it is off then, at most `most`, with energy kept.
  double ExpectExact(double most) {
    m_cExact.Step(Wide(g_fDt), m_stdEvents);
    const double off = (Wide(m_pWorld->GetPos(m_nBall)) - m_cExact.GetBall(0).m_vPos).norm();
    EXPECT_LT(off, most);
    EXPECT_NEAR(GetEnergy(), m_fFirst, 2e-6 * (1.0 + m_fFirst));
    return off;
  }
};

/// On a shape about the origin, until .3 s after it has left that, or for 100 s.
/// @param most  how far it may be off, and also its velocity after it has left
/// @returns steps for which it has flown
int ExpectExactWay(const CAnyShapeDesc& shape, const Vector2d& p, float r, const Vector2& v, double most) {
  CSlide slide({shape}, p, r, v);
  const CWorld& world = *slide.m_pWorld;
  int flown = 0;
  InEachStep(*slide.m_pWorld, 6000, [&](int) {
    if (flown == 18) return;
    const double off = slide.ExpectExact(most);
    EXPECT_TRUE(slide.m_stdEvents.empty());
    flown += slide.m_cExact.GetForce(0, 0) == 0.0;
    if (flown == 0) {
      EXPECT_NEAR(Wide(world.GetPos(slide.m_nBall).norm()), p.norm(), 1e-6);
    }
    if (flown == 18) {
      EXPECT_LT(off + (Wide(world.GetVel(slide.m_nBall)) - slide.m_cExact.GetBall(0).m_vVel).norm(), most);
    }
  });
  EXPECT_EQ(world.GetStats().m_nBallsHalted, 0u);
  return flown;
}

TEST(Slide, ABallSlidesInABowlAsAPendulum) {
  for (const double amplitude : {0.1, 0.5, 1.0, 1.5}) {
    SCOPED_TRACE(amplitude);
    const Vector2d start = 0.75 * Vector2d(std::sin(amplitude), -std::cos(amplitude));
    // A period is off by a millionth: where it is fastest the ball is late by so much of 100 s.
    const double fastest = std::sqrt(2.0 * 10.0 * (0.75 + start.y()));
    const CArcDesc bowl({0, 0}, 1, 0, 0, 0.0f);
    EXPECT_EQ(ExpectExactWay(bowl, start, 0.25f, {0, 0}, 1e-6 * 100.0 * fastest), 0);
  }
}

// Of a part of the way that turns by g_fSlideTurn the end is off by its fifth power, 3e-5, in radii of .5 at
// most. Errors of the parts add up, and grow as the angle from the top does, those of the velocity to 3e-5.
constexpr double g_fBound = 6e-5;

TEST(Slide, ABallLeavesACircleWhereItWouldBePulled) {
  for (const float v : {0.1f, 0.5f, 1.0f, 2.0f}) {
    SCOPED_TRACE(v);
    const CCircleDesc circle({0, 0}, 0.375f, 0.0f);
    EXPECT_EQ(ExpectExactWay(circle, {0, 0.5}, 0.125f, {v, 0}, g_fBound), 18);
  }
}

// From the level of its middle to `end` radians right of the bottom.
TEST(Slide, ABallLeavesABowlAtItsEnd) {
  const double length = Wide(0.6f) - Wide(0.1f);
  for (const float end : {0.3f, 0.8f, 1.2f}) {
    SCOPED_TRACE(end);
    const CArcDesc bowl({0, 0}, 0.6f, 3.0f, 4.712389f + end, 0.0f);
    EXPECT_EQ(ExpectExactWay(bowl, {-length, 0}, 0.1f, {0, 0}, g_fBound), 18);
  }
}

// It goes along with the bowl, which is all that a bowl in even motion changes.
TEST(Slide, InABowlThatMovesEvenlyABallSlidesAsInOneAtRest) {
  const Vector2 vel(3, 0.125f), start(0.45f, -0.6f);
  const auto pResting = MakeNative(g_cAutomatic, 10), pMoving = MakeNative(g_cAutomatic, 10);
  const auto bowl = Turning(CArcDesc({0, 0}, 1, 0, 0, 0.0f));
  pResting->Add(bowl);
  const CShapeId moving = pMoving->Add(bowl);
  pMoving->SetVel(moving, vel);
  const CShapeId a = pResting->Add(CDynamicCircleDesc(start, 0.25f, {0, 0}));
  const CShapeId b = pMoving->Add(CDynamicCircleDesc(start, 0.25f, vel));
  InEachStep(*pResting, 120, [&](int) {
    pMoving->Step();
    const Vector2 inBowl = pMoving->GetPos(b) - pMoving->GetPos(moving);
    EXPECT_LT((inBowl - pResting->GetPos(a)).norm(), 4 * 4.8e-7f); // roundings of places up to 8 units
  });
}

// Also about another point than its middle, held to steps of a 32nd. It is off by what the acceleration of
// the middle turns in a part of the way: at .05 turns a second .3 degrees a step.
TEST(Slide, ABallSlidesInABowlThatTurns) {
  for (const Vector2& center : {Vector2(0, 0), Vector2(0, 5), Vector2(3, 1)}) {
    const auto pWorld = MakeNative(g_cAutomatic, 10), pShort = MakeNative(g_cAutomatic, 10, g_fDt, 32);
    const CDynamicCircleDesc ball({-0.3f, -0.4f}, 0.1f);
    for (CWorld* pWith : {pWorld.get(), pShort.get()})
      pWith->Add(Turning(CArcDesc({0, 0}, 0.6f, 3, 6, 0.0f), 0.05f, center));
    const CShapeId a = pWorld->Add(ball), b = pShort->Add(ball);
    InEachStep(*pWorld, 60, [&](int) {
      pShort->Step();
      EXPECT_LT((pWorld->GetPos(a) - pShort->GetPos(b)).norm(), center.isZero() ? 1e-6f : 4e-4f);
    });
  }
}

// Between a level segment and a circle of radius 1 below its end, a quarter of one, or one above it.
TEST(Slide, ABallSlidesOverTheSeamOfACurveAndItsTangent) {
  const CAnyShapeDesc curves[] = {CCircleDesc({0, -1}, 1, 0.0f), CArcDesc({0, -1}, 1, 0, 0.5f * g_fPi, 0.0f),
                                  CArcDesc({0, 1}, 1, -0.5f * g_fPi, 0, 0.0f)};
  for (const int curve : {0, 1, 2})
    for (int k = 0; k < 20; ++k) {
      SCOPED_TRACE(testing::Message() << "curve " << curve << ", start " << k);
      const double sign = curve < 2 ? 1 : -1, R = 1 + sign * 0.125, angle = 0.35 + 0.001 * k;
      const Vector2d out(std::sin(angle), sign * std::cos(angle));
      CSlide to({CLineSegDesc({-5, 0}, {0, 0}, 0), curves[curve]}, {-0.2 + 0.001 * k, 0.125}, 0.125f, {1, 0});
      CSlide from({CLineSegDesc({-5, 0}, {0, 0}, 0), curves[curve]}, Vector2d(0, -sign) + R * out, 0.125f,
                  (-sign * 1.6 * Vector2d(out.y(), -out.x())).cast<float>());
      for (CSlide* pSlide : {&to, &from})
        InEachStep(*pSlide->m_pWorld, 24, [&](int) { pSlide->ExpectExact(5e-7); });
      EXPECT_GT(to.m_pWorld->GetPos(to.m_nBall).x(), 0.1f);
      EXPECT_LT(from.m_pWorld->GetPos(from.m_nBall).x(), -0.05f);
    }
}

} // namespace
} // namespace Shapes
