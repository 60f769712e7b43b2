// SPDX-License-Identifier: MIT
// For games that have a b2World of Box2D of their own, 2.4.1 or a later 2.4. Not part of Shapes.h, because it
// needs a library that was built with Box2D (Shapes_WITH_BOX2D, component box2d).
#pragma once

#include <Shapes/SceneDesc.h>
#include <Shapes/World.h>

#include <memory>

class b2World;

namespace Shapes {

/// Shapes and balls among the bodies of a game, in the game's own b2World, which the game steps:
///
///     pWorld->PreStep(dt);
///     world.Step(dt, 8, 3);
///     pWorld->PostStep();
///
/// dt may differ from step to step. After PostStep contacts, events, positions and velocities are those of
/// the step. The contact of a ball with a body of the game has no shape. Differences from other worlds:
/// - Step, SaveState and LoadState of its world throw std::logic_error. The time step, the substeps, the
///   iterations and the gravity of the description are not used; the b2World has the gravity, and
///   SetGravity throws std::invalid_argument.
/// - Gravity and Continuous run as the b2World has them (SetGravity, SetContinuousPhysics), and can be
///   neither forced nor forbidden. Events always runs unless forbidden: a ball may meet the game's bodies.
/// - Changes throw std::logic_error between PreStep and PostStep, and in callbacks of Box2D. (A
///   b2DestructionListener for a body that the game destroys, and a query or a ray cast, cannot be detected:
///   change nothing from there.)
/// - Tuned worlds leave the scale of the b2World as it is and cut no steps: m_nMovesClamped and
///   m_nTurnsClamped count moves that Box2D slows down. The fixtures of tuned balls are larger than the balls
///   by .00625 metres, by which they keep away from the game's bodies; from each other and from shapes they
///   do not. They have the gravity scale 0, as Shapes bends their paths: leave it. Their velocities are
///   Box2D's mean ones from PreStep to PostStep: a game that moves or kicks a ball does so before PreStep, or
///   after PostStep. Its listener may see their manifolds turned round.
///
/// Effects on the game:
/// - Fixtures have no friction and no restitution threshold; those of balls have the elasticity of the ball
///   as their restitution, those of other shapes 0. The game's rule mixes these with the game's fixtures. Two
///   of Shapes' own collide by the product of their elasticities.
/// - Where BallPairs is forbidden, the fixtures of balls have the group index -32768.
/// - The user data of a fixture is the user pointer of its shape, that of a body 0. Sensors, and what is
///   turned off, are sensors of Box2D that meet nothing.
/// - A game may put joints and sensors of its own on bodies of Shapes, change the type of a body, turn it off
///   or let it sleep. (Its solid fixtures on them have no effect in tuned worlds.) A ball keeps its mass.
///   SetRotCenter and Reset make a body anew, without what a game has put on it; so does in a tuned world a
///   segment or an arc that comes to an end of another one, or goes from it.
/// - It listens to contacts before the game's listener and passes all of them on, those of Shapes' bodies
///   included. PreStep notices a listener that the game has installed since, and includes it.
/// - A contact between two of Shapes' own that the game's listener disables in PreSolve has no effect, as for
///   one-way platforms, and is reported all the same.
/// - b2World::ShiftOrigin does not move shapes: PreStep throws std::logic_error after it, unless all were
///   removed before.
///
/// Life and death:
/// - The game may destroy any body. If it is one of ours, its shape is removed by the next call of any
///   function, and counted in m_nBodiesLost.
/// - The b2World may be destroyed first. Then, and also if the game has destroyed all bodies in it, IsAlive
///   is false, getters go on with what was there last, and everything else throws std::logic_error.
/// - When this world is destroyed it takes its bodies out of the b2World (the game's listener hears that
///   contacts end, so it has to be there still, or be taken out of the b2World before), and puts the former
///   listener back. From within a callback of Box2D that cannot be: the bodies stay and belong to the game
///   then.
///
/// Like a b2World it is for one thread at a time.
class CBox2DWorld final {
public:
  struct CImpl;
  explicit CBox2DWorld(std::unique_ptr<CImpl> pImpl);
  ~CBox2DWorld();
  CBox2DWorld(const CBox2DWorld&) = delete;
  CBox2DWorld& operator=(const CBox2DWorld&) = delete;

  /// The world that shapes and balls are added to and read from.
  CWorld& GetWorld();
  const CWorld& GetWorld() const;

  /// To be called before b2World::Step.
  /// @param dt  seconds, as b2World::Step will be given
  /// @throws std::invalid_argument unless g_fMinTimeStep <= dt <= g_fMaxTimeStep
  /// @throws std::logic_error if it was called already, in a callback of Box2D, or if the b2World is gone;
  /// nothing has changed then
  void PreStep(float dt);
  /// To be called after b2World::Step.
  /// @throws std::logic_error without PreStep, in a callback of Box2D, or if the b2World is gone
  void PostStep();
  /// Whether the b2World is still there, judged by the bodies in it.
  bool IsAlive() const;

private:
  std::unique_ptr<CImpl> m_pImpl;
};

/// An empty world in the b2World of a game.
/// @param desc  the length unit is in user units per metre of the b2World
/// @throws std::invalid_argument naming the field of the description that is not valid; the gravity has to be
/// (0, 0), and Gravity and Continuous neither forced nor forbidden
/// @throws std::logic_error during b2World::Step
std::unique_ptr<CBox2DWorld> MakeWorld(b2World& world, const CWorldDesc& desc);

/// How a b2World becomes a scene.
struct CImportOptions {
  float m_fLengthUnit = 1.0f;       ///< User units per metre of the b2World, from g_fMinLengthUnit.
  float m_fTimeStep = 1.0f / 60.0f; ///< Seconds that the game gives to b2World::Step, above 0.
};

/// The scene that a game's world is in: shapes and balls where they are now, with the speeds that they have
/// now. Lengths and speeds are multiplied by the length unit. Bodies are taken in the order in which the game
/// made them, the fixtures of each likewise, and counted from 0 in this order.
///
/// - Fixtures of static and kinematic bodies become circles and segments. Chains and one-sided edges are
///   solid on the side on which they are in Box2D, polygons on the outside, two-sided edges on both. Where a
///   ball can meet a corner or an end, a point guards it (ends are open in the approximate mode); the points
///   come after all other shapes. Fixtures share end points with the same bits where they do in Box2D.
/// - Kinematic bodies turn about their positions.
/// - Dynamic bodies become balls if they have exactly one solid fixture, a circle about the centre of mass.
/// - Elasticities: Box2D takes the larger restitution of two, Shapes the product of both elasticities. Every
///   shape and ball gets an elasticity with which each pair that can meet has the restitution that it has in
///   Box2D, within 4 ulp, where there are such elasticities. Else those of balls and shapes come first, and
///   what remains is fitted (least squares of logarithms).
///
/// The notes have a sentence for everything without a counterpart or with another effect, naming the bodies:
/// other dynamic bodies, joints, friction, damping, filters, thresholds, pairs of another restitution, and
/// code of the game that takes part in collisions.
/// docs/box2d_import.md has an example and the list.
///
/// @throws std::invalid_argument naming the option, or the body, the field and the value, that no shape can
/// have
CSceneDesc ImportScene(const b2World& world, const CImportOptions& options = {});

} // namespace Shapes
