// SPDX-License-Identifier: MIT
#include "ImportNotes.h"

#include "../../shapes/Validate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <typeinfo>

namespace Shapes::Box2D {
namespace {

const char* NameOf(b2JointType type) {
  switch (type) {
  case e_revoluteJoint: return "revolute";
  case e_prismaticJoint: return "prismatic";
  case e_distanceJoint: return "distance";
  case e_pulleyJoint: return "pulley";
  case e_mouseJoint: return "mouse";
  case e_gearJoint: return "gear";
  case e_wheelJoint: return "wheel";
  case e_weldJoint: return "weld";
  case e_frictionJoint: return "friction";
  case e_ropeJoint: return "rope";
  case e_motorJoint: return "motor";
  default: return "unknown";
  }
}

std::string Capital(std::string text) {
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

// Of pairs whose restitution is another one.
constexpr std::size_t g_nMostNotes = 20;

class CNoteWriter {
public:
  CNoteWriter(const CSurvey& survey, const std::vector<CBounceKind>& kinds,
              const std::vector<CBouncePair>& pairs, const std::vector<float>& elasticities)
      : m_cSurvey(survey), m_stdKinds(kinds), m_stdPairs(pairs), m_stdElasticities(elasticities) {}

  std::vector<std::string> Write(const b2World& world) {
    m_stdNotes = m_cSurvey.m_stdNotes;
    WriteParts();
    WriteBalls(world.GetGravity());
    WriteJoints();
    WriteFilters();
    WriteFriction();
    WriteThreshold();
    WriteRestitution();
    WriteSettings(world, world.GetContactManager());
    return std::move(m_stdNotes);
  }

private:
  std::string Name(std::size_t kind) const { return m_cSurvey.Name(m_cSurvey.m_stdKinds[kind].m_stdParts); }

  void WriteParts() {
    for (const CPart& part : m_cSurvey.m_stdParts) {
      if (part.m_bIsBall) continue;
      const b2Shape& shape = *part.m_pFixture->GetShape();
      const std::string name = Capital(NameFixture(part));
      const bool isCircle = shape.GetType() == b2Shape::e_circle;
      if (!isCircle && shape.m_radius != b2_polygonRadius)
        m_stdNotes.push_back(name + " loses its skin of " + ToText(shape.m_radius) + " m.");
      if (part.m_pFixture->IsSensor() && shape.GetType() == b2Shape::e_polygon)
        m_stdNotes.push_back(name + " is a sensor: balls are felt on its geometry, not inside.");
    }
  }

  // The balls by a value that they have; without those that have the neutral one.
  template <class F>
  std::map<float, std::vector<int>> BallsBy(F value, float neutral) const {
    std::map<float, std::vector<int>> balls;
    for (const CPart& part : m_cSurvey.m_stdParts)
      if (part.m_bIsBall) balls[value(m_cSurvey.GetBody(part))].push_back(part.m_nBody);
    balls.erase(neutral);
    return balls;
  }

  void WriteBalls(const b2Vec2& gravity) {
    if (const auto asleep = BallsBy([](const b2Body& b) { return b.IsAwake() ? 0.0f : 1.0f; }, 0.0f);
        !asleep.empty())
      m_stdNotes.push_back("Here nothing sleeps at first: " + NameBodies(asleep.begin()->second) +
                           " in the b2World, also where nothing holds them.");
    for (const auto& [damping, bodies] : BallsBy([](const b2Body& b) { return b.GetLinearDamping(); }, 0.0f))
      m_stdNotes.push_back("Linear damping has no counterpart: " + NameBodies(bodies) + " with " +
                           ToText(damping) + ".");
    for (const auto& [damping, bodies] : BallsBy([](const b2Body& b) { return b.GetAngularDamping(); }, 0.0f))
      m_stdNotes.push_back("Angular damping has no counterpart, balls do not spin: " + NameBodies(bodies) +
                           " with " + ToText(damping) + ".");
    if (gravity == b2Vec2_zero) return;
    const float common = GetCommonGravityScale(m_cSurvey);
    if (common != 1.0f)
      m_stdNotes.push_back("The gravity is that of the b2World times " + ToText(common) +
                           ", the gravity scale of every ball.");
    else
      for (const auto& [scale, bodies] : BallsBy([](const b2Body& b) { return b.GetGravityScale(); }, 1.0f))
        m_stdNotes.push_back("A gravity scale that balls do not share has no counterpart: " +
                             NameBodies(bodies) + " with " + ToText(scale) + ".");
  }

  void WriteJoints() {
    std::set<int> balls, taken;
    for (const CPart& part : m_cSurvey.m_stdParts) {
      taken.insert(part.m_nBody);
      if (part.m_bIsBall) balls.insert(part.m_nBody);
    }
    for (std::size_t i = 0; i < m_cSurvey.m_stdJoints.size(); ++i) {
      const CJointEnds& joint = m_cSurvey.m_stdJoints[i];
      const int a = joint.m_stdBodies.front(), b = joint.m_stdBodies.back();
      std::string note = "Joint " + std::to_string(i) + " (" + NameOf(joint.m_pJoint->GetType()) + ", " +
                         NameBodies(joint.m_stdBodies) + ") is left out.";
      if (m_cSurvey.AreJoined(a, b) && taken.contains(a) && taken.contains(b) &&
          (balls.contains(a) || balls.contains(b)))
        note += " It keeps its bodies from meeting in Box2D; here they meet.";
      m_stdNotes.push_back(note);
    }
  }

  // The scene has categories and masks, but no groups.
  void WriteFilters() {
    WriteFilters(true, "The groups keep ", " from ", " in Box2D; here they meet.");
    WriteFilters(false, "The groups let ", " meet ", " in Box2D; here categories and masks keep them apart.");
  }

  void WriteFilters(bool areApart, const char* verb, const char* from, const char* end) {
    for (std::size_t ball = 0; ball < m_cSurvey.m_stdKinds.size(); ++ball) {
      if (!m_cSurvey.m_stdKinds[ball].m_bIsBall) continue;
      std::string others;
      for (std::size_t k = 0; k < m_cSurvey.m_stdKinds.size(); ++k) {
        const CKind& kind = m_cSurvey.m_stdKinds[k];
        const bool isListed = kind.m_bIsBall && k < ball; // with the other one
        const bool isAlone = k == ball && kind.m_stdParts.size() == 1;
        const bool isSame = m_cSurvey.AreFiltered(ball, k) != areApart ||
                            DoMeet(m_cSurvey.GetFilter(ball), m_cSurvey.GetFilter(k)) != areApart;
        if (isListed || isAlone || isSame) continue;
        others.append(others.empty() ? "" : ", ").append(Name(k));
      }
      if (!others.empty()) m_stdNotes.push_back(verb + Name(ball) + from + others + end);
    }
  }

  // The parts of all pairs for which value, a function of two kinds, is above 0, and its largest value.
  template <class F>
  std::pair<std::vector<std::size_t>, float> PartsWith(F value) const {
    std::set<std::size_t> kinds;
    float largest = 0.0f;
    for (const CBouncePair& pair : m_stdPairs) {
      const float f = value(m_cSurvey.m_stdKinds[pair.m_nFirst], m_cSurvey.m_stdKinds[pair.m_nSecond]);
      if (!(f > 0.0f)) continue;
      kinds.insert({pair.m_nFirst, pair.m_nSecond});
      largest = std::max(largest, f);
    }
    std::vector<std::size_t> parts;
    for (const std::size_t kind : kinds)
      parts.insert(parts.end(), m_cSurvey.m_stdKinds[kind].m_stdParts.begin(),
                   m_cSurvey.m_stdKinds[kind].m_stdParts.end());
    std::sort(parts.begin(), parts.end());
    return {parts, largest};
  }

  void WriteFriction() {
    const auto [parts, largest] =
        PartsWith([](const CKind& a, const CKind& b) { return b2MixFriction(a.m_fFriction, b.m_fFriction); });
    if (!parts.empty())
      m_stdNotes.push_back("Friction has no counterpart, balls slide and do not spin: " +
                           m_cSurvey.Name(parts) + " with up to " + ToText(largest) + ".");
  }

  void WriteThreshold() {
    const auto [parts, largest] = PartsWith([](const CKind& a, const CKind& b) {
      const bool bounces = b2MixRestitution(a.m_fRestitution, b.m_fRestitution) > 0.0f;
      return bounces ? b2MixRestitutionThreshold(a.m_fThreshold, b.m_fThreshold) : 0.0f;
    });
    if (!parts.empty())
      m_stdNotes.push_back("Slow balls bounce too, Box2D stops them dead at up to " + ToText(largest) +
                           " m/s: " + m_cSurvey.Name(parts) + ".");
  }

  void WriteRestitution() {
    std::size_t others = 0;
    float farthest = 0.0f;
    for (const CBouncePair& pair : m_stdPairs) {
      if (Reproduces(m_stdKinds, m_stdElasticities, pair)) continue;
      const float product = m_stdElasticities[pair.m_nFirst] * m_stdElasticities[pair.m_nSecond];
      if (++others > g_nMostNotes) {
        farthest = std::max(farthest, std::abs(product - GetTarget(m_stdKinds, pair)));
        continue;
      }
      std::string note = "Restitution of " + Name(pair.m_nFirst);
      note += pair.m_nFirst == pair.m_nSecond ? " among themselves" : " with " + Name(pair.m_nSecond);
      m_stdNotes.push_back(note + ": " + ToText(GetTarget(m_stdKinds, pair)) + " in Box2D, " +
                           ToText(product) + " here.");
    }
    if (others > g_nMostNotes)
      m_stdNotes.push_back("Restitution of " + std::to_string(others - g_nMostNotes) +
                           " other pairs, too, which differ by up to " + ToText(farthest) + ".");
  }

  void WriteSettings(const b2World& world, const b2ContactManager& manager) {
    if (!world.GetContinuousPhysics())
      m_stdNotes.push_back("The b2World has no continuous physics: here balls are swept and pass no wall.");
    if (manager.m_contactFilter != nullptr && typeid(*manager.m_contactFilter) != typeid(b2ContactFilter))
      m_stdNotes.push_back(
          "The b2World has a contact filter of the game's own: it is not asked, filter bits and "
          "groups are read as Box2D reads them.");
    if (manager.m_contactListener != nullptr &&
        typeid(*manager.m_contactListener) != typeid(b2ContactListener))
      m_stdNotes.push_back(
          "The b2World has a contact listener of the game's own: what it changes of contacts is "
          "not known here.");
  }

  const CSurvey& m_cSurvey;
  const std::vector<CBounceKind>& m_stdKinds;
  const std::vector<CBouncePair>& m_stdPairs;
  const std::vector<float>& m_stdElasticities;
  std::vector<std::string> m_stdNotes;
};

} // namespace

float GetCommonGravityScale(const CSurvey& survey) {
  std::set<float> scales;
  for (const CPart& part : survey.m_stdParts)
    if (part.m_bIsBall) scales.insert(survey.GetBody(part).GetGravityScale());
  return scales.size() == 1 ? *scales.begin() : 1.0f;
}

std::vector<std::string> MakeNotes(const b2World& world, const CSurvey& survey,
                                   const std::vector<CBounceKind>& kinds,
                                   const std::vector<CBouncePair>& pairs,
                                   const std::vector<float>& elasticities) {
  return CNoteWriter(survey, kinds, pairs, elasticities).Write(world);
}

} // namespace Shapes::Box2D
