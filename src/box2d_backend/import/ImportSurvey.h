// SPDX-License-Identifier: MIT
// A survey of a game's b2World: the fixtures that become shapes or balls, the others, and the pairs that
// collide.
#pragma once

#include <Shapes/Filter.h>

#include <box2d/box2d.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "FitElasticities.h"

namespace Shapes::Box2D {

/// A fixture that becomes shapes, or a ball.
struct CPart {
  const b2Fixture* m_pFixture;
  int m_nBody; ///< Bodies and the fixtures of each are counted in the order in which they were made.
  int m_nFixture;
  bool m_bIsBall;
  std::size_t m_nKind = 0;
};

/// Parts that collide alike.
struct CKind {
  bool m_bIsBall;
  bool m_bIsSensor;
  float m_fRestitution;
  float m_fFriction;
  float m_fThreshold;
  b2Filter m_cFilter;
  std::vector<std::size_t> m_stdParts;
};

/// A joint and the numbers of its two bodies.
struct CJointEnds {
  const b2Joint* m_pJoint;
  std::vector<int> m_stdBodies;
};

/// Made by reading the world once; keeps pointers into it.
class CSurvey {
public:
  /// @throws std::invalid_argument naming the body, the fixture and the restitution that is not valid
  explicit CSurvey(const b2World& world);

  const b2Body& GetBody(const CPart& part) const {
    return *m_stdBodies[static_cast<std::size_t>(part.m_nBody)];
  }
  /// Whether the filters keep two kinds from each other.
  bool AreFiltered(std::size_t kind0, std::size_t kind1) const;
  /// Category and mask, which are all that a scene has; the default where the b2World has no filter.
  CFilter GetFilter(std::size_t kind) const;
  /// Whether the joints keep two bodies from each other.
  bool AreJoined(int body0, int body1) const;
  /// Whether balls of the one bounce off members of the other.
  bool DoMeet(std::size_t kind0, std::size_t kind1) const;
  /// All pairs that meet, balls first.
  std::vector<CBouncePair> GetMeetingPairs() const;

  /// "body 3", "bodies 0 to 4, 7, body 9 fixtures 1, 2".
  std::string Name(const std::vector<std::size_t>& parts) const;

  std::vector<const b2Body*> m_stdBodies;
  std::vector<CPart> m_stdParts;
  std::vector<CKind> m_stdKinds;
  std::vector<CJointEnds> m_stdJoints;
  std::vector<std::string> m_stdNotes; ///< Of bodies and fixtures that were left out.

private:
  void TakeBody(int body);
  void TakeBall(int body, const std::vector<const b2Fixture*>& fixtures);
  void TakeJoints(const b2World& world);
  void FindKinds();
  void DropWhatNoBallMeets();

  bool m_bHasFilter;
  std::set<std::pair<int, int>> m_stdJoined; // bodies that a joint keeps from each other, lower number first
};

/// "body 3" or "bodies 0 to 4, 7" of numbers in increasing order.
std::string NameBodies(const std::vector<int>& bodies);

/// "body 3 fixture 1" of a part, for a message about it.
std::string NameFixture(const CPart& part);

} // namespace Shapes::Box2D
