// SPDX-License-Identifier: MIT
// The exact reference: balls that are carried through time steps from event to event, each at its time of
// impact. Both engines are held against it.
//
// Between events a ball flies on its parabola, p(t) = p + v t + g t^2/2; steps may be of any length. A ball
// that rests or slides on something moves along it: its way is a Taylor series whose forces are solved for
// order by order, and which is begun anew as often as rounding asks for.
//
// Sweeper.h says which parts are solid; in particular the ends of segments and arcs are round and solid here,
// unlike in the native engine's approximate mode.
#pragma once

#include "Complementarity.h"
#include "Sweep.h"

#include <Shapes/World.h>

#include <cstddef>
#include <span>
#include <vector>

namespace Shapes::Compare {

/// Most events in one step of a single ball; of n balls 1/n of them, since each takes n times as long. More
/// means that a ball is jammed, and the step throws.
inline constexpr std::size_t g_nMaxEvents = 100000;
/// The same for all that happens in a step: events, contacts that begin or end, and pieces of a slide.
inline constexpr std::size_t g_nMaxTurns = 200000;

/// A ball comes to rest on a shape if their elasticity is below 1 and this many hits in a row come within
/// g_fClose of the step: its hops are a geometric series that has come to its end.
inline constexpr int g_nMaxClose = 4;
inline constexpr double g_fClose = 1e-9;

/// Where nothing presses a sliding ball, an approach that would take it into the shape by less than this
/// share of its coordinates by the end of the step is no hit, dimensionless. Overlaps of up to twice this are
/// not reported.
inline constexpr double g_fRest = 1e-12;

/// A ball slides at once if it meets the inside of a curve, or a turning shape, at less than this share of
/// the speeds involved: it is pressed against it, and would hit it again immediately. Dimensionless.
inline constexpr double g_fPressed = 1e-6;

/// A ball that begins to rest or slide with an overlap of up to this share of its coordinates is lifted onto
/// the shape, dimensionless: its position has been a float. Else roundings would add up to sinking.
inline constexpr double g_fRounded = 0x1p-21;

/// Events of one ball that are this share of the step apart are simultaneous, dimensionless.
inline constexpr double g_fSimultaneous = 1e-12;

/// One impact.
template <class T>
struct CExactEvent {
  T m_fTime;            ///< Seconds from the start of the step.
  std::size_t m_nBall;  ///< Index of the ball; of two balls the lower one.
  std::size_t m_nShape; ///< Index of the shape, or of the other ball.
  bool m_bIsBall;       ///< m_nShape is a ball.
  bool m_bIsSensor;     ///< Either is a sensor: there was no response.
  bool m_bGraze;        ///< Ambiguous, see CHit.
  bool m_bOverlapped;   ///< They overlapped already: no impact has been seen.
  bool m_bSimultaneous; ///< One of the balls has another impact at this moment: the order decides.
  ePart m_ePart;        ///< The part of the shape that was hit.
  CVec<T> m_vCenter;    ///< of the ball at the impact, user units
  CVec<T> m_vPOI;       ///< on the shape
  CVec<T> m_vNorm;      ///< unit, from the shape to the ball
  CVec<T> m_vVelBefore; ///< of the ball, at the impact
  CVec<T> m_vVelAfter;  ///< of the ball
  CVec<T> m_vSurface;   ///< velocity of the shape at the POI, or of the other ball before
  T m_fDepth;           ///< overlap if m_bOverlapped, else 0
};

template <class T>
struct CExactBall {
  CVec<T> m_vPos;
  CVec<T> m_vVel;
  T m_fRadius;
  T m_fMass;
  T m_fElasticity;
  bool m_bIsSensor;
  CFilter m_cFilter;
  bool m_bCanCollide = true;

  /// The size of its coordinates, to which roundings are relative.
  T GetExtent() const { return m_vPos.cwiseAbs().maxCoeff() + m_fRadius; }
};

/// The angle without its whole turns, between -2 pi and 2 pi. Up to 10^15 turns the error is a few roundings
/// of 2 pi.
template <class T>
T TakeTurnsOff(const T& angle);
template <>
double TakeTurnsOff(const double& angle);

/// For double. Other scalars include the headers Reference*.h in one file, specialise TakeTurnsOff and
/// instantiate the class there.
template <class T>
class CReference {
public:
  /// @throws std::invalid_argument naming the field that the library refuses, or if `shapes` has a ball
  CReference(std::span<const CAnyShapeDesc> shapes, std::span<const CDynamicCircleDesc> balls,
             const Vector2& gravity);

  std::size_t GetShapeCount() const { return m_stdShapes.size(); }
  std::size_t GetBallCount() const { return m_stdBalls.size(); }

  // Indices are those of the spans. std::out_of_range is thrown for others.
  const CExactBall<T>& GetBall(std::size_t ball) const { return m_stdBalls.at(ball); }
  void SetBall(std::size_t ball, const CVec<T>& p, const CVec<T>& v);
  void SetBallCanCollide(std::size_t ball, bool b) { m_stdBalls.at(ball).m_bCanCollide = b; }
  void SetCanCollide(std::size_t shape, bool b) { m_stdShapes.at(shape).m_bCanCollide = b; }

  /// Radians from the pose in the descriptor, in [0, 2 pi).
  T GetOrientation(std::size_t shape) const { return m_stdShapes.at(shape).m_fAngle; }
  T GetRotSpeed(std::size_t shape) const { return m_stdShapes.at(shape).m_fRevs; }
  /// The shape as it is now.
  CShapeGeometry<T> GetGeometry(std::size_t shape) const { return m_stdShapes.at(shape).GetGeometry(T(0)); }
  /// @throws std::invalid_argument unless the shape is kinematic and the value is finite
  void SetOrientation(std::size_t shape, const T& angle);
  void SetRotSpeed(std::size_t shape, const T& revsPerSecond);
  /// How far a shape and its rotation centre have moved from where they are described, and their velocity.
  /// @throws std::invalid_argument if it is not finite
  void SetOffset(std::size_t shape, const CVec<T>& way);
  void SetVel(std::size_t shape, const CVec<T>& v);

  /// One step of dt seconds. Events are resolved in the order of their times, and appended in that order:
  /// with e the product of the elasticities and V the velocity of the surface along n, v_n becomes V + e (V -
  /// v_n); two balls exchange the impulse. Simultaneous events come in any order (m_bSimultaneous). A sensor
  /// is reported when it is first touched in the step, a ball that is in it already at time 0.
  ///
  /// After a hit the ball is put exactly onto the shape, a few roundings outside, so positions do not drift
  /// in. In a ring each of these few is towards the middle: the angular momentum loses up to 10^-14 of itself
  /// a hit (1e-15 with a ball of .125 in one of 1). A ball that overlapped stays where it is, unless it
  /// begins to rest or slide (g_fRounded); where its centre was exactly on the shape, it is put some
  /// roundings along the normal.
  ///
  /// A contact becomes permanent if the ball touches without approaching and is accelerated into the shape,
  /// or if it bounces with an elasticity below 1 and its hops have come to their end (g_nMaxClose), or if it
  /// is pressed (g_fPressed). Its normal velocity is removed. Permanent contacts make no events.
  /// From then on the ball keeps its distance to the surface, which may turn and move: its acceleration is
  /// gravity and the forces of what it touches, along the normals, none of which pulls. The contact ends
  /// where its force has fallen to 0, where a hit gives a velocity off the surface, and with the step; the
  /// next one finds it again. Past the end of a side the ball goes on along the round end, and back. All of
  /// this is exact to rounding.
  /// @throws std::runtime_error if there are more than g_nMaxEvents or g_nMaxTurns, or if a ball is crushed
  ///         between shapes, naming ball and place, or if a response (elasticity above 1) gives a speed that
  ///         is not finite; the state is that of no particular time then
  /// @throws std::invalid_argument unless dt is finite and at least 0
  void Step(const T& dt, std::vector<CExactEvent<T>>& events);

  /// Contacts that began to last in a step, since the start, with balls and sides of segments at rest.
  std::size_t GetRestCount() const { return m_nRests; }
  /// The same with everything else: what is round, turns or moves.
  std::size_t GetSlideCount() const { return m_nSlides; }
  /// The force with which the shape, or the ball `other`, which comes after it, pushes the ball at the end of
  /// the last step; 0 without lasting contact.
  T GetForce(std::size_t ball, std::size_t other, bool isBall = false) const;
  /// Ambiguous misses since the start: ways within g_fGraze of a tangent that do not touch.
  std::size_t GetNearMissCount() const { return m_nNearMisses; }

private:
  struct CSolid {
    CShapeGeometry<T> m_cGeometry; // as described
    CVec<T> m_vRotCenter;          // as described
    CVec<T> m_vVel;
    CVec<T> m_vMoved; // by the beginning of the step
    T m_fRevs;
    T m_fAngle;
    T m_fElasticity;
    bool m_bKinematic;
    bool m_bIsSensor;
    CFilter m_cFilter;
    bool m_bCanCollide;
    CVec<T> m_vLow; // box, of all angles if it turns, where it is described
    CVec<T> m_vHigh;

    T GetSpeed() const;
    bool Turns() const { return m_bKinematic && m_fRevs != T(0); }
    bool Moves() const { return Turns() || !(m_vVel.x() == T(0) && m_vVel.y() == T(0)); }
    // At the time t of the step.
    CShapeGeometry<T> GetGeometry(const T& t) const;
    CTurning<T> GetTurning(const T& t) const;
    void SetBox();
  };
  // The next event of a ball: an impact, or the border of the part on which it slides, the end of the force
  // that holds a contact, or the end of the piece of its way.
  enum class eNext { Impact, Border, Release, Piece };
  struct CNext { // at m_cHit.m_fTime in the step
    bool m_bFound = false;
    bool m_bIsBall = false;
    std::size_t m_nOther = 0;
    CHit<T> m_cHit;
    bool m_bTies = false; // another one at the same time, to another side
    eNext m_eNext = eNext::Impact;
  };
  struct CPair { // what has happened between a ball and a shape or ball in this step
    CPair(std::size_t ball, std::size_t other, bool isBall)
        : m_nBall(ball), m_nOther(other), m_bIsBall(isBall) {}
    std::size_t m_nBall;
    std::size_t m_nOther;
    bool m_bIsBall;
    int m_nHits = 0;
    int m_nClose = 0;      // hits in a row that came at once
    T m_fLast = T(-1e300); // time of the last hit
    CVec<T> m_vNorm = CVec<T>::Zero();
    CVec<T> m_vSurface = CVec<T>::Zero();
    T m_fOut = T(0);        // normal speed that the last hit gave
    bool m_bSlides = false; // has become permanent; without a force it does not hold
    bool m_bHolds = false;
    bool m_bSensed = false;
    ePart m_ePart = ePart::Point;
    T m_fReach = T(0);         // the distance that it keeps
    std::vector<T> m_stdForce; // coefficients, from the time of the ball
  };
  // A lasting contact, as it is now.
  struct CHeld {
    CPair* m_pPair = nullptr;
    bool m_bLine = false;
    T m_fSide = T(1); // -1: from inside
    CVec<T> m_vBase;  // from where its distance is measured: of a circle its centre
    CVec<T> m_vNorm;
    CVec<T> m_vSurface; // velocity of the surface, or of the other ball
    CTurning<T> m_cTurning;
  };
  // Where a part of a shape goes over into another one: at a line, or at the circle of the arc.
  struct CBorder {
    CVec<T> m_vAt;
    CVec<T> m_vOut;     // off the part; of a circle 0
    CVec<T> m_vToward;  // Only this side of the line is a border; 0 for all of it.
    ePart m_ePart;      // what comes next
    bool m_bOpen;       // nothing
    T m_fRadius = T(0); // of the circle
    T m_fSide = T(0);   // 1: the part is outside of it
  };
  struct CNear {
    std::size_t m_nBall;
    std::size_t m_nOther;
    bool m_bIsBall;
    T m_fTime;
  };

  // ReferenceStep.h
  CSweptBall<T> GetSwept(std::size_t ball, const T& t) const;
  void Advance(std::size_t ball, const T& t);
  CPair* FindPair(std::size_t ball, std::size_t other, bool isBall);
  CPair& GetPair(std::size_t ball, std::size_t other, bool isBall);
  [[noreturn]] void Jammed(std::size_t ball) const;
  [[noreturn]] void TooFast(std::size_t ball) const;
  // ReferenceMeet.h: what comes next
  void FindNext(std::size_t ball);
  void FindAfter();
  void MeetShapes(std::size_t ball, CNext& next);
  void MeetBall(std::size_t ball, std::size_t other, CNext& next);
  bool IsNegligible(std::size_t ball, std::size_t other, bool isBall, const CHit<T>& hit);
  bool AreApart(std::size_t ball, bool isBall0, std::size_t other0, const CHit<T>& hit0, bool isBall1,
                std::size_t other1, const CHit<T>& hit1) const;
  void Offer(CNext& next, bool found, bool isBall, std::size_t ball, std::size_t other, const CHit<T>& hit);
  void CountNearMisses(const T& now);
  // ReferenceAnswer.h: what an impact does
  void Answer(std::size_t ball, const CNext& next, std::vector<CExactEvent<T>>& events, std::size_t first);
  void AnswerShape(const CHit<T>& hit, CPair& pair, CExactEvent<T>& event);
  void AnswerBall(const CHit<T>& hit, CPair& pair, CExactEvent<T>& event);
  bool Begins(const CHit<T>& hit, const CPair& pair) const;
  T Kick(CPair& pair);
  bool Slides(CPair& pair, const T& e, const T& approach, bool pressed);
  void BeginHold(CPair& pair, ePart part);
  // ReferenceRest.h: contacts that last, and their forces
  T Slow(const CPair& pair) const;
  CHeld MakeHeld(CPair& pair);
  void SetReach(CPair& pair);
  void GatherHeld();
  T SpeedOff(const CHeld& held) const;
  void Push(const CHeld& held, const T& impulse);
  CMatrix<T> GetMasses() const;
  void Settle();
  void CheckHolds();
  void Shift(const CPair& pair, const CVec<T>& way);
  void Straighten();
  void Continue();
  void Support();
  [[noreturn]] void Crushed(std::size_t ball) const;
  // ReferenceSlide.h: the way of balls that are held, and where it ends
  void Slide();
  void MeetLimits(std::size_t ball, CNext& next) const;
  void MeetBorders(const CPair& pair, CNext& next) const;
  std::vector<CBorder> GetBorders(const CPair& pair, const CShapeGeometry<T>& f) const;
  void PassLimit(std::size_t ball, const CNext& next);

  std::vector<CSolid> m_stdShapes;
  std::vector<CExactBall<T>> m_stdBalls;
  CVec<T> m_vGravity;
  std::size_t m_nRests = 0;
  std::size_t m_nSlides = 0;
  std::size_t m_nNearMisses = 0;

  // Of the step that is going on.
  T m_fStep = T(0);
  T m_fNow = T(0);
  T m_fSpeeds = T(0);              // of the last hit, before it
  std::vector<T> m_stdTime;        // of each ball: when it is where m_stdBalls says
  std::vector<CVec<T>> m_stdAcc;   // of each ball, then
  std::vector<CMore<T>> m_stdMore; // by which its way differs from the parabola
  std::vector<T> m_stdUntil;       // up to when that holds
  std::vector<CNext> m_stdNext;
  std::vector<CPair> m_stdPairs;
  std::vector<CNear> m_stdNear;
  std::vector<std::size_t> m_stdChanged; // balls with new velocities or accelerations
  std::vector<CHeld> m_stdHeld;          // their contacts
};

} // namespace Shapes::Compare
