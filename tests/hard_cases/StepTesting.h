// SPDX-License-Identifier: MIT
// Scenes that are stepped: by a world of a column, or by the exact reference.
#pragma once

#include "HardCase.h"

#include <reference/Reference.h>
#include <reference/Scalar.h>

#include <limits>
#include <numbers>
#include <optional>

namespace Shapes::HardCases {

using Compare::CFifty;
using Compare::CVec;
using Vector2d = Eigen::Vector2d;

/// Half a unit in the last place of 1, of a float and of a double: one rounding.
inline constexpr double g_fFloatRounding = 0x1p-24;
inline constexpr double g_fDoubleRounding = 0x1p-53;

/// A scene from its parts.
CSceneDesc MakeScene(std::vector<CAnyShapeDesc> shapes, std::vector<CDynamicCircleDesc> balls,
                     float dt = 1.0f / 60.0f, const Vector2& gravity = Vector2::Zero());

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
  CStepped(eColumn column, const CSceneDesc& scene);
  CStepped(eColumn column, std::vector<CAnyShapeDesc> shapes, std::vector<CDynamicCircleDesc> balls,
           float dt = 1.0f / 60.0f, const Vector2& gravity = Vector2::Zero())
      : CStepped(column, MakeScene(std::move(shapes), std::move(balls), dt, gravity)) {}

  void Step(int times = 1);
  Vector2d GetPos(std::size_t ball = 0) const;
  Vector2d GetVel(std::size_t ball = 0) const;
  /// Puts a ball there, in a world rounded to float; it keeps its velocity.
  void SetPos(std::size_t ball, const Vector2d& p);
  void SetOrientation(std::size_t shape, float angle);
  std::vector<CImpact> GetImpacts() const;
  /// nullptr for the reference.
  const CWorld* GetWorld() const { return m_pWorld.get(); }
  /// Only of eColumn::Reference.
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

/// The larger one; infinite where either is not a number.
double Worst(double a, double b);
/// Radians between two directions, 0 .. pi.
double AngleBetween(const Vector2d& a, const Vector2d& b);
/// v mirrored at a surface of normal n, with elasticity e.
inline Vector2d Mirrored(const Vector2d& v, const Vector2d& n, double e = 1.0) {
  return v - (1.0 + e) * v.dot(n) * n;
}
/// Off by how much a ball is: in place, or in velocity relative to the speed that it should have.
double OffBy(const CStepped& stepped, const Vector2d& p, const Vector2d& v, std::size_t ball = 0);

/// (x, y) turned by `angle` radians, rounded to float.
Vector2 Turned(double x, double y, double angle);

} // namespace Shapes::HardCases
