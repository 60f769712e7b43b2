// SPDX-License-Identifier: MIT
// Pinball: three balls, three bumpers, two slingshots, a row of slots that starts a second ball, two
// flippers.
#pragma once

#include "Flipper.h"
#include "Game.h"

#include <array>
#include <optional>
#include <vector>

namespace Shapes::Games {

inline constexpr float g_fMostPull = 0.9f; ///< Of the plunger, units.

class CPinball final : public CGame {
public:
  CPinball(const CMode& mode, std::uint32_t seed);

  unsigned Play() override;
  std::string GetStatus() const override;

private:
  static CWorldDesc MakeDesc();
  void Before(unsigned keys) override;
  void After() override;
  void PutBack(CShapeId ball) override;

  // The table: PinballTable.cpp.
  void AddWalls();
  void AddKickers();
  void AddSensors();
  void AddPlunger();

  void MovePlunger(bool pull);
  void Nudge();
  Vector2 GetFreePlace() const;
  void Serve();
  void Drain(CShapeId ball);
  void LightSlot(CShapeId slot);
  bool IsNear(float side) const; ///< Whether a ball is where the flipper of that side would hit it.

  std::optional<CFlipper> m_cLeft, m_cRight;
  std::vector<CShapeId> m_stdPlunger;
  float m_fPush = 0.0f; ///< Speed of the plunger when it is let go.
  std::array<CShapeId, 3> m_stdSlots;
  CShapeId m_cDrain, m_cOrbit, m_cInlane;
  int m_nBallsLeft = 3;
  int m_nNudges = 0; ///< Of this ball; too many tilt.
  unsigned m_nLastKeys = 0;
  unsigned m_nHold = 0,
           m_nWait = 0; ///< The scripted player: frames to go on pulling, to wait for the next nudge.
};

} // namespace Shapes::Games
