// SPDX-License-Identifier: MIT
// Scenes: what the tool runs on every engine, read from JSON files. docs/scenes.md describes the format.
#pragma once

#include <Shapes/Shapes.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// Most steps of a trial: a day of 100 steps a second.
inline constexpr std::size_t g_nMaxTrialSteps = 10'000'000;

/// How a game works a flipper: from rest it turns by m_fAngle at m_fSpeed, stays until half of the period,
/// goes back at the same speed and rests for what is left of the period; again and again. A loaded one has
/// the time for both ways: m_fPeriod >= 2 |m_fAngle| / (2 pi m_fSpeed).
struct CFlip {
  float m_fAngle = 0.0f;  ///< Radians, counterclockwise if positive.
  float m_fSpeed = 0.0f;  ///< Revolutions per second, above 0.
  float m_fPeriod = 0.0f; ///< Seconds, above 0.
  float m_fPhase = 0.0f;  ///< Seconds of the first period that are over at time 0.
};

/// A wall that goes and comes back as a flip does: by m_vWay at m_fSpeed, and back when half of the period is
/// over. A loaded one has the time for both ways: m_fPeriod >= 2 |m_vWay| / m_fSpeed.
struct CShuttle {
  Vector2 m_vWay = Vector2::Zero(); ///< User units.
  float m_fSpeed = 0.0f;            ///< User units per second, above 0.
  float m_fPeriod = 0.0f;           ///< Seconds, above 0.
  float m_fPhase = 0.0f;            ///< Seconds of the first period that are over at time 0.
};

/// A shape that is not a ball. The shapes of a compound carry its velocity, rotation centre, speed, flip and
/// shuttle each.
struct CSceneShape {
  CAnyShapeDesc m_cDesc;
  std::string m_sName;          ///< Empty if the file gives none.
  std::optional<CFlip> m_cFlip; ///< The shape is kinematic then, its own rotation speed is 0.
  bool m_bIsDrain = false;      ///< A sensor that puts a ball that touches it back to its start.
  std::optional<CShuttle> m_cShuttle = std::nullopt; ///< As m_cFlip; its own velocity is 0.
};

/// A ball and how its start varies: each coordinate of the position by +- m_vSpread, the direction of the
/// velocity by +- m_fTurn radians, the speed by a factor of 1 +- m_fSpeedSpread.
struct CSceneBall {
  CDynamicCircleDesc m_cDesc;
  Vector2 m_vSpread = Vector2::Zero();
  float m_fTurn = 0.0f;
  float m_fSpeedSpread = 0.0f;
};

/// A scene that was loaded is valid: a native world takes its descriptors, its balls start in its bounds. A
/// world on Box2D may refuse one whose lengths, speeds or masses are beyond its limits (Limits.h):
/// RequireHeld.
struct CScene {
  std::string m_sName, m_sDescription;
  std::filesystem::path m_cPath;
  CWorldDesc m_cWorld;
  CAabb2D m_cBounds;        ///< A centre of a ball outside has escaped.
  float m_fDuration = 0.0f; ///< Seconds, 1 to g_nMaxTrialSteps time steps.
  float m_fLasting = 0.0f;  ///< Seconds for which contact that lasts is measured, 0 if it is not.
  std::vector<CSceneShape> m_stdShapes;
  std::vector<CSceneBall> m_stdBalls;
};

/// The base of any descriptor.
const CShapeDesc& GetBase(const CAnyShapeDesc& any);

/// Whether a shape turns, by its rotation speed or by a flip.
bool Turns(const CSceneShape& shape);
/// Whether it moves by its velocity or a shuttle.
bool Travels(const CSceneShape& shape);
/// Whether it turns or travels.
bool Moves(const CSceneShape& shape);

/// The descriptors of all shapes of a scene.
std::vector<CAnyShapeDesc> GetShapes(const CScene& scene);

/// Why a file is no scene. what() is "<file>:<line>:<column>: <reason>" where it is no JSON, and
/// "<file>: <JSON path>: expected <what>, got <value>" for a field that is wrong, missing or unknown. The
/// path of the whole file is "/".
class CSceneError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Makes an empty world for a scene of which m_cWorld was read.
using CMakeWorld = std::function<std::unique_ptr<CWorld>(const CScene&)>;
std::unique_ptr<CWorld> MakeNativeWorld(const CScene& scene);

/// @param makeWorld  of the world that has to take every descriptor
/// @throws CSceneError if the file is missing, unreadable or no scene, or if the world refuses a descriptor
CScene LoadScene(const std::filesystem::path& file, const CMakeWorld& makeWorld = &MakeNativeWorld);
/// The scene that the file would be if this were its text.
/// @throws CSceneError if it is no scene
CScene ParseScene(const std::filesystem::path& file, const std::string& text);

/// All files *.json of the folder, sorted by file name.
/// @throws CSceneError if the folder cannot be read or has none, one of its files is no scene, or two scenes
/// have the same name
std::vector<CScene> LoadScenes(const std::filesystem::path& folder);

/// Radians from rest at time t, in seconds; any finite t. In double up to the result, so the error is 1 ulp
/// of it plus 2 pi speed times the rounding of t.
float FlipOrientation(const CFlip& flip, double t);
/// How far it is from rest at time t, user units.
Eigen::Vector2d ShuttleOffset(const CShuttle& shuttle, double t);

} // namespace Shapes::Compare
