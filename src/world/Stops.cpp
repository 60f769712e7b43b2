// SPDX-License-Identifier: MIT
#include "Stops.h"

#include "../Tolerances.h"
#include "../shapes/Validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace Shapes {
namespace {

constexpr double g_fWholeTurn = 2.0 * std::numbers::pi;
constexpr double g_fNever = std::numeric_limits<double>::infinity();

// One coordinate or the angle, its stops, and the speed that drives it: units or radians per second. The size
// is that of which floats are rounded.
struct CAxis {
  double m_fNow, m_fLeast, m_fMost, m_fSpeed, m_fSize;

  double GetStop() const { return m_fSpeed > 0.0 ? m_fMost : m_fLeast; }
  // Never negative: what is beyond its stop rests.
  double GetTime() const {
    if (m_fSpeed == 0.0 || !std::isfinite(GetStop())) return g_fNever;
    return std::max(0.0, (GetStop() - m_fNow) / m_fSpeed);
  }
  // Its speed as a share of what drives it.
  double GetShare(double dt) const {
    const double time = GetTime();
    // One that arrives exactly with the end keeps its bits.
    return time >= dt * (1.0 - g_fStopRounding) ? 1.0 : time / dt;
  }
  // The stop to which it has come, but for rounding, in the last dt seconds; else where it is.
  double Snapped(double dt) const {
    const double near = g_fStopRounding * std::abs(m_fSpeed) * dt + 0x1p-22 * m_fSize;
    return m_fSpeed != 0.0 && std::abs(m_fNow - GetStop()) <= near ? GetStop() : m_fNow;
  }
};

// The orientation as an angle near the stops, which it is within a turn of.
CAxis AngleOf(const CShapeEntry& entry) {
  const CMotionLimits& limits = entry.m_cLimits;
  const double least = limits.m_fLeastAngle, most = limits.m_fMostAngle;
  const float angle = entry.m_pShape->GetOrientation();
  double now = angle;
  if (std::isfinite(least)) {
    now += g_fWholeTurn * std::round((0.5 * (least + most) - now) / g_fWholeTurn);
    for (const float stop : {limits.m_fLeastAngle, limits.m_fMostAngle})
      if (angle == NormalizeAngle(stop)) now = stop; // which has rounded it
  }
  return {now, least, most, g_fWholeTurn * static_cast<double>(entry.m_fRotSpeed), g_fWholeTurn};
}

CAxis CoordinateOf(const CShapeEntry& entry, int axis) {
  const double now = entry.m_pShape->GetRotCenter()[axis];
  return {now, entry.m_cLimits.m_vLeastCenter[axis], entry.m_cLimits.m_vMostCenter[axis], entry.m_vVel[axis],
          std::abs(now)};
}

} // namespace

// The quiet comparisons: what is not a number is to be refused, not to trap.
void RequireLimits(const CMotionLimits& limits, eMotion motion) {
  const float least = limits.m_fLeastAngle, most = limits.m_fMostAngle;
  const bool isFree = least == -std::numeric_limits<float>::infinity() && most == -least;
  const bool isPair = std::isfinite(least) && std::isfinite(most) && least <= most &&
                      static_cast<double>(most) - static_cast<double>(least) < g_fWholeTurn;
  if (!isFree && !isPair)
    Refuse("m_cLimits", "from " + ToText(least) + " to " + ToText(most) + " radians",
           "two angles in ascending order, less than a whole turn apart");
  for (const int axis : {0, 1})
    if (!std::islessequal(limits.m_vLeastCenter[axis], limits.m_vMostCenter[axis]))
      Refuse("m_cLimits", "from " + ToText(limits.m_vLeastCenter) + " to " + ToText(limits.m_vMostCenter),
             "two places");
  if (motion != eMotion::Kinematic && limits != CMotionLimits())
    Refuse("m_cLimits", "set", "none: only a kinematic shape has stops");
}

double GetTimeToStop(const CShapeEntry& entry) {
  double first = g_fNever;
  for (const CAxis& axis : {AngleOf(entry), CoordinateOf(entry, 0), CoordinateOf(entry, 1)})
    if (axis.GetTime() > 0.0) first = std::min(first, axis.GetTime());
  return first;
}

CDrive GetDrive(const CShapeEntry& entry, float dt) {
  const auto slowed = [dt](float speed, const CAxis& axis) {
    const double share = axis.GetShare(static_cast<double>(dt));
    return share == 1.0 ? speed : static_cast<float>(share * static_cast<double>(speed));
  };
  return {
      {slowed(entry.m_vVel.x(), CoordinateOf(entry, 0)), slowed(entry.m_vVel.y(), CoordinateOf(entry, 1))},
      slowed(entry.m_fRotSpeed, AngleOf(entry))};
}

bool HasCome(const CShapeEntry& entry, float dt) {
  const auto hasCome = [dt](const CAxis& axis) {
    return axis.m_fSpeed != 0.0 && axis.Snapped(static_cast<double>(dt)) == axis.GetStop();
  };
  return (entry.m_pShape->GetRotating() && hasCome(AngleOf(entry))) ||
         (entry.m_pShape->GetVel().x() != 0.0f && hasCome(CoordinateOf(entry, 0))) ||
         (entry.m_pShape->GetVel().y() != 0.0f && hasCome(CoordinateOf(entry, 1)));
}

void SnapToStops(CShapeEntry& entry, float dt) {
  const auto snapped = [dt](const CAxis& axis) {
    return static_cast<float>(axis.Snapped(static_cast<double>(dt)));
  };
  const Vector2 center(snapped(CoordinateOf(entry, 0)), snapped(CoordinateOf(entry, 1)));
  entry.m_pShape->SetPose(center, snapped(AngleOf(entry)));
  entry.SetDrive(GetDrive(entry, dt));
}

} // namespace Shapes
