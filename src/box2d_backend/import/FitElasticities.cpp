// SPDX-License-Identifier: MIT
#include "FitElasticities.h"

#include "../../Tolerances.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace Shapes::Box2D {
namespace {

using CKinds = std::span<const CBounceKind>;
using CPairs = std::vector<CBouncePair>;

bool IsOfBalls(CKinds kinds, const CBouncePair& pair) {
  return kinds[pair.m_nFirst].m_bIsBall && kinds[pair.m_nSecond].m_bIsBall;
}

// Linear equations in levels: each level is solved in the sense of least squares, without touching what the
// levels before it have fixed.
class CLevels {
public:
  explicit CLevels(std::size_t unknowns)
      : m_stdSolution(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns))),
        m_stdFree(Eigen::MatrixXd::Identity(m_stdSolution.size(), m_stdSolution.size())) {}

  // Adds the level A x = c by its normal equations, of which the eigenvectors say both what the solution is
  // and what stays free.
  // @param square  A^T A, without which thousands of pairs would be a matrix each with all unknowns
  // @param right   A^T c
  void Solve(const Eigen::MatrixXd& square, const Eigen::VectorXd& right) {
    if (square.isZero(0.0) || m_stdFree.cols() == 0) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m_stdFree.transpose() * square * m_stdFree);
    const Eigen::VectorXd& lambda = eigen.eigenvalues(); // in increasing order
    const auto isFree = [&](double l) { return !(l > g_fFreeEigenvalue); };
    const Eigen::Index free = std::count_if(lambda.begin(), lambda.end(), isFree);
    const Eigen::Index fixed = lambda.size() - free;
    const Eigen::MatrixXd V = eigen.eigenvectors().rightCols(fixed);
    const Eigen::VectorXd rhs = V.transpose() * (m_stdFree.transpose() * (right - square * m_stdSolution));
    m_stdSolution += m_stdFree * (V * rhs.cwiseQuotient(lambda.tail(fixed)));
    m_stdFree = (m_stdFree * eigen.eigenvectors().leftCols(free)).eval();
  }

  double operator[](std::size_t i) const { return m_stdSolution[static_cast<Eigen::Index>(i)]; }

private:
  Eigen::VectorXd m_stdSolution;
  Eigen::MatrixXd m_stdFree; // columns: the directions in which the solution may still move
};

// log e_i + log e_j = log of the target, for each of the pairs.
void SolvePairs(CLevels& logs, CKinds kinds, const CPairs& pairs) {
  const auto n = static_cast<Eigen::Index>(kinds.size());
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const CBouncePair& pair : pairs) {
    const Eigen::Index both[] = {static_cast<Eigen::Index>(pair.m_nFirst),
                                 static_cast<Eigen::Index>(pair.m_nSecond)};
    const float target = GetTarget(kinds, pair);
    for (const Eigen::Index i : both) {
      right[i] += std::log(static_cast<double>(target > 0.0f ? target : g_fNearlyDead));
      for (const Eigen::Index j : both)
        square(i, j) += 1.0;
    }
  }
  logs.Solve(square, right);
}

void SolveBallsAtOne(CLevels& logs, CKinds kinds) {
  const auto n = static_cast<Eigen::Index>(kinds.size());
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    square(i, i) = kinds[static_cast<std::size_t>(i)].m_bIsBall ? 1.0 : 0.0;
  logs.Solve(square, Eigen::VectorXd::Zero(n));
}

// Kinds that can have elasticity 0: all of the pairs that decide have the target 0.
std::vector<bool> FindZeros(CKinds kinds, std::span<const CBouncePair> deciding) {
  std::vector<bool> meets(kinds.size()), bounces(kinds.size()), zero(kinds.size());
  for (const CBouncePair& pair : deciding)
    for (const std::size_t i : {pair.m_nFirst, pair.m_nSecond}) {
      meets[i] = true;
      if (GetTarget(kinds, pair) > 0.0f) bounces[i] = true;
    }
  for (std::size_t i = 0; i < kinds.size(); ++i)
    zero[i] = meets[i] && !bounces[i];
  return zero;
}

std::vector<float> Fit(CKinds kinds, std::span<const CBouncePair> pairs, const std::vector<bool>& zero) {
  // No elasticity other than 0 reproduces a target of 0, and 0 no other target.
  CPairs withShapes, ofBalls, nearZero;
  std::vector<bool> isFitted(kinds.size());
  for (const CBouncePair& pair : pairs) {
    if (!(GetTarget(kinds, pair) > 0.0f) || zero[pair.m_nFirst] || zero[pair.m_nSecond]) continue;
    (IsOfBalls(kinds, pair) ? ofBalls : withShapes).push_back(pair);
    isFitted[pair.m_nFirst] = isFitted[pair.m_nSecond] = true;
  }
  for (const CBouncePair& pair : pairs)
    if (GetTarget(kinds, pair) == 0.0f && isFitted[pair.m_nFirst] && isFitted[pair.m_nSecond])
      nearZero.push_back(pair);
  CLevels logs(kinds.size());
  SolvePairs(logs, kinds, withShapes);
  SolvePairs(logs, kinds, ofBalls);
  SolvePairs(logs, kinds, nearZero);
  SolveBallsAtOne(logs, kinds);

  std::vector<float> e(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const double fitted = isFitted[i] ? std::exp(logs[i]) : static_cast<double>(kinds[i].m_fRestitution);
    e[i] = static_cast<float>(std::min(fitted, static_cast<double>(g_fMaxElasticity)));
  }
  return e;
}

// Less is better: pairs with shapes that are not reproduced, pairs of balls likewise, and by how much.
std::tuple<int, int, double> Badness(CKinds kinds, std::span<const CBouncePair> pairs,
                                     const std::vector<float>& e) {
  std::tuple<int, int, double> bad{};
  for (const CBouncePair& pair : pairs) {
    if (Reproduces(kinds, e, pair)) continue;
    ++(IsOfBalls(kinds, pair) ? std::get<1>(bad) : std::get<0>(bad));
    std::get<2>(bad) +=
        std::abs(static_cast<double>(e[pair.m_nFirst]) * static_cast<double>(e[pair.m_nSecond]) -
                 static_cast<double>(GetTarget(kinds, pair)));
  }
  return bad;
}

} // namespace

float GetTarget(CKinds kinds, const CBouncePair& pair) {
  return std::max(kinds[pair.m_nFirst].m_fRestitution, kinds[pair.m_nSecond].m_fRestitution);
}

bool Reproduces(CKinds kinds, std::span<const float> e, const CBouncePair& pair) {
  const float target = GetTarget(kinds, pair);
  const float ulp = std::nextafter(target, std::numeric_limits<float>::infinity()) - target;
  const float product = e[pair.m_nFirst] * e[pair.m_nSecond];
  return target == 0.0f ? product == 0.0f : std::abs(product - target) <= 4.0f * ulp;
}

std::vector<float> FitElasticities(CKinds kinds, std::span<const CBouncePair> pairs) {
  std::vector<float> all = Fit(kinds, pairs, FindZeros(kinds, pairs));
  const auto badness = Badness(kinds, pairs, all);
  if (std::get<0>(badness) + std::get<1>(badness) == 0) return all;

  // Pairs of balls give way: they do not keep from 0 what meets only shapes without restitution.
  CPairs withShapes;
  for (const CBouncePair& pair : pairs)
    if (!IsOfBalls(kinds, pair)) withShapes.push_back(pair);
  const std::vector<float> shapesFirst = Fit(kinds, pairs, FindZeros(kinds, withShapes));
  return Badness(kinds, pairs, shapesFirst) < badness ? shapesFirst : all;
}

} // namespace Shapes::Box2D
