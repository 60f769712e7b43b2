// SPDX-License-Identifier: MIT
// The base class of all shapes, and that of the descriptors from which they are made.
#pragma once

#include <Shapes/Aabb2D.h>
#include <Shapes/Filter.h>
#include <Shapes/Limits.h>
#include <Shapes/MotionLimits.h>
#include <Shapes/ShapeMath.h>

#include <memory>

namespace Shapes {

class CContactDesc;

enum class eShape { Point, LineSeg, Circle, Arc };

/// Static shapes stay, kinematic shapes move and turn at given speeds, dynamic shapes (balls) move and
/// respond.
enum class eMotion { Static, Kinematic, Dynamic };

/// Which faces of a segment or an arc are solid. Front is the side to which the normal points: of a segment
/// as it is made upward, of a vertical one to the left, in whatever order its ends are given (CLineSeg); of
/// an arc outward. Back is the other one. A ball that comes from the open side passes (one-way gates). The
/// front of MakePolyline is to the left of the way along its points.
enum class eSides { Both, Front, Back };

/// Gravity and time step that CShape::move uses. A game sets them by deriving from this class. A CWorld has
/// its own and never reads these.
class CShapeCommon {
protected:
  static float
      m_fGravity; ///< y component of gravity, units per second squared; negative pulls down. Default 0.
  static float m_fTimeStep; ///< Seconds per call of move. Default 1/60.
};

/// Base of all descriptors. Shapes check the values when they are made: what is not finite or too large, and
/// negative radii, masses and elasticities, are refused with std::invalid_argument naming the field and the
/// value; CWorld::Add also refuses a static shape with a speed or stops, and a ball that turns or has stops.
class CShapeDesc {
public:
  eShape m_eShapeType;              ///< Set by the constructors of the derived descriptors.
  Vector2 m_vPos = Vector2::Zero(); ///< Position, user units. Segments: the midpoint, follows the ends.
  float m_fElasticity = 1.0f;       ///< 0 keeps no normal speed, 1 all of it, above 1 adds (bumpers).
  eMotion m_eMotionType = eMotion::Static; ///< Static or Kinematic; balls have a descriptor of their own.
  bool m_bIsSensor = false;                ///< Detects, but neither responds nor causes a response.
  CFilter m_cFilter;                       ///< What it meets.
  /// Kinematic and dynamic: units per second. The rotation centre of a kinematic shape moves along.
  Vector2 m_vVel = Vector2::Zero();
  float m_fRotSpeed = 0.0f;               ///< Kinematic: revolutions per second, counterclockwise.
  Vector2 m_vRotCenter = Vector2::Zero(); ///< Kinematic: centre of the rotation, user units.
  CMotionLimits m_cLimits;                ///< Kinematic, in a world: its stops.

protected:
  explicit CShapeDesc(eShape e) : m_eShapeType(e) {}
};

/// Base of all shapes. A shape is made from its descriptor, by the class that fits its motion.
class CShape : public CShapeCommon {
public:
  virtual ~CShape() = default;

  /// A copy with the same pose and properties.
  virtual std::unique_ptr<CShape> Clone() const = 0;

  eShape GetShapeType() const { return m_eShapeType; }
  eMotion GetMotionType() const { return m_eMotionType; }
  /// The smallest box around the shape as it is now. Exact for points and segments; of circles each side is
  /// rounded once, so within half an ulp of the coordinate, either way; of arcs within 4 ulp of |centre| +
  /// radius. The box of an arc whose ends are opposite to each other, within rounding, may reach as far
  /// beyond them as CArc::PtInSector does: it is within 12 ulp.
  const CAabb2D& GetAABB() const { return m_cAabb; }

  const Vector2& GetPos() const { return m_vPos; }
  /// Moves the shape so that its position is p; the ends of segments and arcs go with it. With its next move
  /// a kinematic shape jumps back to where it comes from its pose at construction: Relocate keeps the new
  /// place. Far away points are rounded, and the shape comes back as another; Relocate brings back the same.
  /// @throws std::invalid_argument if p is not finite or too large (g_fMaxLength)
  void SetPos(const Vector2& p);

  bool GetSensor() const { return m_bIsSensor; }
  void SetSensor(bool b) { m_bIsSensor = b; }
  bool GetCanCollide() const { return m_bCanCollide; }
  /// Turns collisions off (a post that sinks into the table) and on again.
  void SetCanCollide(bool b = true) { m_bCanCollide = b; }
  const CFilter& GetFilter() const { return m_cFilter; }
  void SetFilter(const CFilter& filter) { m_cFilter = filter; }
  float GetElasticity() const { return m_fElasticity; }
  /// @throws std::invalid_argument unless 0 <= e <= g_fMaxElasticity
  void SetElasticity(float e);
  void* GetUserPtr() const { return m_pUser; }
  void SetUserPtr(void* p) { m_pUser = p; }

  /// Moves the shape so that its position is p, until Reset: its rotation centre moves along, and rotations
  /// start from the moved pose. Every point, and the centre, are within 3 ulp of |p| + |centre| of where they
  /// belong, wherever the shape has been before.
  /// @throws std::invalid_argument if p or the moved centre is not finite or too large (g_fMaxLength)
  void Relocate(const Vector2& p);

  /// Turns a kinematic shape about center to `angle` radians from its pose at construction (not from its
  /// present one). Static shapes and balls stay as they are. Error of every point, ends and centres, at most
  /// 3 ulp of |center| + its distance from center, for |angle| up to 1e9.
  virtual void Rotate(const Vector2& center, float angle);
  /// Moves a kinematic shape so that its rotation centre is at `center`, and turns it to `angle` about that:
  /// exactly, wherever it was. Others stay.
  void SetPose(const Vector2& center, float angle);
  /// Puts a kinematic shape back to its pose at construction, bit for bit.
  virtual void Reset();
  /// One step of m_fTimeStep: a kinematic shape moves by its velocity and turns by its rotation speed about
  /// its centre, a ball moves.
  virtual void move() { Advance(m_fTimeStep); }
  /// Moves and turns a kinematic shape for dt seconds. Others stay. Of many steps only the last one is
  /// rounded: the place errs by at most 2 ulp of itself, the orientation by 1 ulp of 2 pi. A shape whose
  /// position or rotation centre would get beyond `maxLength` stays where it is.
  void Advance(float dt, float maxLength = g_fMaxLength);

  /// Whether the shape turns by itself: kinematic with a rotation speed other than 0.
  bool GetRotating() const { return m_eMotionType == eMotion::Kinematic && m_fRotSpeed != 0.0f; }
  /// Whether it moves or turns by itself: kinematic with a velocity or a rotation speed other than 0.
  bool GetMoving() const;
  /// Radians from the pose at construction, in [0, 2 pi).
  float GetOrientation() const { return m_fOrientation; }
  /// Same as Rotate(GetRotCenter(), angle).
  void SetOrientation(float angle) { Rotate(m_vRotCenter, angle); }
  /// Of a kinematic shape with its rotation centre, units per second; (0, 0) for a static one.
  const Vector2& GetVel() const { return m_vVel; }
  /// @throws std::invalid_argument if v is not finite or faster than g_fMaxSpeed, or other than (0, 0) for a
  /// static shape
  void SetVel(const Vector2& v);
  /// Revolutions per second, counterclockwise.
  float GetRotSpeed() const { return m_fRotSpeed; }
  /// @throws std::invalid_argument unless |revolutions per second| <= g_fMaxRotSpeed, or if it is not 0 for a
  /// static shape
  void SetRotSpeed(float revsPerSecond);
  const Vector2& GetRotCenter() const { return m_vRotCenter; }
  /// @throws std::invalid_argument if center is not finite or too large (g_fMaxLength)
  void SetRotCenter(const Vector2& center);
  /// Radians by which the last move or Advance turned the shape, not reduced; 0 after any other change of
  /// pose.
  float GetLastTurn() const { return m_fLastTurn; }
  /// Likewise, by how much they moved it, and its rotation centre.
  const Vector2& GetLastMove() const { return m_vLastMove; }

  /// Velocity of the point p of this shape, user units per second: its velocity + 2 pi rotation speed
  /// perp(p - centre) for a kinematic shape, zero for a static one. Each component within 3 ulp of the larger
  /// of both.
  Vector2 GetSurfaceVelocity(const Vector2& p) const;

  /// Whether c.m_pCircle meets this shape, by the default engine; fills in c if so. See
  /// CBackend::CollisionDetected.
  bool CollisionDetected(CContactDesc& c);

protected:
  CShape(const CShapeDesc& desc, eShape type, eMotion motion);
  CShape(const CShape&) = default;
  CShape& operator=(const CShape&) = default;

private:
  friend class CPoint;
  friend class CLineSeg;
  friend class CCircle;
  friend class CArc;
  friend class CDynamicCircle;

  // Each class of shapes keeps its own points beside m_vPos.
  virtual void Translate(const Vector2&) { Update(); } // moves them by d, after m_vPos
  // Puts them where a turn of the pose at construction, moved by m_vMoved, leaves them. Returns the position.
  virtual Vector2 TurnFromStart(const Vector2& center, float angle);
  Vector2 Moved(const Vector2& start) const { return (start.cast<double>() + m_vMoved).cast<float>(); }
  void ForgetMove() { m_fLastTurn = 0.0f, m_vLastMove.setZero(); }
  // Recomputes the box and all that depends on the pose; ends every change of it.
  virtual void Update() = 0;

  eShape m_eShapeType;
  eMotion m_eMotionType;
  bool m_bIsSensor;
  bool m_bCanCollide = true;
  CFilter m_cFilter;
  float m_fElasticity;
  float m_fRotSpeed;
  float m_fOrientation = 0.0f;
  double m_fAngle = 0.0; // the same before it was rounded, but for whole turns
  float m_fLastTurn = 0.0f;
  Vector2 m_vLastMove = Vector2::Zero();
  Vector2 m_vVel;
  Vector2 m_vPos;
  Vector2 m_vStartPos;                                // at construction
  Eigen::Vector2d m_vMoved = Eigen::Vector2d::Zero(); // by Relocate and Advance
  Vector2 m_vRotCenter;
  Eigen::Vector2d m_vStartRotCenter; // without m_vMoved
  void* m_pUser = nullptr;
  CAabb2D m_cAabb;
};

/// The kinematic one of a class of shapes: it moves and turns about its rotation centre.
template <class TStatic, class TDesc>
class CKinematic : public TStatic {
public:
  explicit CKinematic(const TDesc& desc) : TStatic(desc, eMotion::Kinematic) {}
  std::unique_ptr<CShape> Clone() const override { return std::make_unique<CKinematic>(*this); }
};

} // namespace Shapes
