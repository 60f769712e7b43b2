// SPDX-License-Identifier: MIT
// The impulses of contacts that last.
#pragma once

#include "../../geometry/Vector.h"

#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// Finds impulses along the normals of contacts that push and never pull, such that the velocities that they
/// change fulfil every contact: a linear complementarity problem. Solved by projected Gauss-Seidel from the
/// bottom up and back, accelerated as a conjugate gradient is (Silcowitz-Hansen, Niebles, Erleben 2010).
class CContactSolver {
public:
  /// A contact. A shape is a ball that does not move and that nothing moves.
  struct CRow {
    Vector2d m_vNorm;                ///< unit, to the ball
    std::uint32_t m_nBall, m_nOther; ///< indices of velocities; of two balls the upper one and the lower one
    double m_fInverse, m_fOtherInverse; ///< masses; 0 of a shape
    double m_fShare;                    ///< 1 / (their sum)
    double m_fLeast;   ///< that the difference of velocities along the normal may be at the end
    double m_fImpulse; ///< to begin with, and as it was found
  };

  /// Of each ball, which Solve changes.
  std::vector<Vector2d>& GetVels() { return m_stdVels; }

  /// @param pile     contacts that share no ball with others, from the bottom up
  /// @param slow     speed, units per second, of which g_fRestingError is the error that may stay
  /// @param surface  the speed along the normal of the fastest shape that pushes
  void Solve(std::span<CRow> pile, double slow, double surface);

private:
  using CPile = std::span<CRow>;
  struct CWay {
    double m_fBefore; // the impulse before this round
    double m_fOn;     // the direction of the search
  };
  double GetDifference(const CRow& row) const;
  void Push(const CRow& row, double impulse);
  double Relax(CRow& row);
  double RelaxAll(CPile pile);
  double GoOn(CPile pile, double squareBefore);
  void Stop(const CRow& row);

  std::vector<Vector2d> m_stdVels;
  std::vector<CWay> m_stdWays; // of each contact of the pile
};

} // namespace Shapes::Native
