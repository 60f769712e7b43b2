// SPDX-License-Identifier: MIT
#include <Shapes/Box2D.h>

#include "../../shapes/Validate.h"

#include "../../Tolerances.h"
#include "../Convert.h"
#include "ImportNotes.h"
#include "ImportSurvey.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace Shapes {
namespace Box2D {
namespace {

// Throws what the constructor of the shape throws, with the fixture in front.
template <class TShape, class TDesc>
void RequireValid(const CPart& part, const TDesc& desc) {
  try {
    TShape{desc};
  } catch (const std::invalid_argument& refusal) {
    throw std::invalid_argument(NameFixture(part) + ": " + refusal.what());
  }
}

Vector2 Direction(const b2Vec2& from, const b2Vec2& to, const Vector2& fallback) {
  return Normalize({to.x - from.x, to.y - from.y}, fallback);
}

class CSceneMaker {
public:
  CSceneMaker(const b2World& world, const CSurvey& survey, const std::vector<float>& elasticities,
              const CImportOptions& options)
      : m_cSurvey(survey), m_stdElasticities(elasticities), m_cScale(options.m_fLengthUnit) {
    const b2Vec2 gravity = GetCommonGravityScale(survey) * world.GetGravity();
    m_cScene.m_cWorld.m_vGravity = m_cScale.FromMetres(gravity);
    m_cScene.m_cWorld.m_fTimeStep = options.m_fTimeStep;
    m_cScene.m_cWorld.m_cBox2D.m_fLengthUnit = options.m_fLengthUnit;
    RequireVector("gravity of the b2World", m_cScene.m_cWorld.m_vGravity, g_fMaxSpeed);
  }

  CSceneDesc Make() {
    for (const CPart& part : m_cSurvey.m_stdParts) {
      if (part.m_bIsBall)
        AddBall(part);
      else
        AddShape(part);
    }
    AddGuards();
    return std::move(m_cScene);
  }

private:
  // An end of a segment. Ends of which no other goes on in the same direction get a guard.
  struct CEnd {
    const CPart* m_pPart;
    Vector2 m_vPos;
    Vector2 m_vInto;    // unit, from the end into the segment
    bool m_bIsTwoSided; // its neighbours are found by their positions
    bool m_bIsGuarded;  // of a one-sided segment: by the neighbours that Box2D knows
  };

  Vector2 ToScene(const CPart& part, const b2Vec2& local) const {
    return m_cScale.FromMetres(b2Mul(m_cSurvey.GetBody(part).GetTransform(), local));
  }

  // Sets the fields that all descriptors have.
  void SetBase(const CPart& part, CShapeDesc& desc) const {
    desc.m_fElasticity = m_stdElasticities[part.m_nKind];
    desc.m_bIsSensor = part.m_pFixture->IsSensor();
    desc.m_cFilter = m_cSurvey.GetFilter(part.m_nKind);
    const b2Body& body = m_cSurvey.GetBody(part);
    if (body.GetType() != b2_kinematicBody) return;
    desc.m_eMotionType = eMotion::Kinematic;
    desc.m_vVel = m_cScale.FromMetres(body.GetLinearVelocity());
    desc.m_fRotSpeed = body.GetAngularVelocity() / g_fTwoPi;
    desc.m_vRotCenter = m_cScale.FromMetres(body.GetPosition());
  }

  void AddBall(const CPart& part) {
    const b2Body& body = m_cSurvey.GetBody(part);
    const auto& circle = static_cast<const b2CircleShape&>(*part.m_pFixture->GetShape());
    CDynamicCircleDesc ball(ToScene(part, circle.m_p), m_cScale.FromMetres(circle.m_radius),
                            m_cScale.FromMetres(body.GetLinearVelocity()), body.GetMass());
    SetBase(part, ball);
    RequireValid<CDynamicCircle>(part, ball);
    m_cScene.m_stdBalls.push_back(ball);
  }

  void AddShape(const CPart& part) {
    const b2Shape& shape = *part.m_pFixture->GetShape();
    switch (shape.GetType()) {
    case b2Shape::e_circle: {
      const auto& circle = static_cast<const b2CircleShape&>(shape);
      CCircleDesc desc(ToScene(part, circle.m_p), m_cScale.FromMetres(circle.m_radius));
      SetBase(part, desc);
      RequireValid<CCircle>(part, desc);
      m_cScene.m_stdShapes.emplace_back(desc);
      break;
    }
    case b2Shape::e_edge: AddEdge(part, static_cast<const b2EdgeShape&>(shape)); break;
    case b2Shape::e_chain:
      for (int32 i = 0; i < shape.GetChildCount(); ++i) {
        b2EdgeShape edge;
        static_cast<const b2ChainShape&>(shape).GetChildEdge(&edge, i);
        AddEdge(part, edge);
      }
      break;
    default: AddPolygon(part, static_cast<const b2PolygonShape&>(shape)); break;
    }
  }

  // A polygon runs counterclockwise, so its outside is where one-sided edges are solid.
  void AddPolygon(const CPart& part, const b2PolygonShape& polygon) {
    const int32 n = polygon.m_count;
    const auto vertex = [&](int32 i) { return polygon.m_vertices[(i + n) % n]; };
    for (int32 i = 0; i < n; ++i) {
      b2EdgeShape edge;
      edge.SetOneSided(vertex(i - 1), vertex(i), vertex(i + 1), vertex(i + 2));
      AddEdge(part, edge);
    }
  }

  void AddEdge(const CPart& part, const b2EdgeShape& edge) {
    const Vector2 p1 = ToScene(part, edge.m_vertex1), p2 = ToScene(part, edge.m_vertex2);
    CLineSegDesc seg(p1, p2);
    SetBase(part, seg);
    // Box2D is solid to the right of the way from 1 to 2, which is the front if the ends changed order. Its
    // sensors feel from either side.
    if (edge.m_oneSided && !seg.m_bIsSensor)
      seg.m_eSides = seg.GetEndPt0() == p1 ? eSides::Back : eSides::Front;
    RequireValid<CLineSeg>(part, seg);
    m_cScene.m_stdShapes.emplace_back(seg);
    if (seg.m_bIsSensor) return;

    const Vector2 t = Direction(edge.m_vertex1, edge.m_vertex2, {1.0f, 0.0f});
    const bool guard1 = edge.m_oneSided && TurnsAway(Direction(edge.m_vertex0, edge.m_vertex1, -t), t);
    const bool guard2 = edge.m_oneSided && TurnsAway(t, Direction(edge.m_vertex2, edge.m_vertex3, -t));
    const Vector2 into = Normalize(p2 - p1);
    m_stdEnds.push_back({&part, p1, into, !edge.m_oneSided, guard1});
    m_stdEnds.push_back({&part, p2, -into, !edge.m_oneSided, guard2});
  }

  // Whether a way that turns from direction t0 to t1 leaves a corner that sticks out to its right, where it
  // is solid. Neighbours that fold back, or have no length, stand for none.
  static bool TurnsAway(const Vector2& t0, const Vector2& t1) {
    return t0.dot(t1) < 0.0f || Cross(t0, t1) > std::sin(g_fSmoothTurn);
  }

  // Shapes of different bodies stay together only if neither turns.
  bool StayTogether(const CPart& a, const CPart& b) const {
    return a.m_nBody == b.m_nBody || (m_cSurvey.GetBody(a).GetType() == b2_staticBody &&
                                      m_cSurvey.GetBody(b).GetType() == b2_staticBody);
  }

  bool GoesOn(const CEnd& end) const {
    for (auto [it, last] = m_stdEndsAt.equal_range({end.m_vPos.x(), end.m_vPos.y()}); it != last; ++it) {
      const CEnd& other = *it->second;
      if (StayTogether(*other.m_pPart, *end.m_pPart) &&
          other.m_vInto.dot(end.m_vInto) < -std::cos(g_fSmoothTurn))
        return true;
    }
    return false;
  }

  void AddGuards() {
    for (const CEnd& end : m_stdEnds)
      m_stdEndsAt.emplace(std::pair(end.m_vPos.x(), end.m_vPos.y()), &end);
    std::map<std::pair<float, float>, std::vector<const CPart*>> guarded;
    for (const CEnd& end : m_stdEnds) {
      if (end.m_bIsTwoSided ? GoesOn(end) : !end.m_bIsGuarded) continue;
      // One for each point and body, unless their elasticities differ.
      std::vector<const CPart*>& parts = guarded[{end.m_vPos.x(), end.m_vPos.y()}];
      bool isThere = false;
      for (const CPart* p : parts)
        isThere |= p->m_nBody == end.m_pPart->m_nBody &&
                   m_stdElasticities[p->m_nKind] == m_stdElasticities[end.m_pPart->m_nKind];
      if (isThere) continue;
      parts.push_back(end.m_pPart);
      CPointDesc guard(end.m_vPos);
      SetBase(*end.m_pPart, guard);
      m_cScene.m_stdShapes.emplace_back(guard);
    }
  }

  const CSurvey& m_cSurvey;
  const std::vector<float>& m_stdElasticities;
  CScale m_cScale;
  CSceneDesc m_cScene;
  std::vector<CEnd> m_stdEnds;
  std::multimap<std::pair<float, float>, const CEnd*> m_stdEndsAt;
};

} // namespace
} // namespace Box2D

CSceneDesc ImportScene(const b2World& world, const CImportOptions& options) {
  RequireRange("m_fLengthUnit", options.m_fLengthUnit, g_fMinLengthUnit, g_fMaxLength);
  RequirePositive("m_fTimeStep", options.m_fTimeStep, g_fMaxTimeStep);
  const Box2D::CSurvey survey(world);
  std::vector<Box2D::CBounceKind> kinds;
  for (const Box2D::CKind& kind : survey.m_stdKinds)
    kinds.push_back({kind.m_bIsBall, kind.m_fRestitution});
  const std::vector<Box2D::CBouncePair> pairs = survey.GetMeetingPairs();
  const std::vector<float> elasticities = Box2D::FitElasticities(kinds, pairs);
  CSceneDesc scene = Box2D::CSceneMaker(world, survey, elasticities, options).Make();
  scene.m_stdNotes = Box2D::MakeNotes(world, survey, kinds, pairs, elasticities);
  return scene;
}

} // namespace Shapes
