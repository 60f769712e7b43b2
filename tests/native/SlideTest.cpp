// SPDX-License-Identifier: MIT
// Balls that slide under gravity, held to a fine integration of their equation of motion.
#include "NativeTesting.h"

namespace Shapes {
namespace {

// A ball on a circle of radius L, at an angle from the top of it, which gravity turns away from there: of
// fourth order, in steps of 10 us.
struct COnCircle {
  double m_fAngle, m_fSpeed; // radians, radians per second
  double m_fTime = 0.0;
  static constexpr double g_fL = 0.5, g_fG = 10.0, g_fStep = 1e-5;

  template <class F>
  COnCircle& Until(const F& isOver) {
    const auto pull = [](double angle) { return g_fG / g_fL * std::sin(angle); };
    for (; !isOver(*this); m_fTime += g_fStep) {
      const double h = g_fStep, k1 = m_fSpeed, l1 = pull(m_fAngle);
      const double k2 = m_fSpeed + h / 2 * l1, l2 = pull(m_fAngle + h / 2 * k1);
      const double k3 = m_fSpeed + h / 2 * l2, l3 = pull(m_fAngle + h / 2 * k2);
      const double k4 = m_fSpeed + h * l3, l4 = pull(m_fAngle + h * k3);
      m_fAngle += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      m_fSpeed += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return *this;
  }
  bool IsPulled() const { return g_fL * m_fSpeed * m_fSpeed > g_fG * std::cos(m_fAngle); }
  Vector2d GetPos() const { return g_fL * Vector2d(std::sin(m_fAngle), std::cos(m_fAngle)); }
  Vector2d GetVel() const { return g_fL * m_fSpeed * Vector2d(std::cos(m_fAngle), -std::sin(m_fAngle)); }
};

// Steps until .3 s after the ball has left its circle and flies, and returns how far it is off then.
double GetErrorAfter(const COnCircle& left, CWorld& world, CShapeId ball) {
  const int steps = static_cast<int>((left.m_fTime + 0.3) * 60.0);
  Steps(world, steps);
  const double flown = steps * Wide(g_fDt) - left.m_fTime;
  const Vector2d fall(0.0, -COnCircle::g_fG * flown);
  const Vector2d pos = left.GetPos() + flown * (left.GetVel() + 0.5 * fall), vel = left.GetVel() + fall;
  return (Wide(world.GetPos(ball)) - pos).norm() + (Wide(world.GetVel(ball)) - vel).norm();
}

// Of a part of the way that turns by g_fSlideTurn the end is off by its fourth power / 24, in radii. Errors
// of the parts of half a circle add up, and grow as the angle from the top does.
constexpr double g_fBound = 4e-4;

// The pendulum: elliptic integral of the first kind by the arithmetic-geometric mean.
TEST(Slide, ABallSlidesInABowlAsAPendulum) {
  for (const double amplitude : {0.1, 0.5, 1.0, 1.5}) {
    const auto pWorld = MakeNative(g_cAutomatic, 10);
    pWorld->Add(CArcDesc({0, 0}, 1, 0, 0, 0.0f));
    const Vector2 start(0.8f * static_cast<float>(std::sin(amplitude)),
                        -0.8f * static_cast<float>(std::cos(amplitude)));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc(start, 0.2f));
    double a = 1.0, g = std::cos(0.5 * amplitude);
    for (int i = 0; i < 6; ++i) {
      const double mean = 0.5 * (a + g);
      g = std::sqrt(a * g);
      a = mean;
    }
    const double period = g_fPi2 * std::sqrt(0.8 / 10.0) / a;
    const auto energy = [&] { return EnergyOf(*pWorld, ball, 10, -0.8); };
    const double first = energy();
    int crossings = 0;
    double x = Wide(start.x()), lastCrossing = 0.0;
    InEachStep(*pWorld, 6000, [&](int step) {
      const double before = std::exchange(x, Wide(pWorld->GetPos(ball).x()));
      if ((before > 0.0) != (x > 0.0)) {
        ++crossings;
        lastCrossing = Wide(g_fDt) * (step + before / (before - x));
      }
      EXPECT_NEAR(pWorld->GetPos(ball).norm(), 0.8f, 1e-6f);
      EXPECT_NEAR(energy(), first, 2e-6 * (1.0 + first));
    });
    EXPECT_NEAR(lastCrossing / (0.5 * crossings - 0.25), period, 1e-5 * period) << amplitude;
    EXPECT_EQ(pWorld->GetStats().m_nBallsHalted, 0u);
  }
}

TEST(Slide, ABallLeavesACircleWhereItWouldBePulled) {
  for (const float v : {0.1f, 0.5f, 1.0f, 2.0f}) {
    const auto pWorld = MakeNative(g_cAutomatic, 10);
    pWorld->Add(CCircleDesc({0, 0}, 0.4f, 0.0f));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.1f, {v, 0}));
    COnCircle exact{0.0, Wide(v) / COnCircle::g_fL};
    exact.Until([](const COnCircle& at) { return at.IsPulled(); });
    EXPECT_NEAR(std::cos(exact.m_fAngle), (2.0 + 0.2 * Wide(v * v)) / 3.0, 1e-3) << v;
    EXPECT_LT(GetErrorAfter(exact, *pWorld, ball), g_fBound) << v;
  }
}

TEST(Slide, ABallLeavesABowlAtItsEnd) {
  for (const float end : {0.3f, 0.8f, 1.2f}) {
    const auto pWorld = MakeNative(g_cAutomatic, 10);
    // From beyond the left side of it to `end` radians right of the bottom.
    pWorld->Add(CArcDesc({0, 0}, 0.6f, 3.0f, 4.712389f + end, 0.0f));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.5f, 0}, 0.1f));
    const double bottom = 0.5 * g_fPi2;
    COnCircle exact{1.5 * bottom, 0.0};
    exact.Until([=](const COnCircle& at) { return at.m_fAngle < bottom - Wide(end); });
    EXPECT_LT(GetErrorAfter(exact, *pWorld, ball), g_fBound) << end;
  }
}

} // namespace
} // namespace Shapes
