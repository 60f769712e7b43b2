// SPDX-License-Identifier: MIT
// Closed vessels, and balls that fall into them or are pushed in them, on any engine.
#pragma once

#include "Testing.h"

namespace Shapes {

enum class eVessel { Box, V, Bowl, Hourglass, Paddle };
/// Balls that are all alike, of radii 1:10, of masses 1:1000, or of both.
enum class eMixture { Equal, Radii, Masses, Both };

inline constexpr float g_fPileGravity = 10;
inline constexpr float g_fLargestBall = 0.2f;

/// The middle of the floor is the origin.
struct CPileDesc {
  eVessel m_eVessel = eVessel::Box;
  int m_nBalls = 50;
  float m_fElasticity = 0.5f;
  eMixture m_eMixture = eMixture::Equal;
  float m_fHalf = std::max(1.0f, 0.3f * std::sqrt(static_cast<float>(m_nBalls))); // of the width
  float m_fNeck = 0.6f;                                                           // half of the hourglass's
  float m_fPaddleSpeed = 3;
  int m_nPaddleSteps = 300;
};

struct CPile : CPileDesc {
  std::unique_ptr<CWorld> m_pWorld;
  CShapeId m_cPaddle;

  CPile(std::unique_ptr<CWorld> pWorld, const CPileDesc& desc, CRandom random)
      : CPileDesc(desc), m_pWorld(std::move(pWorld)) {
    AddWalls();
    AddBalls(random);
  }

  float GetHeight() const { return 5 * m_fHalf; }

  /// How far a place is from the nearest wall; not above 0 outside.
  float GetRoom(const Vector2& p) const {
    const float x = std::abs(p.x()), y = p.y(), w = m_fHalf;
    const float inBox = std::min({w - x, y, GetHeight() - y}), slope = (w - m_fNeck) / w;
    switch (m_eVessel) {
    case eVessel::V: return std::min(inBox, (y - 2 * x) / std::sqrt(5.0f));
    case eVessel::Bowl: return y > w ? inBox : w - (p - Vector2(0, w)).norm();
    case eVessel::Hourglass:
      return std::min(inBox, (m_fNeck + std::abs(y - 2 * w) * slope - x) / std::hypot(1.0f, slope));
    default: return inBox;
    }
  }
  std::ptrdiff_t CountLost() const {
    return CountBalls(*m_pWorld, [&](const Vector2& p) { return !(p.allFinite() && GetRoom(p) > 0); });
  }
  double GetEnergy() const { return Shapes::GetEnergy(*m_pWorld, g_fPileGravity); }

  /// The paddle goes to and fro for m_nPaddleSteps, and then stands where it is.
  void Step(int step) {
    if (m_eVessel == eVessel::Paddle) {
      const float x = m_pWorld->GetPos(m_cPaddle).x(), turn = 0.6f * m_fHalf;
      if (step == 0 || x < -turn) m_pWorld->SetVel(m_cPaddle, {m_fPaddleSpeed, 0});
      if (x > turn) m_pWorld->SetVel(m_cPaddle, {-m_fPaddleSpeed, 0});
      if (step >= m_nPaddleSteps) m_pWorld->SetVel(m_cPaddle, {0, 0});
    }
    m_pWorld->Step();
  }

private:
  void AddPath(std::initializer_list<Vector2> path) {
    for (auto p = path.begin(); p + 1 != path.end(); ++p)
      m_pWorld->Add(CLineSegDesc(p[0], p[1]));
  }

  void AddWalls() {
    const float w = m_fHalf;
    if (m_eVessel == eVessel::Bowl) m_pWorld->Add(CArcDesc({0, w}, w, g_fPi, 2 * g_fPi));
    for (const float side : {-1.0f, 1.0f}) {
      const Vector2 lid(0, GetHeight()), top(side * w, GetHeight()), low(side * w, 0);
      switch (m_eVessel) {
      case eVessel::V: AddPath({lid, top, {side * w, 2 * w}, {0, 0}}); break;
      case eVessel::Bowl: AddPath({lid, top, {side * w, w}}); break;
      case eVessel::Hourglass:
        AddPath({lid, top, {side * w, 3 * w}, {side * m_fNeck, 2 * w}, {side * w, w}, low, {0, 0}});
        break;
      default: AddPath({lid, top, low, {0, 0}});
      }
    }
    if (m_eVessel == eVessel::Paddle)
      m_cPaddle = m_pWorld->Add(Turning(CLineSegDesc({0, 0.05f}, {0, 0.8f * w})));
  }

  /// In a lattice above whatever is narrow.
  void AddBalls(CRandom& random) {
    const bool hasRadii = m_eMixture == eMixture::Radii || m_eMixture == eMixture::Both;
    const bool hasMasses = m_eMixture == eMixture::Masses || m_eMixture == eMixture::Both;
    const bool isNarrow = m_eVessel == eVessel::Hourglass || m_eVessel == eVessel::V;
    const float pitch = 2.1f * g_fLargestBall, floor = (m_eVessel == eVessel::Paddle ? 0.8f
                                                        : isNarrow                   ? 3.0f
                                                                                     : 1.0f) *
                                                       m_fHalf;
    const int columns = static_cast<int>((2 * m_fHalf - 2.1f * g_fLargestBall) / pitch);
    for (int i = 0; i < m_nBalls; ++i) {
      const float x = pitch * (static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1));
      const float y = floor + 1.1f * g_fLargestBall + pitch * static_cast<float>(i / columns);
      const Vector2 shift = random.InSquare(0.04f * g_fLargestBall), v = random.InSquare(0.5f);
      const float r = hasRadii ? g_fLargestBall * std::pow(10.0f, -random.Uniform(0, 1)) : g_fLargestBall;
      const float m = hasMasses ? std::pow(1000.0f, random.Uniform(0, 1)) : 1.0f;
      m_pWorld->Add(CDynamicCircleDesc(Vector2(x, y) + shift, r, v, m, m_fElasticity));
    }
  }
};

} // namespace Shapes
