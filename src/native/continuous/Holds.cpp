// SPDX-License-Identifier: MIT
#include "Holds.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <array>
#include <limits>

namespace Shapes::Native {
namespace {

using Geometry::Norm;

// Where n . p = b and m . p = c, times the determinant of n and m.
Vector2d GetCrossing(const Vector2d& n, double b, const Vector2d& m, double c) {
  return {b * m.y() - c * n.y(), c * n.x() - b * m.x()};
}

// By how much p, which was calculated from x, is on the wrong side of n . point = b, beyond rounding.
double GetExcess(const Vector2d& n, double b, const Vector2d& p, const Vector2d& x) {
  const double size = x.cwiseAbs().maxCoeff() + p.cwiseAbs().maxCoeff();
  const double excess = b - n.dot(p);
  return excess <= 16.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : excess;
}

// The point closest to x with n . point >= b for all: it is x, on one of the lines, or where two cross. What
// rounding violates is no violation. If there is none, the one that goes into shapes that do not push least,
// then into those that push, and then into balls.
template <class F>
Vector2d Closest(const Vector2d& x, std::span<const CHold> holds, const F& bound) {
  const auto getExcess = [&](const CHold& hold, const Vector2d& p) {
    return GetExcess(hold.m_vNorm, bound(hold), p, x);
  };
  if (holds.size() == 1) return x + getExcess(holds[0], x) * holds[0].m_vNorm;

  using CRank = std::array<double, 4>; // excess into each of these, and how far from x
  Vector2d best = x;
  CRank bestRank;
  bestRank.fill(std::numeric_limits<double>::infinity());
  const auto offer = [&](const Vector2d& p) {
    CRank rank{0.0, 0.0, 0.0, (p - x).squaredNorm()};
    for (const CHold& hold : holds) {
      double& excess = rank[hold.m_bIsBall ? 2 : hold.m_fSpeed > 0.0 ? 1 : 0];
      excess = std::max(excess, getExcess(hold, p));
    }
    if (rank < bestRank) best = p, bestRank = rank;
  };
  offer(x);
  if (std::max({bestRank[0], bestRank[1], bestRank[2]}) == 0.0) return x;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const Vector2d& n = holds[i].m_vNorm;
    offer(x + (bound(holds[i]) - n.dot(x)) * n);
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2d& m = holds[j].m_vNorm;
      const double det = Geometry::Cross(n, m), b = bound(holds[i]), c = bound(holds[j]);
      const Vector2d crossing = GetCrossing(n, b, m, c);
      const bool isOfBall = holds[i].m_bIsBall || holds[j].m_bIsBall;
      // Two walls that are all but parallel hold a ball between them, as in a slot, if they cross nearby.
      const double nearby = (std::abs(b) + std::abs(c) + Norm(x)) * std::abs(det);
      const bool isNearby = !isOfBall && det != 0.0 && Norm(crossing) <= nearby;
      if (isNearby || std::abs(det) >= (isOfBall ? g_fSteep : g_fParallel)) offer(crossing / det);
    }
  }
  return best;
}

} // namespace

bool CHolds::HasShape(std::uint32_t order) const {
  const auto holds = Get();
  return std::any_of(holds.begin(), holds.end(),
                     [=](const CHold& hold) { return !hold.m_bIsBall && hold.m_nOther == order; });
}

bool CHolds::HasBall(std::uint32_t ball, std::uint32_t version) const {
  const auto holds = Get();
  return std::any_of(holds.begin(), holds.end(), [=](const CHold& hold) {
    return hold.m_bIsBall && hold.m_nOther == ball && hold.m_nVersion == version;
  });
}

void CHolds::Add(const CHold& hold) {
  if (m_nSize == m_stdHolds.size()) std::shift_left(m_stdHolds.begin(), m_stdHolds.end(), 1), --m_nSize;
  m_stdHolds[m_nSize++] = hold;
}

Vector2d CHolds::ConstrainVel(const Vector2d& v) const {
  return Closest(v, Get(), [](const CHold& hold) { return hold.m_fSpeed; });
}

Vector2d CHolds::ConstrainAcc(const Vector2d& a) const {
  return Closest(a, Get(), [](const CHold& hold) { return hold.m_fAcc; });
}

Vector2d CHolds::KeepVel(const Vector2d& v) const {
  const auto holds = Get();
  const auto isOfBall = [](const CHold& hold) { return hold.m_bIsBall; };
  if (std::any_of(holds.begin(), holds.end(), isOfBall)) return v;
  const Vector2d& n = holds[0].m_vNorm;
  const double b = holds[0].m_fSpeed;
  for (const CHold& other : holds.subspan(1)) {
    const double det = Geometry::Cross(n, other.m_vNorm), c = other.m_fSpeed;
    const Vector2d crossing = GetCrossing(n, b, other.m_vNorm, c);
    const bool isNearby = Norm(crossing) <= (std::abs(b) + std::abs(c) + Norm(v)) * std::abs(det);
    if (std::abs(det) >= g_fParallel && isNearby) return crossing / det;
  }
  // Where another one leaves it no room there, the ball leaves the first.
  const Vector2d kept = v + (b - n.dot(v)) * n;
  const auto isIn = [&](const CHold& other) {
    return GetExcess(other.m_vNorm, other.m_fSpeed, kept, v) > 0.0;
  };
  return std::any_of(holds.begin() + 1, holds.end(), isIn) ? v : kept;
}

bool CHolds::DropPulling(const Vector2d& acc, const Vector2d& free) {
  return DropIf([&](const CHold& hold) {
    const double size = free.cwiseAbs().maxCoeff() + std::abs(hold.m_fAcc);
    return hold.m_vNorm.dot(acc) > hold.m_fAcc + 64.0 * std::numeric_limits<double>::epsilon() * size;
  });
}

} // namespace Shapes::Native
