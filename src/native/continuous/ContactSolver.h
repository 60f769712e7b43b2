// SPDX-License-Identifier: MIT
// The impulses of contacts that last.
#pragma once

#include "../../geometry/Vector.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace Shapes::Native {

/// Finds impulses along the normals of contacts that push and never pull, such that the velocities that they
/// change fulfil every contact: a linear complementarity problem. Projected Gauss-Seidel from the bottom up,
/// and between two rounds on by a growing share of what the last one has changed: the momentum of Nesterov
/// (1983), which begins anew where a round goes against it (O'Donoghue and Candes 2015), and ends where
/// rounds change more and more: those without it do not.
class CContactSolver {
public:
  /// A contact.
  struct CRow {
    Vector2d m_vNorm;                   ///< unit, to the ball
    std::uint32_t m_nBall, m_nOther;    ///< of AddBall; of two balls the upper one and the lower one
    double m_fInverse, m_fOtherInverse; ///< masses
    double m_fLeast;       ///< that the difference of velocities along the normal may be at the end
    double m_fShare = 0.0; ///< 1 / (sum of the inverse masses): set by Add
  };
  /// A shape is a ball that nothing moves: one that does not come upon the ball, and one that does.
  static constexpr std::uint32_t g_nShape = 0, g_nPushingShape = 1;

  /// Begins a pile: contacts that share no ball with those of other piles.
  void Begin();
  /// @returns  its index
  std::uint32_t AddBall(const Vector2d& vel);
  /// From the bottom up.
  /// @param impulse  that the search begins with
  void Add(const CRow& row, double impulse);
  /// The error that a velocity may have in a pile that flows, whose fastest ball has this speed. 0 where it
  /// is slow.
  static double GetFlowError(double fastest, double slow);
  /// The velocities with which balls that rest on each other go on.
  /// @param slow     speed, units per second, of which g_fRestingError is the error that may stay
  /// @param surface  the speed along the normal of the fastest shape that pushes
  void Solve(double slow, double surface);
  /// Those that take balls which overlap apart.
  /// @param accurate  change of a velocity in a round, units per second, after which it has come to an end
  /// @param rounds    at most, above 0
  void Separate(double accurate, std::size_t rounds);

  const Vector2d& GetVel(std::uint32_t ball) const { return m_cVels.m_stdNow[ball]; }
  double GetImpulse(std::size_t row) const { return m_cImpulses.m_stdNow[row]; }

private:
  // Unknowns, and what they were after the round before.
  template <class T>
  struct CUnknowns {
    std::vector<T> m_stdNow, m_stdBefore;

    void Clear() {
      m_stdNow.clear();
      m_stdBefore.clear();
    }
    // Both grow alike, as a copy would be allocated anew for each larger pile.
    void Add(const T& x) {
      m_stdNow.push_back(x);
      m_stdBefore.push_back(x);
    }
    void Begin() { std::copy(m_stdNow.begin(), m_stdNow.end(), m_stdBefore.begin()); }
    // On by this share of what the last round has changed.
    void GoOn(double share) {
      T *pNow = m_stdNow.data(), *pBefore = m_stdBefore.data();
      for (std::size_t k = 0, n = m_stdNow.size(); k < n; ++k) {
        const T more = share * (pNow[k] - pBefore[k]);
        pBefore[k] = pNow[k];
        pNow[k] += more;
      }
    }
  };
  // By a round.
  struct CChange {
    double m_fMost; // of a velocity
    double m_fBack; // of all impulses, as energy, against the way on which they were
  };
  static double GetDifference(const CRow& row, const Vector2d* pVels);
  static void Push(const CRow& row, double impulse, Vector2d* pVels);
  CChange Relax(double part);
  double Search(double accurate, std::size_t rounds);
  void Stop(const CRow& row);
  void StopAt(std::uint32_t shape);
  void StopAtShapes();

  std::vector<CRow> m_stdRows;
  CUnknowns<double> m_cImpulses; // of each row
  CUnknowns<Vector2d> m_cVels;   // of each ball, and of the shapes
};

} // namespace Shapes::Native
