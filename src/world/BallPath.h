// SPDX-License-Identifier: MIT
// The path of a ball during a substep, and how close it comes to what a sensor watches. All of it in double:
// lengths err by a few roundings of the coordinates.
#pragma once

#include <Shapes/Shape.h>

#include "../geometry/Vector.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <vector>

namespace Shapes {

/// Where a ball was at a time that is given as the share of the substep that was over, 0 .. 1.
struct CPathVertex {
  double m_fTime;
  Vector2d m_vPos;
};

/// At least one point; times do not fall, and it is straight in between.
using CBallPath = std::span<const CPathVertex>;

CBox2d GetBox(CBallPath path);

/// The place at time t, 0 .. 1; of several the first.
Vector2d GetPos(CBallPath path, double t);

/// Units per substep before the ball was where it was at time t; zero if no time passed.
Vector2d GetVelocity(CBallPath path, double t);

/// The path of a as b sees it, which does not turn.
void MakeRelativePath(CBallPath a, CBallPath b, std::vector<CPathVertex>& relative);

/// The path of a ball of radius r as a shape sees it that during the substep turns by `turn` radians about
/// `center`, which moves by `move` and is at `center` at the end: in the frame in which the shape is then.
/// Cut into straight parts that err by at most g_fRotatedPathError radii, unless that took more than
/// g_nMaxTurnParts for one part of the path.
void MakeRotatedPath(CBallPath path, const Vector2d& center, double turn, const Vector2d& move, double r,
                     std::vector<CPathVertex>& turned);

/// p turned about center.
Vector2d Turn(const Vector2d& p, const Vector2d& center, double angle);

/// The zone of a sensor: a point, a segment or an arc with their ends, or a disk.
class CZone {
public:
  /// A circle is the disk in it; sides do not matter.
  explicit CZone(const CShape& shape);
  CZone(const Vector2d& center, double radius) : m_eType(eShape::Circle), m_vPos(center), m_fRadius(radius) {}

  CBox2d GetBox() const;

  /// Where a ball touches the zone.
  struct CTouch {
    bool m_bAtEnd;    ///< It does at the end of the path.
    double m_fTime;   ///< The end of the path, or the first time when it was closest.
    Vector2d m_vPOI;  ///< The point of the zone closest to its centre then; of a disk the one of the rim.
    Vector2d m_vNorm; ///< Unit, from there to the centre.
  };
  /// Whether a ball of radius r comes closer to the zone than r on its path, which has two points at least.
  std::optional<CTouch> Touch(CBallPath path, double r) const;

  struct CApproach {
    double m_fDistance; ///< From the centre to the zone; in a disk as far below 0 as the rim is away.
    double m_fTime;
    Vector2d m_vPos; ///< of the centre
  };
  /// The closest approach on a path of two points at least, the first of several. The distance is exactly 0
  /// where the path crosses a segment or an arc.
  CApproach Approach(CBallPath path) const;

private:
  CTouch TouchAt(const CApproach& at, const Vector2d& velocity, bool atEnd) const;
  bool PtInSector(const Vector2d& p) const;

  eShape m_eType;
  Vector2d m_vPos;                    // the point; the centre of a circle or an arc
  Vector2d m_vPt0 = Vector2d::Zero(); // the ends of a segment or an arc
  Vector2d m_vPt1 = Vector2d::Zero();
  Vector2d m_vFront = Vector2d::Zero(); // normal of a segment
  double m_fRadius = 0.0;
  double m_fSpan = 0.0; // of an arc
  bool m_bFull = false;
};

} // namespace Shapes
