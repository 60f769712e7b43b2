// SPDX-License-Identifier: MIT
// The base of all games: a world that can change its engine while it runs, keys, a score, and a
// player who plays by a script. The terminal and the page run the same games.
#pragma once

#include "Mode.h"
#include "Random.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace Shapes::Games {

/// Of an angle in radians, with the same bits on every machine: for Sine.cpp.
float GetSine(float angle);
float GetCosine(float angle);

/// Keys that are held in a frame, as bits.
enum eKey : unsigned { g_nLeft = 1, g_nRight = 2, g_nAction = 4, g_nNudge = 8 };

/// The part of a shape in the game: it decides how the shape is drawn.
enum class eRole { Wall, Kicker, Flipper, Sensor, Lit, Gate, Ball };

inline constexpr unsigned g_nFramesPerSecond = 60;

class CGame {
public:
  virtual ~CGame() = default;
  CGame(const CGame&) = delete;
  CGame& operator=(const CGame&) = delete;

  /// One frame of 1/60 s.
  /// @param keys  bits of eKey
  void Frame(unsigned keys);
  /// The keys that the scripted player holds in the next frame; the same for the same seed and mode.
  virtual unsigned Play() = 0;
  /// Goes on in another mode, from the state as it is.
  void SetMode(const CMode& mode);

  const CWorld& GetWorld() const { return *m_pWorld; }
  const CMode& GetMode() const { return *m_pMode; }
  /// Of its worlds, but for what the mode adds.
  const CWorldDesc& GetDesc() const { return m_cDesc; }
  unsigned GetFrame() const { return m_nFrame; }
  int GetScore() const { return m_nScore; }
  /// Balls that left the table through a wall: the engine lost them, and the game put them back.
  int GetLost() const { return m_nLost; }
  eRole GetRole(CShapeId id) const;
  /// One line for the player: what to do, or what the figures are.
  virtual std::string GetStatus() const = 0;
  /// The box in which everything happens: to be drawn, and outside of which a ball is lost.
  const CAabb2D& GetBounds() const { return m_cBounds; }
  /// All that matters, in one line of text: frame, score, balls to the last bit.
  std::string GetTrace() const;

protected:
  /// @param desc    of its worlds; a whole number of time steps is a frame
  /// @param bounds  as of GetBounds
  CGame(const CWorldDesc& desc, const CAabb2D& bounds, const CMode& mode, std::uint32_t seed);
  static CWorldDesc MakeDesc(const Vector2& gravity, unsigned stepsPerFrame);
  float GetTimeStep() const { return m_cDesc.m_fTimeStep; }

  CShapeId Add(const CAnyShapeDesc& desc, eRole role = eRole::Wall);
  /// Adds a segment with a point on each end, so that balls meet the ends in every mode.
  void AddGuarded(const CLineSegDesc& desc, eRole role = eRole::Wall);
  void SetRole(CShapeId id, eRole role) { m_stdRoles[id] = role; }

  /// Before and after each step.
  virtual void Before(unsigned keys) = 0;
  virtual void After() = 0;
  /// Where a ball goes that the engine has lost.
  virtual void PutBack(CShapeId ball) = 0;

  std::unique_ptr<CWorld> m_pWorld;
  CRandom m_cRandom; ///< Of the game.
  CRandom
      m_cPlayerRandom; ///< Of the scripted player, so that a game without him goes on as it does with him.
  int m_nScore = 0;

private:
  void FindLost();

  CWorldDesc m_cDesc;
  unsigned m_nStepsPerFrame;
  CAabb2D m_cBounds;
  const CMode* m_pMode;
  std::map<CShapeId, eRole> m_stdRoles;
  unsigned m_nFrame = 0;
  int m_nLost = 0;
};

/// @param name  pinball, pile, billiard or breakout
/// @return null if there is no such game, or if the engine of the mode was not built
std::unique_ptr<CGame> MakeGame(std::string_view name, const CMode& mode, std::uint32_t seed);

} // namespace Shapes::Games
