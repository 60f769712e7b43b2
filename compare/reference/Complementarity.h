// SPDX-License-Identifier: MIT
// The forces of contacts that push and do not pull.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <limits>
#include <vector>

namespace Shapes::Compare {

template <class T>
using CMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <class T>
using CColumn = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// An acceleration into a contact of this many times its rounding, where the other contacts leave the ball no
/// way out, is a contradiction: a ball that is crushed.
inline constexpr double g_fContradicts = 0x1p26;

/// Forces f >= 0 that leave the accelerations a = A f + b >= 0, with a_k = 0 wherever f_k > 0; A is symmetric
/// and positive semidefinite. Each a_k is known to `none`_k. By the active set method of C. Lawson and R.
/// Hanson (Solving Least Squares Problems, 1974, chapter 23): it takes in the contact that is violated most,
/// solves for the forces exactly, and lets go what would pull. Contacts that depend on those taken in get no
/// force. Accelerations are unique; forces only where the normals are independent.
/// @return whether there are such forces
template <class T>
bool Complement(const CMatrix<T>& A, const CColumn<T>& b, const CColumn<T>& none, CColumn<T>& f) {
  const T eps = std::numeric_limits<T>::epsilon();
  const Eigen::Index n = b.size();
  std::vector<bool> active(static_cast<std::size_t>(n)), barred(active);
  const auto is = [](std::vector<bool>& flags, Eigen::Index k) { return flags[static_cast<std::size_t>(k)]; };
  f = CColumn<T>::Zero(n);
  for (Eigen::Index round = 0; round < 64 * (n + 1); ++round) {
    const CColumn<T> a = A * f + b;
    Eigen::Index worst = -1;
    for (Eigen::Index k = 0; k < n; ++k)
      if (!is(active, k) && !is(barred, k) && a[k] < -none[k] && (worst < 0 || a[k] < a[worst])) worst = k;
    if (worst < 0) {
      for (Eigen::Index k = 0; k < n; ++k)
        if (is(barred, k) && a[k] < -T(g_fContradicts) * none[k]) return false;
      return true;
    }
    active[static_cast<std::size_t>(worst)] = true;
    for (bool done = false; !done;) {
      std::vector<Eigen::Index> in;
      for (Eigen::Index k = 0; k < n; ++k)
        if (is(active, k)) in.push_back(k);
      done = true;
      if (in.empty()) break;
      const Eigen::LDLT<CMatrix<T>> solver(A(in, in));
      const CColumn<T> old = f(in);
      const bool depends = solver.vectorD().minCoeff() <= T(64) * eps * A.diagonal().maxCoeff();
      CColumn<T> way = CColumn<T>::Zero(old.size());
      for (int pass = 0; pass < 2 && !depends; ++pass) // once more for what roundings have left
        way -= solver.solve(b(in) + A(in, in) * (old + way));
      // How far the forces can go towards the solution before one of them would pull.
      T share = T(1);
      for (Eigen::Index k = 0; k < old.size(); ++k)
        if (!(old[k] + way[k] > T(0)) && old[k] < -share * way[k]) share = old[k] / -way[k];
      for (std::size_t k = 0; k < in.size(); ++k) {
        const Eigen::Index row = static_cast<Eigen::Index>(k);
        f[in[k]] = old[row] + share * way[row];
        if (old[row] + way[row] > T(0) || f[in[k]] > T(4) * eps * old[row]) continue;
        f[in[k]] = T(0);
        active[static_cast<std::size_t>(in[k])] = false;
        if (in[k] == worst) continue;
        done = false; // once more without it; it may have been what another one depends on
        barred.assign(barred.size(), false);
      }
    }
    if (!is(active, worst)) barred[static_cast<std::size_t>(worst)] = true;
  }
  return false;
}

} // namespace Shapes::Compare
