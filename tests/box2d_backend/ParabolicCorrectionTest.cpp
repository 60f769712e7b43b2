// SPDX-License-Identifier: MIT
// How gravity bends the way of a ball within one step of Box2D, against exact parabolas in double. Straight
// ways are moved by the test as Box2D moves them; only where a ball is in the end goes through its floats.
#include "box2d_backend/contact/ParabolicCorrection.h"

#include "ImportTesting.h"

namespace Shapes::Tests {
namespace {

using Box2D::CParabolicCorrection;

constexpr std::uint64_t g_nFlightSeed = 65;
constexpr double g_fSlack = 2;
// How far from its parabola a ball lands after a bounce on tuned Box2D, as a share of its move in a step, and
// the error of its velocity as a share of that: what is left of the time of impact where the ball meets the
// surface at least twice as fast as gravity makes it in a step. Rounding to the floats of Box2D is added.
constexpr double g_fParabolaError = 1e-6;

b2Vec2 ToFloat(const Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }
Vector2d ToDouble(const b2Vec2& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// Where a surface is, as the centre of a ball meets it, and the impact there.
struct CSurface {
  Vector2d m_vPos, m_vNorm;
  double m_fElasticity;
};

/// The exact way: one parabola after another.
struct CParabola {
  Vector2d m_vPos, m_vVel, m_vGravity;

  void Move(double t) {
    m_vPos += t * m_vVel + 0.5 * t * t * m_vGravity;
    m_vVel += t * m_vGravity;
  }
  void Bounce(const CSurface& s) { m_vVel = Mirrored(m_vVel, s.m_vNorm, s.m_fElasticity); }
};

/// A ball in one step of a world without gravity, as the tuned world moves it.
class CStep {
public:
  CStep(const Vector2d& p, const Vector2d& v, const Vector2d& g, double h)
      : m_vPos(p), m_vVel(v + 0.5 * h * g), m_fStep(h) {
    m_cCorrection.Begin(g, h);
  }

  /// Box2D stops the ball `early` seconds before its straight way meets the surface, but not before what was
  /// before, or after the step.
  CParabolicCorrection::CImpact MoveTo(const Vector2d& p, const Vector2d& n, double e, double early) {
    const double wn = m_vVel.dot(n), meets = m_fNow + (p - m_vPos).dot(n) / wn;
    MoveTo(std::clamp(meets - early, m_fNow, m_fStep));
    return {m_fNow / m_fStep, meets - m_fNow, n, wn, e};
  }
  void MoveTo(double t) {
    m_vPos += (t - m_fNow) * m_vVel;
    m_fNow = t;
  }
  /// @return the approach speed
  double Bounce(const CSurface& s, double early) {
    const auto impact = MoveTo(s.m_vPos, s.m_vNorm, s.m_fElasticity, early);
    const double speed = CParabolicCorrection::Bounce(impact, m_cCorrection, 1, nullptr);
    m_vVel = Mirrored(m_vVel, s.m_vNorm, s.m_fElasticity);
    return speed;
  }
  void Land() {
    MoveTo(m_fStep);
    CGame game;
    b2Body& body = *game.AddBody(b2_dynamicBody);
    body.SetTransform(ToFloat(m_vPos), 0);
    body.SetLinearVelocity(ToFloat(m_vVel));
    m_cCorrection.Land(body);
    m_vPos = ToDouble(body.GetPosition());
    m_vVel = ToDouble(body.GetLinearVelocity());
  }

  Vector2d m_vPos, m_vVel;
  double m_fNow = 0;
  double m_fStep;
  CParabolicCorrection m_cCorrection;
};

/// The documented error of where a ball lands and of its velocity, of the way that the fastest of its
/// straight legs makes in a step, or of its speed; and the rounding of both to float.
void ExpectLanded(const CStep& step, const CParabola& exact, double fastest) {
  EXPECT_LE((step.m_vPos - exact.m_vPos).norm(),
            g_fSlack * (g_fParabolaError * fastest * step.m_fStep + 2 * g_fUlp * exact.m_vPos.norm()));
  EXPECT_LE((step.m_vVel - exact.m_vVel).norm(), g_fSlack * (g_fParabolaError + 2 * g_fUlp) * fastest);
}

/// A ball that meets a surface at this part of a step, at least twice as fast as gravity makes it in one.
struct CCase {
  /// @param slowest  speed, in units of what makes such surfaces possible
  explicit CCase(CRandom& random, float slowest = 3) {
    m_fStep = random.Coin() ? 1.0 / 60 : 1.0 / 240;
    m_vGravity = Wide(random.VectorOfLength(1, 50));
    m_vPos = Wide(random.VectorOfLength(0, 1));
    const auto least = static_cast<float>(2 * m_fStep * m_vGravity.norm());
    const float most = random.Scale(2, 6) * least;
    m_vVel = Wide(random.VectorOfLength(slowest * least, most));
  }
  /// A surface where the parabola is, which it meets with at least that speed.
  CSurface SurfaceAt(CRandom& random, const CParabola& ball) const {
    const double least = 2 * m_fStep * m_vGravity.norm(), e = random.Below(3) == 0 ? 1 : 1.2 * random.Unit();
    for (;;) {
      const Vector2d n = random.Direction().cast<double>();
      if (ball.m_vVel.dot(n) < -least) return {ball.m_vPos, n, e};
    }
  }

  CParabola Parabola() const { return {m_vPos, m_vVel, m_vGravity}; }
  CStep Step() const { return {m_vPos, m_vVel, m_vGravity, m_fStep}; }

  double m_fStep;
  Vector2d m_vGravity, m_vPos, m_vVel;
};

TEST(FlightTest, AFreeBallIsOnItsParabolaAtAnyTimeAndLandsOnIt) {
  ForEachCase(g_nFlightSeed, 1000, [&](CRandom& random, int) {
    const CCase c(random);
    const double part = random.Unit();
    CParabola exact = c.Parabola();
    CStep step = c.Step();
    exact.Move(part * c.m_fStep);
    step.MoveTo(part * c.m_fStep);
    Vector2d dp, dv;
    step.m_cCorrection.GetDeviation(part, dp, dv);
    EXPECT_LE((step.m_vPos + dp - exact.m_vPos).norm(), 1e-14 * (1 + exact.m_vPos.norm()));
    EXPECT_LE((step.m_vVel + dv - exact.m_vVel).norm(), 1e-14 * (1 + exact.m_vVel.norm()));
    EXPECT_GT(dv.norm(), 0);
    exact.Move((1 - part) * c.m_fStep);
    step.Land();
    ExpectLanded(step, exact, exact.m_vVel.norm() + c.m_vVel.norm());
  });
}

TEST(FlightTest, ABallThatBouncesOnceOrTwiceLandsOnItsParabola) {
  double worst = 0, without = 0;
  for (const int bounces : {1, 2})
    ForEachCase(g_nFlightSeed, 5000, [&](CRandom& random, int) {
      const CCase c(random, bounces == 1 ? 1.6f : 3);
      const double fastest = (bounces == 1 ? 1.5 : 4) * c.m_vVel.norm();
      CParabola exact = c.Parabola();
      CStep step = c.Step();
      double at = 0;
      for (int left = bounces; left > 0; --left) {
        const double until = random.Unit() * c.m_fStep / bounces;
        at += until;
        exact.Move(until);
        CSurface surface = c.SurfaceAt(random, exact);
        if (left > 1) surface.m_fElasticity = 1; // it stays fast
        const double early = bounces == 1 && random.Coin() ? 0.2 * random.Unit() * c.m_fStep : 0;
        EXPECT_NEAR(step.Bounce(surface, early), -exact.m_vVel.dot(surface.m_vNorm),
                    g_fSlack * g_fParabolaError * fastest);
        exact.Bounce(surface);
      }
      exact.Move(c.m_fStep - at);
      step.MoveTo(c.m_fStep);
      const Vector2d kicked = step.m_vVel + 0.5 * c.m_fStep * c.m_vGravity;
      without = std::max(without, (kicked - exact.m_vVel).norm() / fastest);
      Vector2d dp, dv;
      step.m_cCorrection.GetDeviation(1, dp, dv);
      worst = std::max({worst, (step.m_vPos + dp - exact.m_vPos).norm() / (fastest * c.m_fStep),
                        (step.m_vVel + dv - exact.m_vVel).norm() / fastest});
      step.Land();
      ExpectLanded(step, exact, fastest);
    });
  EXPECT_LE(worst, g_fParabolaError); // measured: 2.6e-7
  EXPECT_GT(without, 0.01);           // the control: the other half of the kick alone
}

TEST(FlightTest, TwoBallsBounceByTheirMasses) {
  ForEachCase(g_nFlightSeed, 5000, [&](CRandom& random, int) {
    const CCase c(random);
    const double h = c.m_fStep, m0 = random.Scale(-5, 5), m1 = random.Scale(-5, 5), e = random.Unit();
    const double at0 = 0.5 * random.Unit() * h, at1 = at0 + 0.5 * random.Unit() * h;
    // One of them bounces off a surface first: two parabolas of one gravity would meet as straight ways do.
    CParabola exact0 = c.Parabola();
    exact0.Move(at0);
    const CSurface surface = c.SurfaceAt(random, exact0);
    CStep step0 = c.Step();
    step0.Bounce(surface, 0);
    exact0.Bounce(surface);
    exact0.Move(at1 - at0);
    // The other one is where they meet then, back in time.
    CParabola exact1{exact0.m_vPos, {0, 0}, c.m_vGravity};
    const Vector2d n = random.Direction().cast<double>(); // from it to the first
    exact1.m_vVel = exact0.m_vVel + (4 * h * c.m_vGravity.norm() + c.m_vVel.norm() * random.Unit()) * n;
    CParabola start = exact1;
    start.Move(-at1);
    CStep step1(start.m_vPos, start.m_vVel, c.m_vGravity, h);

    // The straight ways meet along n.
    step1.MoveTo(step0.m_fNow);
    const double wn = (step0.m_vVel - step1.m_vVel).dot(n);
    const double meets = step0.m_fNow + (step1.m_vPos - step0.m_vPos).dot(n) / wn;
    const double stop = std::clamp(meets, step0.m_fNow, h);
    step0.MoveTo(stop), step1.MoveTo(stop);
    const double share = m1 / (m0 + m1);
    CParabolicCorrection::Bounce({stop / h, meets - stop, n, wn, e}, step0.m_cCorrection, share,
                                 &step1.m_cCorrection);
    const auto bounce = [&](auto& first, auto& second) {
      const Vector2d w = (1 + e) * (first.m_vVel - second.m_vVel).dot(n) * n;
      first.m_vVel -= share * w;
      second.m_vVel += (1 - share) * w;
    };
    bounce(step0, step1);
    bounce(exact0, exact1);
    const double fastest = 4 * (c.m_vVel.norm() + start.m_vVel.norm());
    for (auto [pStep, pExact] : {std::pair(&step0, &exact0), std::pair(&step1, &exact1)}) {
      pExact->Move(h - at1);
      pStep->Land();
      ExpectLanded(*pStep, *pExact, fastest);
    }
  });
}

TEST(FlightTest, WhatLiesIsNotPressedIntoWhatItLiesOn) {
  const Vector2d g(0, -10), n = Vector2d(1, 3).normalized();
  const double h = 1.0 / 60;
  CStep step({0, 0}, {0, 0}, g, h);
  step.m_vVel -= step.m_vVel.dot(n) * n; // Box2D has stopped it
  CStep without = step;
  step.m_cCorrection.Rest(n);
  step.Land();
  EXPECT_LE((step.m_vVel - h * (g - g.dot(n) * n)).norm(), 2 * g_fUlp); // it slides as a ball on a slope does
  without.Land();
  EXPECT_LT(without.m_vVel.dot(n), -0.05); // the control
}

/// The largest relative change of the energy in 10,000 steps of 1/60 s with a bounce in about a third of
/// them.
/// @param isFollowed  whether the deviation is followed through the bounces
double Drift(bool isFollowed) {
  CRandom random(g_nFlightSeed);
  const Vector2d g(0, -10);
  const double h = 1.0 / 60;
  const auto energy = [&](const Vector2d& p, const Vector2d& v) { return 0.5 * v.squaredNorm() - g.dot(p); };
  Vector2d p(0, 0), v(3, 8);
  const double first = energy(p, v);
  double most = 0;
  for (int i = 0; i < 10000; ++i) {
    p.x() = 0; // the same everywhere
    CStep step(p, v, g, h);
    CParabola ball{p, v, g};
    ball.Move(random.Unit() * h);
    const Vector2d n = UnitVector(std::numbers::pi * (0.5 + 0.3 * (2 * random.Unit() - 1)));
    if (ball.m_vVel.y() < 0 && ball.m_vVel.dot(n) < -1) {
      const CSurface surface{ball.m_vPos, n, 1};
      if (isFollowed) {
        step.Bounce(surface, 0);
      } else {
        step.MoveTo(surface.m_vPos, n, 1, 0);
        step.m_vVel = Mirrored(step.m_vVel, n);
      }
    }
    step.Land();
    p = step.m_vPos, v = step.m_vVel;
    most = std::max(most, std::abs(energy(p, v) / first - 1));
  }
  return most;
}

TEST(FlightTest, BouncesKeepTheEnergy) {
  // Rounding to float, of which the energy has a few ulp in each step, at random: 1e-7 * sqrt(10000).
  EXPECT_LE(Drift(true), 2e-5);
  EXPECT_GT(Drift(false), 0.01); // the control
}

class CFlightPartTest : public testing::Test {
protected:
  CFlightPartTest() {
    m_pBody->SetLinearVelocity({3, 4});
    m_cCorrection.Begin({0, -10}, 0.5);
  }
  double PartAt(double part) {
    const float t = 0.5f * static_cast<float>(part);
    m_pBody->SetTransform({1 + t * 3, 1 + t * 4}, 0);
    return m_cCorrection.PartAt(*m_pBody, {1, 1});
  }

  CGame m_cGame;
  b2Body* m_pBody = m_cGame.AddBody(b2_dynamicBody);
  CParabolicCorrection m_cCorrection;
};

TEST_F(CFlightPartTest, IsTheShareOfTheWay) {
  for (const double part : {0.0, 0.25, 0.7, 1.0})
    EXPECT_NEAR(PartAt(part), part, 4 * g_fUlp);
  EXPECT_EQ(PartAt(-0.1), 0);
  EXPECT_EQ(PartAt(1.1), 1);
}

TEST_F(CFlightPartTest, IsTakenFromTheEndOfTheLegAfterABounce) {
  CParabolicCorrection::Bounce({0.5, 0, {-1, 0}, -3, 1}, m_cCorrection, 1, nullptr);
  PartAt(1); // puts it where it ends
  m_cCorrection.MotionEnds(*m_pBody);
  EXPECT_NEAR(PartAt(0.75), 0.75, 4 * g_fUlp);
  EXPECT_NEAR(PartAt(0.2), 0.2, 4 * g_fUlp); // Box2D may come to the next one before the parabola bounces
}

TEST_F(CFlightPartTest, IsInTheStepThoughTheParabolaMeetsAfterIt) {
  // The straight way meets the surface .2 of a step after the end of it, the parabola about then.
  CParabolicCorrection::Bounce({0.9, 0.15, {-1, 0}, -3, 1}, m_cCorrection, 1, nullptr);
  for (const double part : {0.5, 0.95})
    EXPECT_NEAR(PartAt(part), part, 4 * g_fUlp);
  EXPECT_EQ(PartAt(1.2), 1);
  m_pBody->SetLinearVelocity({0, 0});
  EXPECT_EQ(PartAt(0.5), 1);
}

} // namespace
} // namespace Shapes::Tests
