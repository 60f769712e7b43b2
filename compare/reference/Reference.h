// SPDX-License-Identifier: MIT
// The exact reference: balls that are carried through time steps from event to event, each at its time of
// impact. Both engines are held against it.
//
// Gravity is applied as the engines apply it: at the start of each step v += g dt, then the balls move on
// straight lines for dt. What is exact is what happens within the step. (A later version will follow
// parabolas.)
//
// What is solid is told in Sweep.h; in particular the ends of segments and arcs are round and solid here,
// which they are not in the native engine's approximate mode.
#pragma once

#include "Sweep.h"

#include <Shapes/World.h>

#include <cstddef>
#include <span>
#include <vector>

namespace Shapes::Compare {

/// Most events in one step. More means that a ball is jammed, and the step throws.
inline constexpr std::size_t g_nMaxEvents = 1000;
/// The same for all hits, those of sliding balls included.
inline constexpr int g_nMaxSlideHits = 10000;

/// Hits of one ball on one shape in one step after which it slides if their elasticity is below 1: its hops
/// are a geometric series that ends within the step.
inline constexpr int g_nMaxHits = 50;

/// The same where this many hits in a row come within g_fClose of the step.
inline constexpr int g_nMaxClose = 4;
inline constexpr double g_fClose = 1e-9;

/// An approach of a sliding ball that would take it into the shape by less than this share of its coordinates
/// by the end of the step is no hit, dimensionless. The next hit puts it back onto the shape, so it adds up
/// to nothing; overlaps of up to twice this are not reported.
inline constexpr double g_fRest = 1e-12;

/// A ball slides at once if it meets the inside of a curve, or a turning shape, at less than this share of
/// the speeds involved: it is pressed against it, and would hit it again immediately. Dimensionless.
inline constexpr double g_fPressed = 1e-6;

/// Hops in one step of a ball that slides inside a curve or is pushed by a turning shape.
inline constexpr int g_nSlideHops = 16;

/// One impact.
struct CExactEvent {
  double m_fTime;       ///< Seconds from the start of the step.
  std::size_t m_nBall;  ///< Index of the ball; of two balls the lower one.
  std::size_t m_nShape; ///< Index of the shape, or of the other ball.
  bool m_bIsBall;       ///< m_nShape is a ball.
  bool m_bIsSensor;     ///< Either is a sensor: there was no response.
  bool m_bGraze;        ///< Ambiguous, see CHit.
  bool m_bOverlapped;   ///< They overlapped already: no impact has been seen, and the position is kept.
  ePart m_ePart;        ///< What was met of the shape.
  CVec2d m_vCenter;     ///< of the ball at the impact, user units
  CVec2d m_vPOI;        ///< on the shape
  CVec2d m_vNorm;       ///< unit, from the shape to the ball
  CVec2d m_vVelBefore;  ///< of the ball, after the gravity of this step
  CVec2d m_vVelAfter;   ///< of the ball
  CVec2d m_vSurface;    ///< velocity of the shape at the POI, or of the other ball before
  double m_fDepth;      ///< overlap if m_bOverlapped, else 0
};

struct CExactBall {
  CVec2d m_vPos;
  CVec2d m_vVel;
  double m_fRadius;
  double m_fMass;
  double m_fElasticity;
  bool m_bIsSensor;
  bool m_bCanCollide = true;

  /// The size of its coordinates, to which roundings are relative.
  double GetExtent() const { return m_vPos.cwiseAbs().maxCoeff() + m_fRadius; }
};

class CReference {
public:
  /// @throws std::invalid_argument naming the field that the library refuses, or if `shapes` has a ball
  CReference(std::span<const CAnyShapeDesc> shapes, std::span<const CDynamicCircleDesc> balls,
             const Vector2& gravity);

  std::size_t GetShapeCount() const { return m_stdShapes.size(); }
  std::size_t GetBallCount() const { return m_stdBalls.size(); }

  // Indices are those of the spans. std::out_of_range is thrown for others.
  const CExactBall& GetBall(std::size_t ball) const { return m_stdBalls.at(ball); }
  void SetBall(std::size_t ball, const CVec2d& p, const CVec2d& v);
  void SetBallCanCollide(std::size_t ball, bool b) { m_stdBalls.at(ball).m_bCanCollide = b; }
  void SetCanCollide(std::size_t shape, bool b) { m_stdShapes.at(shape).m_bCanCollide = b; }

  /// Radians from the pose in the descriptor, in [0, 2 pi).
  double GetOrientation(std::size_t shape) const { return m_stdShapes.at(shape).m_fAngle; }
  double GetRotSpeed(std::size_t shape) const { return m_stdShapes.at(shape).m_fRevs; }
  /// The shape as it is now.
  CFigure<double> GetFigure(std::size_t shape) const;
  /// @throws std::invalid_argument unless the shape is kinematic and the value is finite
  void SetOrientation(std::size_t shape, double angle);
  void SetRotSpeed(std::size_t shape, double revsPerSecond);

  /// One step of dt seconds. Events are answered in the order of their times, and appended in that order:
  /// with e the product of the elasticities and V the velocity of the surface along n, v_n becomes V + e (V -
  /// v_n); two balls exchange the impulse. Simultaneous events come in any order. A sensor is reported when
  /// it is first touched in the step, a ball that is in it already at time 0.
  ///
  /// After a hit the ball is put exactly onto the shape, a few roundings outside, so positions do not drift
  /// in. A ball that overlapped stays where it is.
  ///
  /// A ball slides for the rest of the step if it is pressed (g_fPressed), or if the elasticity is below 1
  /// and it was hit more than g_nMaxHits times or g_nMaxClose times at once: its normal velocity is removed.
  /// Where the surface curves or turns towards it, it gets instead what lets it hop g_nSlideHops times in a
  /// step. The hits of a sliding ball are no events. What hopping costs is of the order of (v dt /
  /// g_nSlideHops)^2 / (8 R) in position.
  /// @throws std::runtime_error if there are more than g_nMaxEvents or g_nMaxSlideHits, naming ball and
  /// place; the state is that
  ///         of no particular time then
  /// @throws std::invalid_argument unless dt is finite and at least 0
  void Step(double dt, std::vector<CExactEvent>& events);

  /// Pairs of a ball and a shape that began to slide in a step, and their hits without an event, since the
  /// start. Where they are not 0, the trajectory is not that of free balls.
  std::size_t GetSlideCount() const { return m_nSlides; }
  std::size_t GetSlideHits() const { return m_nSlideHits; }
  /// Ambiguous misses since the start: ways within g_fGraze of a tangent that do not touch.
  std::size_t GetNearMissCount() const { return m_nNearMisses; }

private:
  struct CSolid {
    CFigure<double> m_cFigure; // as described
    CVec2d m_vRotCenter;
    double m_fRevs;
    double m_fAngle;
    double m_fElasticity;
    bool m_bKinematic;
    bool m_bIsSensor;
    bool m_bCanCollide;
    CVec2d m_vLow; // box, of all angles if it turns
    CVec2d m_vHigh;

    double GetSpeed() const;
    bool Turns() const { return m_bKinematic && m_fRevs != 0.0; }
    CFigure<double> GetFigure(double t) const;
    void SetBox();
  };
  struct CNext { // the next impact of a ball, at m_cHit.m_fTime in the step
    bool m_bFound = false;
    bool m_bIsBall = false;
    std::size_t m_nOther = 0;
    CHit<double> m_cHit;
  };
  struct CPair { // what has happened between a ball and a shape or ball in this step
    CPair(std::size_t ball, std::size_t other, bool isBall)
        : m_nBall(ball), m_nOther(other), m_bIsBall(isBall) {}
    std::size_t m_nBall;
    std::size_t m_nOther;
    bool m_bIsBall;
    int m_nHits = 0;
    int m_nClose = 0;        // hits in a row that came at once
    double m_fLast = -1e300; // time of the last hit
    CVec2d m_vNorm = CVec2d::Zero();
    CVec2d m_vSurface = CVec2d::Zero();
    double m_fOut = 0.0; // normal speed that the last hit gave
    bool m_bSlides = false;
    bool m_bSensed = false;
  };
  struct CNear {
    std::size_t m_nBall;
    std::size_t m_nOther;
    bool m_bIsBall;
    double m_fTime;
  };

  CSweptBall<double> GetSwept(std::size_t ball, double t) const;
  void FindNext(std::size_t ball);
  void MeetShapes(std::size_t ball, CNext& next);
  void MeetBall(std::size_t ball, std::size_t other, CNext& next);
  bool IsNegligible(std::size_t ball, std::size_t other, bool isBall, const CHit<double>& hit);
  void Offer(CNext& next, bool found, bool isBall, std::size_t ball, std::size_t other,
             const CHit<double>& hit);
  void FindAfter();
  void Answer(std::size_t ball, const CNext& next, std::vector<CExactEvent>& events);
  void AnswerShape(const CHit<double>& hit, CPair& pair, CExactEvent& event);
  void AnswerBall(const CHit<double>& hit, CPair& pair, CExactEvent& event);
  double Kick(CPair& pair);
  void Settle();
  bool Slides(CPair& pair, double e, bool pressed);
  double HopSpeed(const CExactBall& ball, const CSolid& solid, const CHit<double>& hit) const;
  CPair* FindPair(std::size_t ball, std::size_t other, bool isBall);
  CPair& GetPair(std::size_t ball, std::size_t other, bool isBall);
  void CountNearMisses(double now);
  [[noreturn]] void Jammed(std::size_t ball) const;

  std::vector<CSolid> m_stdShapes;
  std::vector<CExactBall> m_stdBalls;
  CVec2d m_vGravity;
  std::size_t m_nSlides = 0;
  std::size_t m_nSlideHits = 0;
  std::size_t m_nNearMisses = 0;

  // Of the step that is going on.
  double m_fStep = 0.0;
  double m_fNow = 0.0;
  std::vector<double> m_stdTime; // of each ball: when it is where m_stdBalls says
  std::vector<CNext> m_stdNext;
  std::vector<CPair> m_stdPairs;
  std::vector<CNear> m_stdNear;
  std::vector<std::size_t> m_stdChanged;  // balls with new velocities
  std::vector<std::size_t> m_stdSettling; // pairs
};

} // namespace Shapes::Compare
