// SPDX-License-Identifier: MIT
#pragma once

#include "../../geometry/TimeOfImpact.h"
#include "../../world/WorldState.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "../broadphase/NearDiscs.h"
#include "../broadphase/StaticBroadPhase.h"
#include "Middle.h"
#include "PileEnergy.h"
#include "RestingContacts.h"

namespace Shapes::Native {

/// The continuous mode of a substep: every solid ball moves on its parabola, without gravity straight on at
/// the velocity that it has, from impact to impact, and responds to each, in the order of time, at the place
/// and in the direction of the impact; the rest of the substep it moves on. Shapes move and turn meanwhile.
/// Computed in double.
///
/// - Without gravity an unobstructed ball moves bit-identically to the approximate mode.
/// - Initial overlaps are pushed out along the normal, of two balls by their shares of the mass, but never
///   through another shape. A ball that comes through a one-sided shape from behind is left alone as long as
///   it moves out; then it is put onto that.
/// - Impacts at the same time are answered one after the other: shapes before balls, by order and by id.
/// - Under gravity, a ball that would be back at a shape within 1/g_nHops of the substep after it has left it
///   does not leave it: it lies on it or slides along it, without friction, until it would have to be pulled.
///   It loses the energy of that hop, and no other.
/// - Under gravity, balls that touch and hardly approach rest on each other: CRestingContacts. An impact that
///   is faster is passed on among them at once. So do those that are squeezed, also without gravity.
/// - Without gravity, a ball that comes back to the same turning shape or inside of an arc within 1/g_nHops
///   of the substep, and leaves it all but along the surface, slides: it keeps its speed, but leaves so
///   steeply that it stays away for that long, or at g_fShallow radians if that is less.
/// - Under gravity, balls that lie on something sleep once they and all of their pile have been slower than
///   g_fSleepSpeed of what gravity gives in a substep for g_fSleepTime seconds: they stand still, no contact
///   of theirs is told, until a ball or a moving shape comes near, or something near them is added, removed
///   or changed.
/// - Of two balls that are each deep in more than g_nMostDeep others, one has to be among the nearest of the
///   other: else they do not meet.
/// - A ball is halted that has had g_nMaxImpacts impacts, g_nCrowded among others, g_nStuckImpacts at once
///   where a moving shape presses it straight on something, or has found more than g_nMostBallsSeen others in
///   all searches: for the rest of the substep it stays where it is, which is a place that it can be at, or
///   goes along with the shape that has pushed it last. It keeps its velocity, under gravity none into the
///   shapes that it touches, and none at all if it has got nowhere in the substep; others bounce off it as
///   off a wall.
class CContinuous {
public:
  /// Begins to move the balls by dt seconds, and counts what is done. Threads share balls that do not meet
  /// each other: each has one of these, and all begin.
  /// @param shapes  as they are at the beginning of the substep
  /// @param pairs   whether balls meet each other
  /// @param filters  whether any ball or shape meets not all
  /// @param gravity  user units per second squared
  /// @param stats  of this one alone
  void Begin(CBallArrays& balls, CStaticBroadPhase& shapes, bool pairs, bool filters, const Vector2& gravity,
             float dt, CWorldStats& stats);
  /// One of them, before any moves balls.
  /// @returns whether anything moves
  bool Prepare();
  /// All balls, where they meet each other.
  void MoveTogether();
  /// The balls from begin to end of the arrays, where they do not.
  void MoveAlone(std::size_t begin, std::size_t end);
  /// Takes over the contacts, path vertices and halted balls of the next range of balls.
  void Append(const CContinuous& next);

  /// A game has put a shape somewhere else, perhaps into balls.
  void ShapeWasPut() { m_cResting.NoteShapePut(); }

  /// A ball was removed from this place in the arrays.
  void ForgetBall(std::size_t ball) { m_cResting.ForgetBall(ball); }
  /// Of a step.
  void SetSubsteps(unsigned substeps) { m_cResting.SetSubsteps(substeps); }
  /// All that the next substep depends on beyond the state.
  using CMemory = CRestingContacts::CMemory;
  const CMemory& GetMemory() const { return m_cResting.GetMemory(); }
  void SetMemory(const CMemory& memory) { m_cResting.SetMemory(memory); }

  /// The impacts in the order of time.
  const std::vector<CContactEvent>& GetContacts();
  /// Where balls were at the share m_fPart of the substep when they were answered.
  struct CPathVertex {
    std::size_t m_nBall;
    Vector2 m_vPos;
    float m_fPart;
  };
  const std::vector<CPathVertex>& GetPathVertices() const { return m_stdPathVertices; }
  /// The balls that were halted, in the order of time of each range.
  const std::vector<CShapeId>& GetHalted() const { return m_stdHalted; }

private:
  struct CEvent {
    double m_fTime;
    std::size_t m_nOrder; // of the ball in the arrays
    std::uint32_t m_nBall;
    std::uint32_t m_nVersion;
    bool operator<(const CEvent& other) const; // comes later: for a heap whose top is the first
  };

  // A shape that a ball touches at the beginning of its motion.
  struct CTouching {
    std::uint32_t m_nOrder;
    double m_fGap;
    CImpact m_cImpact;
  };

  void MoveAlone(std::size_t i);
  void MoveFreely(std::size_t i);
  void MoveFreely(std::size_t i, const CMotion& motion);
  void FollowBalls();
  void TakeBalls();
  void FindDiscs();
  void FindInvolved();
  bool PassesAll(const CMotion& motion, const CDiscGrid::CDisc& disc);
  bool IsFar(std::size_t i) const;
  bool MovesNear(const CDiscGrid::CDisc& disc) const;
  void TakeSolid(std::uint32_t k);
  void Take(std::size_t i, const CMotion& motion, const CDiscGrid::CDisc& disc);
  void FindBalls(std::uint32_t i);
  void FindAllBalls(std::uint32_t i);
  void FindCrowds();
  bool IsBeyondCrowd(std::uint32_t i, std::uint32_t j) const;
  void PutBalls();
  void PutTaken();
  void WakeDisturbed();
  bool AllSleep() const;
  bool AnySleeps() const;
  bool IsAsleep(std::size_t i) const { return IsFalling() && m_pBalls->IsAsleep(i); }
  bool IsOnWay(std::size_t sleeper, std::size_t ball) const;
  float GetCalm(const CMoving& ball) const;
  void SetCalm(std::size_t k, float calm);
  void FallAsleep();
  void Put(const Vector2d& p, Vector2d v, std::size_t i);
  CMotion GetMotion(const CMoving& ball) const;
  // A motion that takes no time.
  static CMotion GetPlace(const CMoving& ball) {
    return {ball.m_vPos, Vector2d::Zero(), ball.m_fRadius, 0.0};
  }
  CMotion GetFreeMotion(std::size_t i) const;
  std::uint32_t GetIndex(const CMoving& ball) const {
    return static_cast<std::uint32_t>(&ball - m_stdBalls.data());
  }
  CShapeId GetId(const CMoving& ball) const { return m_pBalls->m_stdId[ball.m_nBall]; }
  static CDiscGrid::CDisc GetDisc(const CMotion& motion, double sagitta);
  void MoveDisc(std::uint32_t i);
  // How far a ball may leave the disc by which it was found near others: they were looked for twice as far.
  float GetSlack() const { return static_cast<float>(0.5 * m_cResting.GetReach()); }
  void FindShapes(std::uint32_t i, float reach = 0.0f);
  void KeepShapesFound(std::uint32_t i, const CDiscGrid::CDisc& in);
  void FindFirst(std::uint32_t i);
  // The shapes that a ball may be set back from: those that do not move now, or that never do.
  enum class eShapes { All, Resting, Static };
  struct CNotInTheWay {
    std::uint32_t m_nShape = g_nNobody;
    const CShapeGeometry* m_pAlong = nullptr; // and those that move together with it
  };
  // A ball that is set back by much gets deeper into no other shape, or into the surfaces of others. Its
  // centre crosses none.
  enum class eThrough { None, Surfaces };
  bool SetBackInTurns(std::uint32_t i, eShapes from, eThrough through);
  void SetBackFromAll(std::uint32_t i);
  double GetDepth(std::uint32_t order, const CMotion& motion) const;
  bool IsAmong(eShapes shapes, std::uint32_t order) const;
  double GetDepthIn(eShapes shapes, const CMoving& ball, const Vector2d& p) const;
  void StayInPlace(std::uint32_t i);
  void TellIfGoneOver(std::uint32_t i);
  void TellHalted(CMoving& ball);
  bool SetBackFromShapes(std::uint32_t i, eShapes from, eThrough through);
  void SetBackFromShape(std::uint32_t i, std::uint32_t order, const Vector2d& n, double depth,
                        eThrough through);
  void SetBackFromBall(std::uint32_t i, const Vector2d& n, double depth);
  double GetClearShare(const CMoving& ball, const Vector2d& n, double depth);
  bool ComesThrough(const CMoving& ball, std::uint32_t order, const CImpact& impact, double gap) const;
  void SetBackFromBalls(std::uint32_t i);
  double GetFreeShare(const CMoving& ball, const Vector2d& p, const Vector2d& way, double time,
                      const CNotInTheWay& except);
  bool MeetsShape(const CMoving& ball, std::uint32_t order) const {
    return DoMeet(m_pBalls->m_stdFilter[ball.m_nBall], m_pShapes->Get(order).m_pShape->GetFilter());
  }
  void CorrectPosition(std::uint32_t i, const Vector2d& way);
  void FindNext(std::uint32_t i);
  void FindNextShape(CMoving& ball);
  bool IsPassing(const CMoving& ball, std::uint32_t order, const CImpact& impact, double gap) const;
  void FindRestingContacts();
  void StayInside(std::uint32_t i);
  void SolveRestingContacts();
  void FindShapeImpacts(CMoving& ball);
  std::optional<CShapeGeometry> WithoutSharedEnd(std::uint32_t order, const CMotion& motion, double start,
                                                 const CImpact& impact) const;
  eSweep SweepShape(std::uint32_t order, const CMotion& motion, double start, CImpact& impact) const;
  bool IsNearShape(std::uint32_t order, const CMotion& motion, double start, double reach, CImpact& impact,
                   double& gap) const;
  bool IsFalling() const { return m_bIsFalling; }
  bool IsHop(double out, double closing, double speed) const;
  bool CanFollow(const CMoving& ball, std::uint32_t order, double radius) const;
  void Hold(CMoving& ball, const CHold& hold);
  CHold MakeHold(const CMoving& ball, std::uint32_t order, const CImpact& impact, const Vector2d& acc) const;
  // What rounding explains of a gap between the two.
  double GetRounding(const CMoving& ball, std::uint32_t order) const;
  void HoldTouching(CMoving& ball);
  bool Touches(const CMoving& ball, std::uint32_t order, CImpact& impact, double& gap) const;
  bool HoldIfTouching(CMoving& ball, std::uint32_t order, bool mayMeet);
  bool HoldIfStaying(CMoving& ball, std::uint32_t order, const CImpact& impact, double gap, bool mayMeet);
  bool HoldAsOne(CMoving& ball, std::uint32_t order, const CImpact& impact);
  void ReportHold(const CMoving& ball);
  bool IsSlow(const CMoving& ball, const CMoving& other, double approach) const;
  void StopTogether(CMoving& upper, CMoving& lower, const Vector2d& up) const;
  void Rest(CMoving& ball, CMoving& other, const Vector2d& n);
  bool AreAtRest(std::uint32_t i, std::uint32_t j) const;
  void SettleOnCurve(CMoving& ball, const CHold& curve, const CMotion& before, double time) const;
  bool SlideOnto(CMoving& ball, std::uint32_t order, const CMotion& before, CImpact& impact) const;
  void KeepEnergy(CMoving& ball, const CMotion& before, double time) const;
  bool SettleOnAll(CMoving& ball) const;
  void Settle(CMoving& ball, const CMotion& before, double time);
  double GetTimeToEnd(const CMoving& ball, const CHold& hold) const;
  double GetSector(const CMoving& ball, const CHold& hold, Vector2d& first, Vector2d& last) const;
  // How a ball slides along a curve: what it turns by, and what pulls it, over the radius.
  struct CSlide {
    CMiddle m_cMiddle;
    double m_fRate;          // radians per second, counterclockwise
    double m_fAlong, m_fOut; // gravity as the middle feels it, counterclockwise and away from the middle
    double GetPull() const { return std::abs(m_fAlong) + std::abs(m_fOut); }
  };
  // Where the ball is at p with the velocity v at `start`.
  CSlide GetSlide(const CMoving& ball, const CHold& curve, const Vector2d& p, const Vector2d& v,
                  double start) const {
    const CMiddle middle = GetMiddle(ball, curve, p, start);
    const Vector2d &n = curve.m_vNorm, along = Perp(n), g = ball.m_vFall - middle.GetAcc();
    const double inverse = 1.0 / curve.m_fRadius;
    return {middle, inverse * along.dot(v - middle.VelAt(0.0)), inverse * along.dot(g), inverse * n.dot(g)};
  }
  double GetTimeToTurn(const CMoving& ball, const CHold& hold, const CSlide& slide) const;
  double GetSlideTime(const CMoving& ball, const CHold& curve) const;
  double GetHoldTime(const CMoving& ball) const;
  // The turn speed of what holds a ball there. A circle that turns about its middle stays where it is.
  static double GetTurnSpeed(const CMoving& ball, const CHold& hold, const CShapeGeometry& o) {
    const bool isOnCircle = std::isfinite(hold.m_fRadius) && hold.m_fRadius != ball.m_fRadius;
    return isOnCircle && o.m_vCenter == o.m_vRotCenter ? 0.0 : o.m_fTurnSpeed;
  }
  // The middle of the curve that holds a ball since `start` at p.
  CMiddle GetMiddle(const CMoving& ball, const CHold& hold, const Vector2d& p, double start) const {
    const CShapeGeometry& o = m_pShapes->GetGeometry(hold.m_nOther);
    const Vector2d place = p - hold.m_fRadius * hold.m_vNorm;
    return {place, o.m_vVel, place - o.m_vRotCenter - start * o.m_vVel, GetTurnSpeed(ball, hold, o)};
  }
  const CHold* GetCurve(const CMoving& ball) const;
  Vector2d GetBend(const CMoving& ball) const;
  void Free(CMoving& ball) const;
  bool IsOver(const CMoving& ball, const CMoving& other, const CMotion& motion, const CMotion& otherMotion,
              const CImpact& impact) const;
  void FindBallImpacts(std::uint32_t i, std::uint32_t first = 0);
  void KeepEarliest(const CNext& found, CMoving& ball) const;
  void Queue(std::uint32_t i);
  void Advance(CMoving& ball, double motion);
  void Resolve(std::uint32_t i);
  void PassOn();
  void ResolveWithShape(CMoving& ball);
  void ResolveWithBall(CMoving& ball, CMoving& other);
  void TakeBack(CMoving& ball) const;
  void GiveAgain(CMoving& ball) const;
  void TakeSupport(CMoving& ball, const Vector2d& n, const Vector2d& surface) const;
  // Whether its velocity has all that gravity and its pile give in the substep.
  bool IsPushed(const CMoving& ball) const { return IsFalling() && ball.m_vFall.isZero(0.0); }
  void Collide(CMoving& ball, CMoving& other, const Vector2d& n, double setback, bool isSlow);
  void GoAlong(CMoving& ball, double time);
  void HoldAnew(CMoving& ball);
  void StayOn(CMoving& ball, const CHold& hold, bool alone);
  bool IsAlong(const CHolds& held, std::uint32_t wall, const Vector2d& n) const;
  void HoldAllTouching(CMoving& ball, const CHolds& before);
  void Slide(CMoving& ball, const CImpact& impact) const;
  void Report(CShapeId shape, const CMoving& ball, const Vector2d& poi, const Vector2d& n, double speed,
              float impulse);
  bool GetsNowhere(CMoving& ball, const Vector2d& n) const;
  void EndMotion(CMoving& ball, const Vector2d& n);
  void StopAtTouching(CMoving& ball);
  void Halt(CMoving& ball);

  std::vector<CContactEvent> m_stdContacts;
  std::vector<std::pair<double, std::uint32_t>> m_stdTimes; // of each of them, in the substep, with its index
  std::vector<std::pair<double, std::uint32_t>> m_stdMerged;
  std::vector<CContactEvent> m_stdUnsorted;
  std::vector<CPathVertex> m_stdPathVertices;
  std::vector<CShapeId> m_stdHalted;

  // Of the substep.
  CBallArrays* m_pBalls = nullptr;
  CStaticBroadPhase* m_pShapes = nullptr;
  CWorldStats* m_pStats = nullptr;
  double m_fStep = 0.0;
  double m_fFastest =
      0.0; // ball at the beginning, or surface that was met, of it g_fSqueezed times the speed
  Vector2d m_vGravity = Vector2d::Zero();
  double m_fFall = 0.0;    // speed that gravity gives in it
  double m_fSagitta = 0.0; // of a motion that nothing deflects
  bool m_bIsFalling = false;
  bool m_bCapsSpeeds = false; // gravity can take a ball beyond g_fMaxSpeed
  bool m_bPairs = false;
  bool m_bFilters = false;
  bool m_bAnyCrowd = false;              // balls that do not meet all that they are deep in
  std::vector<std::uint32_t> m_stdSolid; // balls of the arrays, by k
  CNearDiscs m_cNearDiscs;               // around their ways, as they would move alone, by k
  // Those in the open move as if they were alone. All the rest, and they only, are taken: in the order of the
  // arrays, and behind them those upon which another one has come meanwhile.
  std::vector<std::uint8_t> m_stdIsInvolved; // by k
  std::vector<std::uint32_t> m_stdIndexOf;   // by k
  std::vector<CMoving> m_stdBalls;
  std::vector<CEvent> m_stdQueue;           // a heap
  std::uint32_t m_nFoundOf = g_nNobody;     // ball whose shapes m_stdShapesFound are
  std::vector<std::uint32_t> m_stdShapesOf; // of all balls
  std::vector<std::uint32_t> m_stdShapesFound, m_stdBallsFound, m_stdInTheWay;
  std::vector<CTouching> m_stdTouching;
  std::vector<CFarness> m_stdDeep;
  CRestingContacts m_cResting;
  CPileEnergy m_cEnergy;
  std::vector<std::uint32_t> m_stdHit, m_stdPassing;
  std::vector<std::uint32_t> m_stdWoken;
  std::vector<float> m_stdLeastCalm; // of each pile
  Geometry::CAabbTree m_cDisturbed;  // of what was changed since the last substep
};

} // namespace Shapes::Native
