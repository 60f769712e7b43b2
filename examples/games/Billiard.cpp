// SPDX-License-Identifier: MIT
#include "Billiard.h"

#include <cmath>
#include <cstdio>

namespace Shapes::Games {
namespace {

constexpr int g_nBalls = 20;
constexpr float g_fSide = 10.0f, g_fDisc = 3.0f, g_fBall = 0.1f, g_fSpeed = 6.0f;

// The centres stay a radius away from the walls and from the disc.
double GetExpectedPath() {
  const double side = g_fSide - 2 * g_fBall, disc = g_fDisc + g_fBall, pi = g_fPi;
  return pi * (side * side - pi * disc * disc) / (4 * side + 2 * pi * disc);
}

} // namespace

// Each ball has the table to itself.
CWorldDesc CBilliard::MakeDesc() {
  CWorldDesc desc = CGame::MakeDesc({0, 0}, 2);
  desc.m_cEffects.m_cForbidden.Set(eEffect::BallPairs);
  return desc;
}

CBilliard::CBilliard(const CMode& mode, std::uint32_t seed)
    : CGame(MakeDesc(), CAabb2D({-0.5f, g_fSide + 0.5f}, {g_fSide + 0.5f, -0.5f}), mode, seed) {
  const Vector2 corners[] = {{0, 0}, {g_fSide, 0}, {g_fSide, g_fSide}, {0, g_fSide}};
  for (std::size_t i = 0; i < 4; ++i)
    Add(CLineSegDesc(corners[i], corners[(i + 1) % 4]));
  Add(CCircleDesc({g_fSide / 2, g_fSide / 2}, g_fDisc), eRole::Kicker);
  for (int i = 0; i < g_nBalls; ++i)
    Start(Add(CDynamicCircleDesc({1, 1}, g_fBall), eRole::Ball));
}

void CBilliard::Start(CShapeId ball) {
  m_pWorld->SetPos(ball, {m_cRandom(0.5f, g_fSide - 0.5f), m_cRandom(0.5f, 1.5f)});
  m_pWorld->SetVel(ball, g_fSpeed * AngleToVector(m_cRandom(0, g_fTwoPi)));
}

// The action starts all balls anew.
void CBilliard::Before(unsigned keys) {
  if (keys & ~m_nLastKeys & (g_nAction | g_nNudge)) {
    for (std::size_t i = 0; i < m_pWorld->GetBallIds().size(); ++i)
      Start(m_pWorld->GetBallIds()[i]);
    m_fFlown = 0.0;
    m_nScore = 0;
  }
  m_nLastKeys = keys;
}

void CBilliard::After() {
  m_nScore += static_cast<int>(m_pWorld->GetContacts().size());
  for (const Vector2& v : m_pWorld->GetBallVelocities())
    m_fFlown += static_cast<double>(v.norm()) * GetTimeStep();
}

void CBilliard::PutBack(CShapeId ball) { Start(ball); }

unsigned CBilliard::Play() { return 0; }

std::string CBilliard::GetStatus() const {
  const double expected = GetExpectedPath();
  if (m_nScore == 0) return "No bounce yet";
  const double path = m_fFlown / m_nScore;
  char text[120];
  std::snprintf(text, sizeof text, "Mean free path %.4f; \u03c0 A/P is %.4f: off by %.2f%%", path, expected,
                100 * std::abs(path - expected) / expected);
  return text;
}

} // namespace Shapes::Games
