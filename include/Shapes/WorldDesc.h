// SPDX-License-Identifier: MIT
// The description of a world, and the descriptors of its shapes.
#pragma once

#include <Shapes/Arc.h>
#include <Shapes/Circle.h>
#include <Shapes/DynamicCircle.h>
#include <Shapes/Effects.h>
#include <Shapes/Limits.h>
#include <Shapes/LineSeg.h>
#include <Shapes/Point.h>

#include <memory>
#include <variant>

namespace Shapes {

/// Profiles of Box2D. docs/box2d_differences.md has the figures.
enum class eProfile {
  Shipped, ///< As Box2D ships: only elasticity (the product of both), friction (none), spin of balls (none)
           ///< and sleep (never) are the library's; and an effect that is not called for is off.
  Tuned    ///< As accurate as Box2D can be made, for more time.
};

/// The settings that Box2D reads, whose tolerances are in metres. No other engine has any.
struct CBox2DSettings {
  eProfile m_eProfile = eProfile::Shipped;
  float m_fLengthUnit = 1.0f; ///< User units per metre (100 for 100 pixels per metre), from g_fMinLengthUnit.
  float m_fSagittaTolerance = g_fSagittaTolerance; ///< Height of arcs above their chords, in metres, above 0.
  unsigned m_nVelocityIterations = 8;              ///< Per substep, 1 .. 1000.
  unsigned m_nPositionIterations = 3;              ///< Per substep, 1 .. 1000.
};

/// Means the same on every engine, but for the settings of one.
class CWorldDesc {
public:
  Vector2 m_vGravity = Vector2::Zero(); ///< User units per second squared.
  float m_fTimeStep = 1.0f / 60.0f;     ///< Seconds per Step, above 0.
  unsigned m_nSubsteps = 1;             ///< Equal parts into which a Step is cut, 1 .. g_nMaxSubsteps.
  CEffectChoice m_cEffects;             ///< No effect may be both forced and forbidden.
  /// Threads that may share a Step, 1 .. g_nMaxThreads. What comes out is the same bits. Native uses them for
  /// thousands of balls that do not meet each other (BallPairs does not run), if the library was built with
  /// SHAPES_WITH_THREADS; otherwise, and on Box2D, one does it all.
  unsigned m_nThreads = 1;
  CBox2DSettings m_cBox2D;
};

/// A descriptor of any shape, balls included.
using CAnyShapeDesc = std::variant<CPointDesc, CLineSegDesc, CCircleDesc, CArcDesc, CDynamicCircleDesc>;

/// The shape that a descriptor describes, of the class that fits its motion: for a kinematic CArcDesc a
/// CKinematicArc. Worlds make theirs so.
/// @throws std::invalid_argument naming the field that is not valid
std::unique_ptr<CShape> MakeShape(const CAnyShapeDesc& desc);

} // namespace Shapes
