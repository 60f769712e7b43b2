// SPDX-License-Identifier: MIT
// The solver of resting contacts by itself, where impulses are known.
#include "../../src/native/continuous/ContactSolver.h"

#include "../../src/Tolerances.h"
#include "../Testing.h"

#include <limits>
#include <numbers>

namespace Shapes::Native {
namespace {

constexpr double g_fUnlimited = std::numeric_limits<double>::infinity();

// n balls of mass 1 on each other on a floor, each with the speed that gravity has given it; the impulses
// that stop them are the weights above them; the search begins with these times `known`. Returns the largest
// error of an impulse, as a share of the lowest.
double SolveTower(int n, double known, std::size_t rounds = g_nRestingRounds) {
  const double speed = 1.0 / 6.0;
  CContactSolver solver;
  solver.Begin();
  std::uint32_t below = CContactSolver::g_nShape;
  for (int i = 0; i < n; ++i) {
    const std::uint32_t ball = solver.AddBall(Vector2d(0, -speed));
    const double other = i == 0 ? 0.0 : 1.0;
    solver.Add({Vector2d::UnitY(), ball, below, 1.0, other, 0.0}, known * speed * (n - i));
    below = ball;
  }
  solver.Separate(g_fRestingError * 2.0 * speed, g_fUnlimited, rounds);
  double error = 0.0;
  for (int i = 0; i < n; ++i)
    error = std::max(error, std::abs(solver.GetImpulse(static_cast<std::size_t>(i)) - speed * (n - i)));
  return error / (speed * n);
}

TEST(ContactSolver, ATowerPressesWithItsWeight) {
  EXPECT_LT(SolveTower(10, 0.0), 1e-2);
  EXPECT_LT(SolveTower(100, 0.0), 0.1); // .78 without momentum
}

// Momentum that is not given up where it goes too far leaves an error of .076.
TEST(ContactSolver, ASmallTowerNeedsFewRounds) { EXPECT_LT(SolveTower(10, 0.0, 36), 0.01); }

TEST(ContactSolver, KnownImpulsesStay) { EXPECT_LT(SolveTower(400, 1.0), 1e-12); }

TEST(ContactSolver, ImpulsesThatAreTooLargeAreTakenAway) { EXPECT_LT(SolveTower(10, 2.0), 1e-2); }

// A wall comes at 3 upon a row of balls of mass 1 that touch; behind the last one is another wall, which it
// may approach at `room`.
struct CPushedRow {
  static constexpr double g_fWall = 3.0;
  std::vector<double> m_stdSpeeds, m_stdImpulses;

  CPushedRow(int n, double room, double known = 0.0) {
    CContactSolver solver;
    solver.Begin();
    std::vector<std::uint32_t> balls = {solver.AddBall(Vector2d::Zero())};
    while (std::ssize(balls) < n) {
      const std::uint32_t last = balls.back();
      balls.push_back(solver.AddBall(Vector2d::Zero()));
      solver.Add({-Vector2d::UnitX(), last, balls.back(), 1.0, 1.0, 0.0}, known);
    }
    solver.Add({-Vector2d::UnitX(), balls.back(), CContactSolver::g_nShape, 1.0, 0.0, -room}, known);
    solver.Add({Vector2d::UnitX(), balls[0], CContactSolver::g_nPushingShape, 1.0, 0.0, g_fWall}, known);
    solver.Solve(0.1, g_fWall);
    for (const std::uint32_t ball : balls)
      m_stdSpeeds.push_back(solver.GetVel(ball).x());
    for (std::size_t k = 0; k < balls.size() + 1; ++k)
      m_stdImpulses.push_back(solver.GetImpulse(k));
  }
};

// Impulses grow as long as it searches: after all rounds they would be 1,100 to 11,600.
TEST(ContactSolver, ASearchEndsWhereThereIsNoRoom) {
  for (const int n : {2, 10, 20}) {
    SCOPED_TRACE(n);
    const CPushedRow row(n, 0.0);
    for (const double impulse : row.m_stdImpulses)
      EXPECT_LT(impulse, 60.0);
    for (const double speed : row.m_stdSpeeds)
      EXPECT_LE(std::abs(speed), CPushedRow::g_fWall);
  }
}

// It is not taken for impossible while the impulses still grow, or shrink.
TEST(ContactSolver, ASearchGoesOnWhereThereIsRoom) {
  for (const int n : {2, 10, 40})
    for (const double known : {0.0, 300.0}) {
      SCOPED_TRACE(testing::Message() << n << " balls, known " << known);
      const CPushedRow row(n, 2.0 * CPushedRow::g_fWall, known);
      for (const double speed : row.m_stdSpeeds)
        EXPECT_NEAR(speed, CPushedRow::g_fWall, 0.1);
    }
}

// In a corner, into which a third shape comes. Eight rounds between two walls of 45 degrees leave 2^-8 of the
// speed, between two of 10 degrees .8: these are held by what comes after them.
TEST(ContactSolver, NoShapeThatComesPressesABallIntoThoseThatDoNot) {
  for (const double degrees : {45.0, 10.0, 1.0})
    for (const double gap : {0.0, 0.1}) {
      SCOPED_TRACE(testing::Message() << degrees << " degrees, gap " << gap);
      CContactSolver solver;
      solver.Begin();
      const std::uint32_t ball = solver.AddBall(Vector2d(0, 0));
      const double angle = degrees * std::numbers::pi / 180.0;
      const Vector2d left(1, 0), right(-std::cos(angle), std::sin(angle)), above(0.1, -1);
      solver.Add({left, ball, CContactSolver::g_nShape, 1.0, 0.0, -gap}, 0.0);
      solver.Add({right, ball, CContactSolver::g_nShape, 1.0, 0.0, -gap}, 0.0);
      solver.Add({above.normalized(), ball, CContactSolver::g_nPushingShape, 1.0, 0.0, 10.0}, 0.0);
      solver.Solve(0.1, 10.0);
      const Vector2d v = solver.GetVel(ball);
      const double rounding = static_cast<double>(g_fTouchRounding) * v.norm();
      EXPECT_NEAR(std::min(v.dot(left), v.dot(right)), -gap, rounding);
    }
}

// A ball that has to get out of one side of a narrow wedge is not kept in its place by the other.
TEST(ContactSolver, ABallThatIsInOneSideOfAWedgeDoesNotStay) {
  const Vector2d left(1, 0), right = Vector2d(-1, 0.1).normalized(), above(0.1, -1);
  for (const bool leftIsFirst : {true, false}) {
    CContactSolver solver;
    solver.Begin();
    const std::uint32_t ball = solver.AddBall(Vector2d(0, 0));
    if (leftIsFirst) solver.Add({left, ball, CContactSolver::g_nShape, 1.0, 0.0, 1.0}, 0.0);
    solver.Add({right, ball, CContactSolver::g_nShape, 1.0, 0.0, 0.0}, 0.0);
    if (!leftIsFirst) solver.Add({left, ball, CContactSolver::g_nShape, 1.0, 0.0, 1.0}, 0.0);
    solver.Add({above.normalized(), ball, CContactSolver::g_nPushingShape, 1.0, 0.0, 10.0}, 0.0);
    solver.Separate(1e-3, g_fUnlimited, 64);
    EXPECT_GT(solver.GetVel(ball).norm(), 0.5);
  }
}

// A crystal between two walls, each ball on two of the row below and beside two of its own: more contacts
// than velocities, so that impulses are not unique. All have the speed 1/6 that gravity has given them, and
// up to as much as `noise` in any direction.
struct CCrystal {
  static constexpr double g_fSpeed = 1.0 / 6.0;
  struct CPair {
    Vector2d m_vNorm;
    std::uint32_t m_nBall, m_nOther;
  };
  CContactSolver m_cSolver;
  std::vector<CPair> m_stdPairs;
  std::uint32_t m_nBalls = 0;

  CCrystal(std::uint32_t columns, std::uint32_t rows, double noise) {
    CRandom random(1);
    m_cSolver.Begin();
    for (std::uint32_t row = 0; row < rows; ++row) {
      const std::uint32_t size = columns - row % 2, first = m_nBalls + CContactSolver::g_nPushingShape + 1,
                          below = first - (columns - 1 + row % 2);
      for (std::uint32_t i = 0; i < size; ++i) {
        const Vector2d v = noise * random.InSquare(1).cast<double>() - g_fSpeed * Vector2d::UnitY();
        EXPECT_EQ(m_cSolver.AddBall(v), first + i);
      }
      m_nBalls += size;
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t left = below + i - 1 + row % 2, right = left + 1;
        const bool isAtWall = row % 2 == 0 && (i == 0 || i + 1 == size);
        if (row == 0) Add(Vector2d::UnitY(), first + i, CContactSolver::g_nShape);
        if (row > 0 && !(isAtWall && i == 0)) Add({0.5, std::sqrt(0.75)}, first + i, left);
        if (row > 0 && !(isAtWall && i > 0)) Add({-0.5, std::sqrt(0.75)}, first + i, right);
        if (isAtWall) Add({i == 0 ? 1.0 : -1.0, 0.0}, first + i, CContactSolver::g_nShape);
        if (i > 0) Add(Vector2d::UnitX(), first + i, first + i - 1);
      }
    }
    m_cSolver.Solve(2.0 * g_fSpeed, 0.0);
  }

  void Add(const Vector2d& norm, std::uint32_t ball, std::uint32_t other) {
    m_cSolver.Add({norm, ball, other, 1.0, other == CContactSolver::g_nShape ? 0.0 : 1.0, 0.0}, 0.0);
    m_stdPairs.push_back({norm, ball, other});
  }
  // At which any two approach.
  double GetApproach() const {
    double most = 0.0;
    for (const CPair& p : m_stdPairs)
      most = std::max(most, -p.m_vNorm.dot(m_cSolver.GetVel(p.m_nBall) - m_cSolver.GetVel(p.m_nOther)));
    return most;
  }
  // On the floor, as a share of the weight.
  double GetLoad() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < m_stdPairs.size(); ++k)
      if (m_stdPairs[k].m_nOther == CContactSolver::g_nShape && m_stdPairs[k].m_vNorm.y() == 1.0)
        sum += m_cSolver.GetImpulse(k);
    return sum / (g_fSpeed * m_nBalls);
  }
};

// Rounds that give a contact all that it lacks diverge together with momentum: with g_fRelaxation = .9 in
// crystals of 80 rows, with 1 in those of 40, where the load becomes 10^5.
TEST(ContactSolver, ACrystalComesToAnEnd) {
  for (const std::uint32_t columns : {12u, 30u, 60u})
    for (const std::uint32_t rows : {5u, 40u, 120u})
      for (const double noise : {0.0, CCrystal::g_fSpeed}) {
        SCOPED_TRACE(testing::Message() << columns << " columns, " << rows << " rows, noise " << noise);
        const CCrystal crystal(columns, rows, noise);
        const double fastest = std::sqrt(2.0) * noise,
                     accurate = std::max(g_fRestingError * 2.0 * CCrystal::g_fSpeed, g_fFlowError * fastest);
        // A ball has six neighbours, and the last change of each contact also moves those beside it.
        EXPECT_LT(crystal.GetApproach(), 6.0 * accurate);
        if (rows < 120) {
          EXPECT_NEAR(crystal.GetLoad(), 1.0, 0.1);
        }
      }
}

// 200 balls of radius .2 that fall onto a floor between walls where there is room for 20. If momentum goes
// on, three of 300 find impulses of 10^7 weights.
TEST(ContactSolver, BallsInOnePlacePressNoMoreThanTheirWeight) {
  const double speed = CCrystal::g_fSpeed;
  for (const std::uint64_t seed : {1u, 32u, 103u, 192u}) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    std::vector<Vector2d> places;
    for (int i = 0; i < 200; ++i)
      places.push_back({random.Uniform(-0.5f, 0.5f), random.Uniform(0.0f, 2.5f)});
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
    CContactSolver solver;
    solver.Begin();
    std::vector<std::uint32_t> balls;
    for (std::size_t i = 0; i < places.size(); ++i)
      balls.push_back(solver.AddBall(Vector2d(0, -speed) + speed * random.InSquare(1).cast<double>()));
    std::size_t rows = 0;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      const Vector2d& p = places[i];
      const auto add = [&](const Vector2d& norm, std::uint32_t other, double mass) {
        solver.Add({norm, balls[i], other, 1.0, mass, 0.0}, 0.0);
        ++rows;
      };
      if (p.y() < 0.2) add(Vector2d::UnitY(), CContactSolver::g_nShape, 0.0);
      if (p.x() < -0.3) add(Vector2d::UnitX(), CContactSolver::g_nShape, 0.0);
      if (p.x() > 0.3) add(-Vector2d::UnitX(), CContactSolver::g_nShape, 0.0);
      for (std::uint32_t j = 0; j < i; ++j)
        if (const Vector2d d = p - places[j]; d.norm() < 0.4) add(d.normalized(), balls[j], 1.0);
    }
    solver.Solve(2.0 * speed, 0.0);
    for (std::size_t k = 0; k < rows; ++k)
      ASSERT_LT(solver.GetImpulse(k), speed * static_cast<double>(places.size()));
  }
}

// Rows that are solved two at once have the bits of those that are solved one after the other.
TEST(ContactSolver, ARoundGoesThroughItsRowsInTheirOrder) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    CContactSolver solver;
    solver.Begin();
    std::vector<Vector2d> vels(CContactSolver::g_nPushingShape + 1, Vector2d::Zero());
    for (std::uint32_t i = 0, n = 2 + random.Below(20); i < n; ++i) {
      vels.push_back(random.InSquare(1).cast<double>());
      EXPECT_EQ(solver.AddBall(vels.back()), vels.size() - 1);
    }
    const auto balls = static_cast<std::uint32_t>(vels.size());
    std::vector<CContactSolver::CRow> rows(1 + random.Below(60));
    std::vector<double> impulses;
    for (CContactSolver::CRow& row : rows) {
      row.m_nBall = CContactSolver::g_nPushingShape + 1 + random.Below(balls - 2);
      do
        row.m_nOther = random.Below(balls);
      while (row.m_nOther == row.m_nBall);
      row.m_vNorm = random.InSquare(1).cast<double>().normalized();
      row.m_fInverse = random.Uniform(0.1f, 10.0f);
      row.m_fOtherInverse =
          row.m_nOther > CContactSolver::g_nPushingShape ? random.Uniform(0.1f, 10.0f) : 0.0;
      row.m_fLeast = random.Uniform(-1.0f, 1.0f);
      impulses.push_back(random.Uniform(0.0f, 0.1f));
      solver.Add(row, impulses.back());
    }
    solver.Separate(0.0, g_fUnlimited, 1);

    for (std::size_t k = 0; k < rows.size(); ++k) {
      vels[rows[k].m_nBall] += impulses[k] * rows[k].m_fInverse * rows[k].m_vNorm;
      vels[rows[k].m_nOther] -= impulses[k] * rows[k].m_fOtherInverse * rows[k].m_vNorm;
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const CContactSolver::CRow& row = rows[k];
      const double inverse = row.m_fInverse + row.m_fOtherInverse;
      const double has = Vector2d(row.m_vNorm / inverse).dot(vels[row.m_nBall] - vels[row.m_nOther]);
      const double more = std::max(row.m_fLeast / inverse - has, -impulses[k]), next = impulses[k] + more;
      vels[row.m_nBall] += more * Vector2d(row.m_fInverse * row.m_vNorm);
      vels[row.m_nOther] -= more * Vector2d(row.m_fOtherInverse * row.m_vNorm);
      ASSERT_EQ(solver.GetImpulse(k), next) << "row " << k;
    }
  }
}

// Two that overlap part by as much and by their masses; so do those that are pushed on.
TEST(ContactSolver, WhatOverlapsPartsByMass) {
  CContactSolver solver;
  solver.Begin();
  const std::uint32_t light = solver.AddBall({0, 0}), heavy = solver.AddBall({0, 0}),
                      free = solver.AddBall({0, 0});
  solver.Add({Vector2d::UnitX(), heavy, light, 1.0 / 3.0, 1.0, 4.0}, 0.0);
  solver.Add({Vector2d::UnitX(), free, heavy, 1.0, 1.0 / 3.0, -2.0}, 0.0);
  solver.Separate(1e-9, g_fUnlimited, 100);
  EXPECT_NEAR(solver.GetVel(light).x(), -3.0, 1e-8);
  EXPECT_NEAR(solver.GetVel(heavy).x(), 1.0, 1e-8);
  EXPECT_EQ(solver.GetVel(free).x(), 0.0); // it is 2 away
}

} // namespace
} // namespace Shapes::Native
