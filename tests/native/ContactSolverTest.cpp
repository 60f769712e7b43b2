// SPDX-License-Identifier: MIT
// The solver of resting contacts by itself, where impulses are known.
#include "../../src/native/continuous/ContactSolver.h"

#include <gtest/gtest.h>

namespace Shapes::Native {
namespace {

// n balls of mass 1 on each other on a floor, each with the speed that gravity has given it; the impulses
// that stop them are the weights above them. Returns the largest error of an impulse, as a share of the
// lowest.
double SolveTower(int n, bool known) {
  const double speed = 1.0 / 6.0;
  CContactSolver solver;
  solver.Begin();
  std::uint32_t below = CContactSolver::g_nShape;
  for (int i = 0; i < n; ++i) {
    const std::uint32_t ball = solver.AddBall(Vector2d(0, -speed));
    const double other = i == 0 ? 0.0 : 1.0;
    solver.Add({Vector2d::UnitY(), ball, below, 1.0, other, 1.0 / (1.0 + other), 0.0},
               known ? speed * (n - i) : 0.0);
    below = ball;
  }
  solver.Solve(2.0 * speed, 0.0);
  double error = 0.0;
  for (int i = 0; i < n; ++i)
    error = std::max(error, std::abs(solver.GetImpulse(static_cast<std::size_t>(i)) - speed * (n - i)));
  return error / (speed * n);
}

TEST(ContactSolver, ATowerPressesWithItsWeight) {
  EXPECT_LT(SolveTower(10, false), 1e-2);
  EXPECT_LT(SolveTower(100, false), 0.05); // .78 where the search keeps no direction
}

TEST(ContactSolver, KnownImpulsesStay) { EXPECT_LT(SolveTower(400, true), 1e-12); }

} // namespace
} // namespace Shapes::Native
