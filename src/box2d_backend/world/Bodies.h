// SPDX-License-Identifier: MIT
// The shapes of a world as bodies of a b2World.
#pragma once

#include "../../world/WorldState.h"

#include <box2d/box2d.h>

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

#include "../Convert.h"
#include "../contact/ExactContact.h"
#include "../contact/ParabolicCorrection.h"
#include "DestructionWatch.h"
#include "Mixing.h"
#include "SharedEnds.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// The collision group of balls that are not to meet each other. A game's own fixtures are unlikely to have
/// it, and do not meet them if they do.
inline constexpr int16 g_nApart = std::numeric_limits<int16>::min();

struct CBody {
  b2Body* m_pBody = nullptr;
  CShapeId m_cId;
  float m_fElasticity = 1.0f;
  b2Transform m_cStart; ///< at the beginning of the step, of what moves or may turn
  CContactGeometry m_cGeometry;

  CParabolicCorrection m_cCorrection; ///< of a ball
  float m_fRadius = 0.0f;             ///< of a ball, without skin
  float m_fBaseOrientation = 0.0f;    ///< of a shape when its fixtures were made
  b2Vec2 m_vVel = b2Vec2_zero;        ///< of a shape, metres per second
  float m_fTurnSpeed = 0.0f;          ///< of a shape, radians per second
  int m_nArcPieces = 0;
  bool m_bIsBall = false;
  bool m_bIsSupported = false;           ///< the ball lies on something in this step
  bool m_bWasSupported = false;          ///< it did so in the last one
  const CBody* m_pBouncedOff = nullptr;  ///< the shape that the ball has hit last in this step
  bool m_bIsLasting = false;             ///< Box2D's own solver moves the ball in this step
  bool m_bLiesOnOther = false;           ///< on a body of the game
  bool m_bLiesOnOwn = false;             ///< on a shape or a ball
  bool m_bHasWeight = false;             ///< it gets all of a gravity step before it, for Box2D's solver
  CSharedEnds m_cSharedEnds;             ///< of which the geometry of a shape knows
  std::vector<b2Fixture*> m_stdFixtures; ///< without those that a game has put on its body
  std::vector<const CBody*> m_stdPassed; ///< by the ball in this step, as the game's listener wants it

  /// Whether Box2D moves it: a game may turn off, hold or let sleep any body.
  bool IsFree() const {
    return m_pBody->GetType() == b2_dynamicBody && m_pBody->IsEnabled() && m_pBody->IsAwake();
  }
  bool Passes(const CBody& shape) const {
    return std::find(m_stdPassed.begin(), m_stdPassed.end(), &shape) != m_stdPassed.end();
  }
};

/// Whether it is one of bodies that bounce off each other.
inline bool IsSolid(const b2Contact& contact) {
  return !contact.GetFixtureA()->IsSensor() && !contact.GetFixtureB()->IsSensor();
}

/// Makes one b2Body for each shape. Finds the shape of a body without the user data of Box2D, which belong
/// to the user.
class CBodies {
public:
  /// @param sagitta  in the metres of Box2D
  /// @param pWatch   watches all fixtures; null where only this library destroys any
  /// @param pairs    whether balls may meet balls
  CBodies(b2World& world, const CScale& scale, const CTuning& tuning, float sagitta,
          CDestructionWatch* pWatch, bool pairs)
      : m_pWorld(&world),
        m_cScale(scale),
        m_cTuning(tuning),
        m_fSagitta(sagitta),
        m_pWatch(pWatch),
        m_bPairs(pairs) {}

  void Create(const CWorldState& state, CShapeId id, const CSharedEnds& sharedEnds = {});
  void Remove(CShapeId id);
  void RemoveAll();
  bool IsEmpty() const { return m_stdBodies.empty(); }
  bool Contains(CShapeId id) const { return m_stdBodies.contains(id); }
  /// Forgets a body that is gone already.
  void Forget(CShapeId id);
  /// Elasticity, sensor, can-collide and user pointer as they are now.
  void SetProperties(const CWorldState& state, CShapeId id);
  /// Puts a body to where its shape is.
  /// @returns false if that is not to be had: the shape has another place about its rotation centre than when
  ///          its fixtures were made
  bool Follow(const CShape& shape, const CBody& body) const;
  /// The same for a shape that was put somewhere else by the user.
  bool SetPose(const CWorldState& state, CShapeId id);
  /// Gives the balls their masses back, which Box2D computes from the densities of fixtures when a game
  /// changes the type of a body, or takes a fixture from it.
  void KeepMasses(const CBallArrays& balls);
  /// How fast a shape moves and turns, as it is now.
  void SetMoving(const CWorldState& state, CShapeId id);
  void SetBullets(bool b);
  /// Anew after m_bIsLasting of any ball has changed.
  void SetBullets();
  /// Sets the restitutions that Box2D mixes itself, for worlds without a listener that sets them per contact.
  void SetRestitutions(const CMixing& mixing);

  CBody& Get(CShapeId id) { return m_stdBodies.at(id); }
  /// The shape of a body; nullptr for a body of the game.
  CBody* Find(const b2Body& body);
  /// Makes b2Body::GetContactList of all that has moved or was created since the last step what it will be in
  /// the next one.
  void FindContacts();
  /// In the order of their ids, as everywhere.
  const std::vector<CBody*>& GetBalls() const { return m_stdBalls; }
  /// Whether the ball may be touching a body of the game.
  bool IsNearOthers(const CBody& ball);
  /// Shapes that move or turn, sensors too.
  const std::vector<CBody*>& GetMoving() const { return m_stdMoving; }
  std::uint64_t GetArcPieces() const { return m_nArcPieces; }

private:
  void CreateBall(const CBallArrays& balls, std::size_t i, CBody& body);
  void CreateShape(const CShape& shape, const CSharedEnds& sharedEnds, CBody& body);
  template <class TShape, class F>
  void AddFixture(CBody& body, F fill);

  b2World* m_pWorld;
  CScale m_cScale;
  CTuning m_cTuning;
  float m_fSagitta;
  CDestructionWatch* m_pWatch;
  std::map<CShapeId, CBody> m_stdBodies;
  std::unordered_map<const b2Body*, CBody*> m_stdByBody;
  std::vector<CBody*> m_stdBalls, m_stdMoving;
  bool m_bPairs;
  bool m_bBullets = false;
  std::uint64_t m_nArcPieces = 0;
};

} // namespace Shapes::Box2D
