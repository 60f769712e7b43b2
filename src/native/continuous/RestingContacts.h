// SPDX-License-Identifier: MIT
// Balls that rest on each other: which accelerations they have.
#pragma once

#include "../../world/Engine.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ContactSolver.h"
#include "Groups.h"
#include "Moving.h"

namespace Shapes::Native {

/// The slow contacts of balls with each other and with shapes at the beginning of a substep: pairs that touch
/// or would touch within it, and approach no faster than gravity makes them, in piles: balls that hang
/// together by such pairs, and lie on a shape. (Those that fall together do not press on each other.) They
/// are inelastic. A surface that a ball is too fast to follow, or that would turn it by more than
/// g_fMostInward says, is no pair of it.
///
/// A ball is squeezed if it had g_nSqueezed impacts in the substep before, and stays so in a pile that a
/// shape moves. It rests on all that it could meet, or come near to, and those on it, at any speed: by
/// impacts, one after the other, what does not give way would take hundreds of them to come to the same. It
/// also stays so in a pile that a game steers: it gives balls another velocity in each substep, as to a swarm
/// that it drives. Such a pile need not lie on a shape.
///
/// An elastic ball that neither a shape nor a game presses is not squeezed. Without gravity balls rest on
/// each other only in a pile in which one is, and it comes to that if it was halted, or hit as often in a
/// pile that is steered; it stays so as long as it presses on others.
///
/// Balls of a pile move straight on within the substep, at the velocities that they have at its end: those
/// that gravity gives, changed by impulses along the normals that push and never pull, so that no pair ends
/// in an overlap. CContactSolver finds these, and begins with those of the substep before.
///
/// An impulse J at a pair that approaches at u0 before and u1 after does the work -J (u0 + u1) / 2, which is
/// not above zero for what is asked of u1; and a ball that is moved by its velocity at the end instead of the
/// mean has (a dt)^2 / 2 less energy per mass. So contacts give no energy. Moving balls apart and what the
/// rounds leave undone would: a pile on which no shape moves gets slower by what it has gained, as far as it
/// moves.
class CRestingContacts {
private:
  struct CContact {
    std::uint32_t m_nBall, m_nOther;
    bool m_bIsBall, m_bMayHold;
    Vector2d m_vNorm;
    double m_fGap, m_fSpeed, m_fRadius;
    double m_fBend; // second derivative of the gap, without the accelerations of the balls
    double m_fImpulse = 0.0, m_fApart = 0.0;
    std::uint64_t m_nPair;
    double m_fKey = 0.0;       // of sorting: the height against gravity, and then the pile
    std::uint32_t m_nNear = 0; // where m_stdNear has it
  };
  // A pair that was within reach, and its impulses.
  struct CKnown {
    std::uint64_t m_nPair;
    double m_fImpulse;
    std::uint32_t m_nContact; // of this pair
    double m_fApart = 0.0;    // the impulse that has moved it apart
  };
  // A ball at the end of the last substep in which it was looked at.
  struct CLast {
    Vector2 m_vVel = Vector2::Zero();
    std::uint32_t m_nSubstep = 0;
    std::uint16_t m_nSteered = 0; // substeps for which it counts as steered from then on
    bool m_bIsSqueezed = false;
  };

public:
  /// All that the next substep has to know of those before.
  struct CMemory : CEngineMemory {
    std::vector<CKnown> m_stdNear; ///< pairs of the last substep, in order
    std::vector<CLast> m_stdLast;  ///< of each ball, by the index in the arrays
    bool m_bIsAnySqueezed = false; ///< in the last substep
    std::uint32_t m_nSubstep = 0;  ///< the last one, modulo 2^32
    bool m_bIsShapePut = false;    ///< a shape somewhere else, since the last substep in which balls met
  };
  const CMemory& GetMemory() const { return m_cMemory; }
  void SetMemory(const CMemory& memory) { m_cMemory = memory; }
  void NoteShapePut() { m_cMemory.m_bIsShapePut = true; }

  /// Begins a substep.
  /// @param elasticity  the largest of all balls
  void Begin(const Vector2d& gravity, double dt, double elasticity);
  /// The fastest approach of two balls that rest on each other: g_fRestingSteps.
  double GetSlow() const { return m_fSlow; }
  /// Without gravity what is slow depends on the fastest of the balls that were squeezed.
  void SetSlow(const std::vector<CMoving>& balls);
  /// Takes up a pair of balls, or a ball and the shape of this order (`isBall` false).
  /// @param id, otherId  by which the pair is known in the next substep
  /// @param impact  as of Near, for balls that are accelerated by gravity
  /// @param mayHold  whether they can rest on each other: if not, the ball is moved out of the shape, and not
  ///                 into it, as balls that overlap are moved apart, and no more
  void Add(std::uint32_t ball, std::uint32_t other, bool isBall, CShapeId id, CShapeId otherId,
           const CImpact& impact, double gap, bool mayHold);
  bool IsEmpty() const { return m_stdContacts.empty(); }
  /// The ball by which its pile is known, itself if it is in none.
  std::uint32_t GetPile(std::uint32_t ball) { return ball < m_cPiles.Size() ? m_cPiles.Find(ball) : ball; }
  /// A ball was removed: those after it have other indices in the arrays.
  void ForgetBall(std::size_t ball);
  /// Remembers at the end of the substep who of `size` in the arrays is squeezed.
  void Remember(const std::vector<CMoving>& balls, std::size_t size);
  /// Of the ball of this index in the arrays.
  bool WasSqueezed(std::size_t ball) const {
    return WasThere(ball) && m_cMemory.m_stdLast[ball].m_bIsSqueezed;
  }
  /// Substeps for which the ball counts as steered, this one included: those of a step, after a game has
  /// given it this velocity.
  unsigned GetSteered(std::size_t ball, const Vector2d& vel) const;
  void SetSubsteps(unsigned substeps) { m_nSubsteps = substeps; }
  /// Whether pairs are looked for.
  bool IsCalledFor() const { return m_bIsFalling || m_cMemory.m_bIsAnySqueezed; }
  /// Whether either of the two was: then both rest on each other at any speed.
  static bool IsSqueezed(const CMoving& ball, const CMoving& other) {
    return ball.m_bWasSqueezed || other.m_bWasSqueezed;
  }
  /// The gap up to which two that gravity alone brings together are a pair here.
  double GetReach() const { return m_fReach; }
  /// The same where either may have been squeezed.
  /// @param speed   at which they move against each other
  /// @param radius  of the smaller one
  double GetReach(bool isSqueezed, double speed, double radius) const {
    return isSqueezed ? GetReach() + speed * m_fStep + g_fSqueezedReach * radius : GetReach();
  }
  /// Whether two balls are a pair here.
  bool Has(std::uint32_t ball, std::uint32_t other) const;
  /// The other balls of the pairs of a ball, by their indices.
  std::span<const std::uint32_t> GetNeighbours(std::uint32_t ball) const;

  /// Moves balls that overlap apart, and out of shapes: by less than a quarter of the largest radius of a
  /// ball and those near it, unless a shape may have been put into them. The solver finds the velocities at
  /// which they are apart after the substep, and none of these stays (split impulses).
  void Separate(std::vector<CMoving>& balls);
  /// At the end of the substep: which balls overlap by more than those that fall asleep may.
  void NotePressed(std::vector<CMoving>& balls) const;
  /// Notes where balls are, with the gaps as they are known: whatever moves a ball until Solve changes them.
  void NotePlaces(const std::vector<CMoving>& balls);
  /// A ball was moved only this share of what it was lifted by.
  void ShortenLift(std::uint32_t ball, double share) { m_stdLifts[ball] *= share; }
  /// Keeps the contacts of piles only, and tells their balls.
  void FindPiles(std::vector<CMoving>& balls);
  /// Sets the velocities of all balls of piles; the shapes that push become holds.
  void Solve(std::vector<CMoving>& balls);
  /// Pile by pile from the bottom up. Those that push have an impulse.
  const std::vector<CContact>& GetContacts() const { return m_stdContacts; }

private:
  // Of a pile.
  struct CEnergy {
    double m_fBefore = 0.0;    // kinetic, without the work of lifting balls as they were moved apart
    double m_fKinetic = 0.0;   // at the velocities at the end of the substep
    double m_fFall = 0.0;      // the work of gravity at these
    bool m_bIsMoved = false;   // by a shape
    bool m_bIsSteered = false; // by a game
    double GetShare() const;   // of these velocities with which the pile gains no energy
  };
  void Sort();
  double GetSpeed(const CContact& c, const std::vector<CMoving>& balls) const;
  // Whether it was looked at in the last substep.
  bool WasThere(std::size_t ball) const {
    return ball < m_cMemory.m_stdLast.size() &&
           m_cMemory.m_stdLast[ball].m_nSubstep + 1 == m_cMemory.m_nSubstep;
  }
  bool IsPair(const CContact& c, const std::vector<CMoving>& balls) const;
  double GetGap(const CContact& c, const std::vector<CMoving>& balls) const;
  void Order(std::vector<CMoving>& balls);
  static double GetSmallerRadius(const CContact& c, const std::vector<CMoving>& balls);
  bool IsJammed(const CContact& c, const std::vector<CMoving>& balls) const;
  double GetFlowError(const std::vector<CMoving>& balls) const;
  void FindKnown();
  void FindNeighbours(std::size_t balls);
  // Calls f(ball, energy of its pile, what it was lifted).
  template <class F>
  void ForEachInPile(std::vector<CMoving>& balls, const F& f) {
    for (std::uint32_t i = 0; i < balls.size(); ++i)
      if (balls[i].m_bIsInPile) f(balls[i], m_stdEnergies[m_cPiles.Find(i)], m_stdLifts[i]);
  }
  void SolvePile(std::span<CContact> pile, std::vector<CMoving>& balls);

  // For the solver, which gets the balls of the contact with the velocities getVel(ball) unless it has them.
  template <class F>
  CContactSolver::CRow MakeRow(const CContact& c, const std::vector<CMoving>& balls, const F& getVel) {
    const auto take = [&](std::uint32_t i) {
      std::uint32_t& solved = m_stdSolved[i];
      if (solved == g_nNobody) solved = m_cSolver.AddBall(getVel(i));
      return solved;
    };
    const std::uint32_t ball = take(c.m_nBall);
    const std::uint32_t shape = c.m_fSpeed > 0.0 ? CContactSolver::g_nPushingShape : CContactSolver::g_nShape;
    const std::uint32_t other = c.m_bIsBall ? take(c.m_nOther) : shape;
    return {c.m_vNorm,
            ball,
            other,
            1.0 / balls[c.m_nBall].m_fMass,
            c.m_bIsBall ? 1.0 / balls[c.m_nOther].m_fMass : 0.0,
            0.0};
  }

  Vector2d m_vGravity = Vector2d::Zero();
  Vector2d m_vUp = Vector2d::Zero(); // unit
  bool m_bIsFalling = false;         // there is gravity
  double m_fStep = 0.0, m_fSlow = 0.0, m_fReach = 0.0;

  std::vector<CContact> m_stdContacts; // pile by pile, from the bottom up
  std::vector<CContact> m_stdUnsorted;
  std::vector<std::pair<double, std::uint32_t>> m_stdOrder; // keys, and which contact has each
  CContactSolver m_cSolver;
  std::vector<std::uint32_t> m_stdSolved;     // of each ball: its index there
  CGroups m_cPiles;                           // of balls
  std::vector<bool> m_stdIsHeld;              // of each pile, by its ball: whether it lies on a shape
  std::vector<std::uint32_t> m_stdNeighbours; // of each ball on balls, ball by ball
  std::vector<std::uint32_t> m_stdFirst;      // of each ball among them, and where the last one's end
  std::vector<double> m_stdLifts;             // the work of lifting each ball as they were moved apart
  std::vector<Vector2d> m_stdPlaces;          // of each ball, as NotePlaces has found it
  std::vector<CEnergy> m_stdEnergies;         // of each pile, by its ball
  unsigned m_nSubsteps = 1;                   // of a step
  CMemory m_cMemory;                          // of this substep from its beginning on
  std::vector<CKnown> m_stdKnown;             // pairs of the last one
};

} // namespace Shapes::Native
