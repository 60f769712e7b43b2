// SPDX-License-Identifier: MIT
// Scenes that are stepped, by a world of a column or by the exact reference; and shots, in which one ball
// flies at something: when it was met, and how it left.
#pragma once

#include "HardCase.h"

#include <reference/Reference.h>
#include <reference/Scalar.h>

namespace Shapes::HardCases {

using Compare::CFifty;
using Compare::CVec;

/// Half a unit in the last place of 1, of a float and of a double: one rounding.
inline constexpr double g_fFloatRounding = 0x1p-24;
inline constexpr double g_fDoubleRounding = 0x1p-53;

/// A contact of the last step.
struct CImpact {
  Vector2d m_vPOI, m_vNorm; ///< The normal points to the ball.
  double m_fSetback;        ///< Overlap that it tells of.
  bool m_bApproaches;
  double m_fTime = 0.0; ///< Seconds from the start of the step, of the reference only.
};

/// A scene in the hands of one column.
class CStepped {
public:
  CStepped(eColumn column, const std::vector<CAnyShapeDesc>& shapes,
           const std::vector<CDynamicCircleDesc>& balls, float dt = g_fDt,
           const Vector2& gravity = Vector2::Zero());

  void Step(int times = 1);
  Vector2d GetPos(std::size_t ball = 0) const;
  Vector2d GetVel(std::size_t ball = 0) const;
  /// Puts a ball there, in a world rounded to float; it keeps its velocity.
  void SetPos(std::size_t ball, const Vector2d& p);
  void SetOrientation(std::size_t shape, float angle);
  std::vector<CImpact> GetImpacts() const;
  /// nullptr for the reference.
  const CWorld* GetWorld() const { return m_pWorld.get(); }
  /// Only of Reference.
  const Compare::CReference<double>& GetReference() const { return *m_cReference; }
  CShapeId GetShapeId(std::size_t shape) const { return m_stdIds[shape]; }

private:
  float m_fTimeStep;
  std::size_t m_nShapes;
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdIds; // the shapes, then the balls
  std::optional<Compare::CReference<double>> m_cReference;
  std::vector<Compare::CExactEvent<double>> m_stdEvents;
};

/// On y = 0.
inline const CLineSegDesc g_cFloor({-1.0f, 0.0f}, {1.0f, 0.0f});

/// Off by how much a ball is: in place, or in velocity relative to the speed that it should have.
inline double OffBy(const CStepped& stepped, const Vector2d& p, const Vector2d& v, std::size_t ball = 0) {
  return Worst(Distance(stepped.GetPos(ball), p), Distance(stepped.GetVel(ball), v) / v.norm());
}

/// (x, y) turned by `angle` radians, rounded to float.
inline Vector2 Turned(double x, double y, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y)};
}

struct CShot {
  std::vector<CAnyShapeDesc> m_stdShapes;
  std::vector<CDynamicCircleDesc> m_stdBalls; ///< The first is asked, relative to the second if there is one.
  float m_fSeconds = 1.0f;
  unsigned m_nSteps = 1; ///< Parts of the time on native.
  /// On Box2D, which moves a ball by at most 2 metres in a step; 0: the same.
  unsigned m_nBox2DSteps = 0;
  Vector2 m_vGravity = Vector2::Zero();
  std::optional<Vector2d> m_vExactPos = {}; ///< Where the reference has the ball: at what is no float.
};

/// The part of it that a user sees.
struct CSeen {
  std::size_t m_nContacts = 0; ///< Those that were told.
  Vector2d m_vPos, m_vVel;     ///< At the end.
  /// When it bounced, if it flew straight before and after: by place and velocity at the end. NaN if its
  /// velocity is what it was.
  double m_fTime = std::numeric_limits<double>::quiet_NaN();
  /// Of the first contact at which it approached.
  Vector2d m_vPOI = Vector2d::Constant(m_fTime), m_vNorm = m_vPOI;
  /// When its centre was where that contact has it, along its first velocity.
  double m_fContactTime = m_fTime;
  double m_fSetback = 0.0; ///< Overlap that the contact tells of.
};

CSeen Shoot(eColumn column, const CShot& shot);

/// The right answer, at 50 digits from the rounded input. Elasticities are 1.
struct CAnswer {
  CFifty m_fTime;
  CVec<CFifty> m_vNorm, m_vVel; ///< Velocity after the impact.
};

/// The ball meets a disc of radius R about the origin from outside: the textbook's quadratic, which 50 digits
/// can afford.
CAnswer MeetDisc(const CDynamicCircleDesc& ball, float R);
/// It meets a circle about the origin from inside.
CAnswer MeetRing(const CDynamicCircleDesc& ball, float R);
/// It meets the line y = 0 from above.
CAnswer MeetFloor(const CDynamicCircleDesc& ball);

/// Largest error of time, normal and velocity. Infinite if the ball flew on.
double ErrorOf(const CSeen& seen, const CAnswer& answer);
/// Of a ball that is to fly on: largest error of place and velocity, and the number of contacts that were
/// told.
double ErrorOfFlight(const CSeen& seen, const CShot& shot);

/// A case whose right answer is time, normal and velocity, each within 8 roundings.
CHardCase ShotCase(const CShot& shot, const CAnswer& answer);

} // namespace Shapes::HardCases
