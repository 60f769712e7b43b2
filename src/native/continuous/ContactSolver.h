// SPDX-License-Identifier: MIT
// The impulses of contacts that last.
#pragma once

#include "RowPair.h"

#include <cstdint>
#include <vector>

namespace Shapes::Native {

/// Finds impulses along the normals of contacts that push and never pull, such that the velocities that they
/// change fulfil every contact: a linear complementarity problem. Projected Gauss-Seidel from the bottom up,
/// and between two rounds on by a growing share of what the last one has changed: the momentum of Nesterov
/// (1983), which begins anew where a round goes against it (O'Donoghue and Candes 2015), and ends where
/// rounds change more and more: those without it do not. Where shapes leave balls no room there are no such
/// velocities: where one pushes, it is asked after g_nPossibleRounds and each doubling of them whether that
/// is proven, which ends it.
class CContactSolver {
public:
  /// A contact.
  struct CRow {
    Vector2d m_vNorm;                   ///< unit, to the ball
    std::uint32_t m_nBall, m_nOther;    ///< of AddBall; of two balls the upper one and the lower one
    double m_fInverse, m_fOtherInverse; ///< masses
    double m_fLeast; ///< that the difference of velocities along the normal may be at the end
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
  /// @param limit     speed, units per second, up to which they are of use: the search also ends once it is
  ///                  sure that no velocities up to it fulfil all contacts
  /// @param rounds    at most, above 0
  void Separate(double accurate, double limit, std::size_t rounds);

  const Vector2d& GetVel(std::uint32_t ball) const { return m_stdVels[ball]; }
  double GetImpulse(std::size_t row) const {
    return m_stdPairs[m_stdPlaces[row] / 2].m_vImpulse[m_stdPlaces[row] % 2];
  }

private:
  // By a round.
  struct CChange {
    double m_fMost; // of a velocity
    double m_fBack; // of all impulses, as energy, against the way on which they were
  };
  void MakePairs();
  CChange Relax(double share, double part);
  bool IsImpossible(double speed);
  double Search(double accurate, double limit, std::size_t rounds);
  bool Stop(const CRow& row);
  bool StopAt(std::uint32_t shape);
  void StopAtShapes();
  void StopInWedges();

  std::vector<CRow> m_stdRows;
  bool m_bIsPushed = false;                          // by a shape
  std::vector<double> m_stdImpulses;                 // of rows, as the search begins
  std::vector<CRowPair> m_stdPairs;                  // all rows, as they are solved
  std::vector<std::uint32_t> m_stdPlaces;            // of rows: twice the pair, and which of its two
  std::vector<std::uint32_t> m_stdLevels, m_stdEnds; // of MakePairs
  std::vector<Vector2d> m_stdVels;                   // of each ball, and of the shapes
  std::vector<Vector2d> m_stdVelsBefore;             // after the round before
  std::vector<Vector2d> m_stdMomenta;                // of IsImpossible
};

} // namespace Shapes::Native
