// SPDX-License-Identifier: MIT
#pragma once

#include "Game.h"

#include <vector>

namespace Shapes::Games {

class CPile final : public CGame {
public:
  CPile(const CMode& mode, std::uint32_t seed);

  unsigned Play() override;
  std::string GetStatus() const override;

private:
  void Before(unsigned keys) override;
  void After() override;
  void PutBack(CShapeId ball) override;
  void Throw();

  CShapeId m_cLine;
  std::vector<CShapeId> m_stdBar;
  unsigned m_nLastKeys = 0;
};

} // namespace Shapes::Games
