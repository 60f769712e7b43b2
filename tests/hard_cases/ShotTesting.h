// SPDX-License-Identifier: MIT
// One ball that flies at something, asked of a world or of the reference: when it was met, and how it left.
#pragma once

#include "StepTesting.h"

#include "reference/Vec2.h"

namespace Shapes::HardCases {

using Compare::CVec2d;

/// Roundings: of the reference, and of the engines.
inline constexpr double g_fEps = 0x1p-52;
inline constexpr double g_fFloatEps = 0x1p-23;

struct CShot {
  std::vector<CAnyShapeDesc> m_stdShapes;
  std::vector<CDynamicCircleDesc> m_stdBalls; ///< The first is asked, relative to the second if there is one.
  float m_fSeconds = 1.0f;
  unsigned m_nSteps = 1; ///< Parts of the time on native.
  /// On Box2D, which moves a ball by at most 2 metres in a step; 0: the same.
  unsigned m_nBox2DSteps = 0;
  Vector2 m_vGravity = Vector2::Zero();
  std::optional<CVec2d> m_vExactPos = {}; ///< Where the reference has the ball: at what is no float.
};

/// What a user sees of it.
struct CSeen {
  std::size_t m_nContacts = 0; ///< Those that were told.
  CVec2d m_vPos, m_vVel;       ///< At the end.
  /// When it bounced, if it flew straight before and after: by place and velocity at the end. NaN if its
  /// velocity is what it was.
  double m_fTime = std::numeric_limits<double>::quiet_NaN();
  /// Of the first contact at which it approached.
  CVec2d m_vPOI = CVec2d::Constant(m_fTime), m_vNorm = m_vPOI;
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

/// What deviates by this figure: held to between half of it and twice of it.
CExpect Off(double figure, const std::string& figureAndReason);
/// What is not met at all.
CExpect Missed(const std::string& reason);
CExpect& Of(CHardCase& c, eColumn column);
/// The rest of a case whose bound and error are known. @param right  "": that of c
CHardCase Named(CHardCase c, const std::string& name, const std::string& input, const std::string& right,
                const std::vector<std::pair<eColumn, CExpect>>& deviations, const std::string& control,
                const std::function<double()>& fnControl);

/// A case whose right answer is time, normal and velocity, each within 8 roundings.
CHardCase ShotCase(const CShot& shot, const CAnswer& answer);

} // namespace Shapes::HardCases
