// SPDX-License-Identifier: MIT
// The questions of the collision toy about one shape and one ball. A shape is eight numbers: its eRow, x, y,
// x1, y1, radius, and two angles; a ball five: x, y, radius, velocity. What is returned is valid until the
// next call.
#include "../games/Drawing.h"
#include "../games/Mode.h"

#include <emscripten.h>

#include <array>

using namespace Shapes;
using namespace Shapes::Games;

namespace {

std::array<float, 20> g_stdAnswer;

CAnyShapeDesc MakeDesc(int kind, const Vector2& p0, const Vector2& p1, float r, float a0, float a1) {
  switch (static_cast<eRow>(kind)) {
  case eRow::Segment: return CLineSegDesc(p0, p1);
  case eRow::Circle: return CCircleDesc(p0, r);
  case eRow::Arc: return CArcDesc(p0, r, a0, a1);
  default: return CPointDesc(p0);
  }
}

Vector2 ClosestPt(const CShape& shape, const Vector2& p) {
  switch (shape.GetShapeType()) {
  case eShape::LineSeg: return static_cast<const CLineSeg&>(shape).ClosestPt(p);
  case eShape::Circle: return static_cast<const CCircle&>(shape).ClosestPt(p);
  case eShape::Arc: return static_cast<const CArc&>(shape).ClosestPt(p);
  default: return shape.GetPos();
  }
}

} // namespace

extern "C" {

/// The answer of an engine for both as they are: detected, POI, normal, setback, speed.
EMSCRIPTEN_KEEPALIVE const float* AskContact(unsigned mode, int kind, float x, float y, float x1, float y1,
                                             float r, float a0, float a1, float ballX, float ballY,
                                             float ballR, float vx, float vy) {
  const auto pShape = MakeShape(MakeDesc(kind, {x, y}, {x1, y1}, r, a0, a1));
  CDynamicCircle ball(CDynamicCircleDesc({ballX, ballY}, ballR, {vx, vy}));
  CContactDesc contact(pShape.get(), &ball);
  const bool isMet = GetBackend(g_stdModes.at(mode).m_eEngine)->CollisionDetected(contact);
  g_stdAnswer = {isMet ? 1.0f : 0.0f, contact.m_vPOI.x(), contact.m_vPOI.y(), contact.m_vNorm.x(),
                 contact.m_vNorm.y(), contact.m_fSetback, contact.m_fSpeed};
  return g_stdAnswer.data();
}

/// The outcome of a mode for the ball in one step of a second, in which it flies its velocity: whether it
/// hit, POI, normal, end.
EMSCRIPTEN_KEEPALIVE const float* AskSweep(unsigned mode, int kind, float x, float y, float x1, float y1,
                                           float r, float a0, float a1, float ballX, float ballY, float ballR,
                                           float vx, float vy) {
  CWorldDesc desc;
  desc.m_fTimeStep = 1.0f;
  desc.m_cBox2D.m_fLengthUnit = 100.0f; // Box2D flies 2 metres in a step, and no farther
  const auto pWorld = MakeWorld(desc, g_stdModes.at(mode));
  pWorld->Add(MakeDesc(kind, {x, y}, {x1, y1}, r, a0, a1));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({ballX, ballY}, ballR, {vx, vy}));
  pWorld->Step();
  g_stdAnswer = {0, 0, 0, 0, 0, pWorld->GetPos(ball).x(), pWorld->GetPos(ball).y()};
  if (!pWorld->GetContacts().empty()) {
    const CContactEvent& contact = pWorld->GetContacts()[0];
    g_stdAnswer[0] = 1.0f;
    g_stdAnswer[1] = contact.m_vPOI.x();
    g_stdAnswer[2] = contact.m_vPOI.y();
    g_stdAnswer[3] = contact.m_vNorm.x();
    g_stdAnswer[4] = contact.m_vNorm.y();
  }
  return g_stdAnswer.data();
}

/// Geometry without an engine: closest point; box (left, bottom, right, top); whether the ball's centre is in
/// the sector of the arc; whether a circle and the ball have common tangents, and these.
EMSCRIPTEN_KEEPALIVE const float* AskShape(int kind, float x, float y, float x1, float y1, float r, float a0,
                                           float a1, float ballX, float ballY, float ballR) {
  const auto pShape = MakeShape(MakeDesc(kind, {x, y}, {x1, y1}, r, a0, a1));
  const Vector2 centre(ballX, ballY), closest = ClosestPt(*pShape, centre);
  const CAabb2D& box = pShape->GetAABB();
  g_stdAnswer = {closest.x(),           closest.y(),           box.GetTopLeft().x(),
                 box.GetBottomRt().y(), box.GetBottomRt().x(), box.GetTopLeft().y()};
  if (pShape->GetShapeType() == eShape::Arc)
    g_stdAnswer[6] = static_cast<const CArc&>(*pShape).PtInSector(centre) ? 1.0f : 0.0f;
  if (pShape->GetShapeType() == eShape::Circle) {
    const CCircle ball(CCircleDesc(centre, ballR));
    CLineSegDesc tangents[2];
    g_stdAnswer[7] =
        static_cast<const CCircle&>(*pShape).Tangents(&ball, tangents[0], tangents[1]) ? 1.0f : 0.0f;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector2 ends[] = {tangents[i].GetEndPt0(), tangents[i].GetEndPt1()};
      for (std::size_t k = 0; k < 2; ++k) {
        g_stdAnswer[8 + 4 * i + 2 * k] = ends[k].x();
        g_stdAnswer[9 + 4 * i + 2 * k] = ends[k].y();
      }
    }
  }
  return g_stdAnswer.data();
}

} // extern "C"
