// SPDX-License-Identifier: MIT
#include "Breakout.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Games {
namespace {

constexpr float g_fWidth = 16.0f, g_fHeight = 16.0f;
constexpr float g_fPaddleHalf = 1.3f, g_fPaddleTop = 1.2f, g_fPaddleSpeed = 14.0f, g_fPaddleArc = 3.0f;
constexpr float g_fBall = 0.22f, g_fBallSpeed = 11.0f;
constexpr int g_nColumns = 10, g_nRows = 6;

} // namespace

CBreakout::CBreakout(const CMode& mode, std::uint32_t seed)
    : CGame(MakeDesc({0, 0}, 2), CAabb2D({-0.5f, g_fHeight + 0.5f}, {g_fWidth + 0.5f, -0.5f}), mode, seed) {
  Add(CLineSegDesc({0, -0.5f}, {0, g_fHeight}));
  Add(CLineSegDesc({0, g_fHeight}, {g_fWidth, g_fHeight}));
  Add(CLineSegDesc({g_fWidth, -0.5f}, {g_fWidth, g_fHeight}));
  CLineSegDesc drain({0, 0.2f}, {g_fWidth, 0.2f});
  drain.m_bIsSensor = true;
  m_cDrain = Add(drain, eRole::Sensor);
  // The top of a large circle: where a ball hits it decides where it goes.
  const float half = std::asin(g_fPaddleHalf / g_fPaddleArc);
  CArcDesc paddle({g_fWidth / 2, g_fPaddleTop - g_fPaddleArc}, g_fPaddleArc, g_fPi / 2 - half,
                  g_fPi / 2 + half);
  paddle.m_eMotionType = eMotion::Kinematic;
  m_cPaddle = Add(paddle, eRole::Flipper);
  AddBricks();
  m_cBall = Add(CDynamicCircleDesc({g_fWidth / 2, g_fPaddleTop + 0.5f}, g_fBall), eRole::Ball);
}

void CBreakout::AddBricks() {
  const float width = 1.2f, height = 0.5f;
  for (int row = 0; row < g_nRows; ++row)
    for (int column = 0; column < g_nColumns; ++column) {
      const float x = 1.35f + 1.35f * static_cast<float>(column), y = 9.5f + 0.75f * static_cast<float>(row);
      const Vector2 corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
      CBrick brick;
      for (std::size_t i = 0; i < 4; ++i) {
        brick.push_back(Add(CLineSegDesc(corners[i], corners[(i + 1) % 4]), eRole::Kicker));
        brick.push_back(Add(CPointDesc(corners[i]), eRole::Kicker));
      }
      m_stdBricks.push_back(std::move(brick));
    }
}

void CBreakout::Before(unsigned keys) {
  const float x = m_pWorld->GetPos(m_cPaddle).x();
  const float wish = (keys & g_nRight ? g_fPaddleSpeed : 0.0f) - (keys & g_nLeft ? g_fPaddleSpeed : 0.0f);
  // As far as the walls, and no farther.
  const float next = std::clamp(x + wish * GetTimeStep(), g_fPaddleHalf, g_fWidth - g_fPaddleHalf);
  m_pWorld->SetVel(m_cPaddle, {(next - x) / GetTimeStep(), 0});
  if (m_bServed) return;
  m_pWorld->SetPos(m_cBall, {next, g_fPaddleTop + 0.5f});
  m_pWorld->SetVel(m_cBall, {0, 0});
  if (!(keys & g_nAction)) return;
  if (m_nBallsLeft == 0) {
    m_nBallsLeft = 3;
    m_nScore = 0;
  }
  m_bServed = true;
  m_pWorld->SetVel(m_cBall, g_fBallSpeed * AngleToVector(m_cRandom(1.1f, 2.0f)));
}

void CBreakout::After() {
  std::vector<CShapeId> hit;
  for (const CContactEvent& contact : m_pWorld->GetContacts())
    if (!contact.m_bIsSensor) hit.push_back(contact.m_cShape);
  bool isDrained = false;
  for (const CSensorEvent& event : m_pWorld->GetSensorEvents())
    isDrained |= event.m_bBegin && event.m_cShape == m_cDrain;
  for (const CShapeId id : hit)
    Break(id);
  if (std::find(hit.begin(), hit.end(), m_cPaddle) != hit.end())
    m_fAim = m_cRandom(-0.8f, 0.8f) * g_fPaddleHalf;
  if (m_stdBricks.empty()) {
    m_nScore += 1000;
    AddBricks();
  }
  if (isDrained) {
    m_bServed = false;
    --m_nBallsLeft;
  }
  if (m_bServed) KeepSpeed();
}

void CBreakout::Break(CShapeId part) {
  const auto brick = std::find_if(m_stdBricks.begin(), m_stdBricks.end(), [part](const CBrick& ids) {
    return std::find(ids.begin(), ids.end(), part) != ids.end();
  });
  if (brick == m_stdBricks.end()) return;
  for (const CShapeId id : *brick)
    m_pWorld->Remove(id);
  m_stdBricks.erase(brick);
  m_nScore += 10;
}

// The paddle's push makes no ball faster, and none flies level for ever.
void CBreakout::KeepSpeed() {
  Vector2 v = m_pWorld->GetVel(m_cBall);
  if (std::abs(v.y()) < 0.2f * g_fBallSpeed) v.y() = v.y() > 0 ? 0.2f * g_fBallSpeed : -0.2f * g_fBallSpeed;
  m_pWorld->SetVel(m_cBall, g_fBallSpeed * Normalize(v));
}

void CBreakout::PutBack(CShapeId) { m_bServed = false; }

unsigned CBreakout::Play() {
  if (!m_bServed) return g_nAction;
  const float x = m_pWorld->GetPos(m_cPaddle).x() + m_fAim, ball = m_pWorld->GetPos(m_cBall).x();
  if (std::abs(ball - x) < 0.15f) return 0;
  return ball < x ? g_nLeft : g_nRight;
}

std::string CBreakout::GetStatus() const {
  if (m_nBallsLeft == 0) return "Game over. Serve for the next one.";
  return "Balls: " + std::to_string(m_nBallsLeft) + ", bricks: " + std::to_string(m_stdBricks.size());
}

} // namespace Shapes::Games
