// SPDX-License-Identifier: MIT
// A disc in a square: how far a ball flies between bounces, in the mean, is pi A / P, with A the area and P
// the perimeter of what its centre can reach.
#pragma once

#include "Game.h"

#include <vector>

namespace Shapes::Games {

class CBilliard final : public CGame {
public:
  CBilliard(const CMode& mode, std::uint32_t seed);

  unsigned Play() override;
  std::string GetStatus() const override;

private:
  static CWorldDesc MakeDesc();
  void Before(unsigned keys) override;
  void After() override;
  void PutBack(CShapeId ball) override;
  void Start(CShapeId ball);

  double m_fFlown = 0.0;
  unsigned m_nLastKeys = 0;
};

} // namespace Shapes::Games
