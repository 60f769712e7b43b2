// SPDX-License-Identifier: MIT
// Breakout: a ball, a curved paddle that is moved to the left and to the right, and bricks.
#pragma once

#include "Game.h"

#include <vector>

namespace Shapes::Games {

class CBreakout final : public CGame {
public:
  CBreakout(const CMode& mode, std::uint32_t seed);

  unsigned Play() override;
  std::string GetStatus() const override;

private:
  using CBrick = std::vector<CShapeId>;

  void Before(unsigned keys) override;
  void After() override;
  void PutBack(CShapeId ball) override;
  void AddBricks();
  void Break(CShapeId part);
  void KeepSpeed();

  std::vector<CBrick> m_stdBricks;
  CShapeId m_cPaddle, m_cDrain, m_cBall;
  int m_nBallsLeft = 3;
  bool m_bServed = false; ///< The ball waits above the paddle until the action.
  float m_fAim = 0.0f;    ///< The scripted player: where on the paddle it means to hit the ball.
};

} // namespace Shapes::Games
