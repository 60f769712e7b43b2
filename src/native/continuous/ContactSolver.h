// SPDX-License-Identifier: MIT
// The impulses of contacts that last.
#pragma once

#include "../../geometry/Vector.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// Finds impulses along the normals of contacts that push and never pull, such that the velocities that they
/// change fulfil every contact: a linear complementarity problem. Solved by projected Gauss-Seidel from the
/// bottom up and back, accelerated as a conjugate gradient is (Silcowitz-Hansen, Niebles, Erleben 2010).
class CContactSolver {
public:
  /// A contact.
  struct CRow {
    Vector2d m_vNorm;                   ///< unit, to the ball
    std::uint32_t m_nBall, m_nOther;    ///< of AddBall; of two balls the upper one and the lower one
    double m_fInverse, m_fOtherInverse; ///< masses
    double m_fShare;                    ///< 1 / (their sum)
    double m_fLeast; ///< that the difference of velocities along the normal may be at the end
  };
  /// A shape is a ball that nothing moves.
  static constexpr std::uint32_t g_nShape = 0;

  /// Begins a pile: contacts that share no ball with those of other piles.
  void Begin();
  /// @returns  its index
  std::uint32_t AddBall(const Vector2d& vel);
  /// From the bottom up.
  /// @param impulse  that the search begins with
  void Add(const CRow& row, double impulse);
  /// @param slow     speed, units per second, of which g_fRestingError is the error that may stay
  /// @param surface  the speed along the normal of the fastest shape that pushes
  void Solve(double slow, double surface);

  const Vector2d& GetVel(std::uint32_t ball) const { return m_cVels.m_stdNow[ball]; }
  double GetImpulse(std::size_t row) const { return m_cImpulses.m_stdNow[row]; }

private:
  // Unknowns, and the direction in which the search changes them.
  template <class T>
  struct CUnknowns {
    std::vector<T> m_stdNow, m_stdBefore, m_stdDirection;

    void Clear() {
      for (std::vector<T>* pVector : {&m_stdNow, &m_stdBefore, &m_stdDirection})
        pVector->clear();
    }
    // All three grow alike, as copies of one would be allocated anew for each larger pile.
    void Add(const T& x) {
      for (std::vector<T>* pVector : {&m_stdNow, &m_stdBefore, &m_stdDirection})
        pVector->push_back(x);
    }
    void Begin(const T& zero) {
      std::copy(m_stdNow.begin(), m_stdNow.end(), m_stdBefore.begin());
      std::fill(m_stdDirection.begin(), m_stdDirection.end(), zero);
    }
    // On by this share of the direction so far, to which the change of the last round is added.
    void GoOn(double share) {
      T *pNow = m_stdNow.data(), *pBefore = m_stdBefore.data(), *pDirection = m_stdDirection.data();
      for (std::size_t k = 0, n = m_stdNow.size(); k < n; ++k) {
        const T more = share * pDirection[k];
        pDirection[k] = pNow[k] - pBefore[k] + more;
        pBefore[k] = pNow[k] += more;
      }
    }
  };
  // By a round.
  struct CChange {
    double m_fMost;   // of a velocity, on the way back
    double m_fSquare; // of all impulses, as energy
  };
  static double GetDifference(const CRow& row, const Vector2d* pVels);
  static void Push(const CRow& row, double impulse, Vector2d* pVels);
  static double Relax(const CRow& row, double& impulse, Vector2d* pVels);
  CChange RelaxAll();
  void Stop(const CRow& row);

  std::vector<CRow> m_stdRows;
  CUnknowns<double> m_cImpulses; // of each row
  CUnknowns<Vector2d> m_cVels;   // of each ball, and of the shapes
};

} // namespace Shapes::Native
