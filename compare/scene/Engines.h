// SPDX-License-Identifier: MIT
// The engines that are compared: one table, which the runs, run.json, the page, its pictures and the terminal
// read.
#pragma once

#include "Scene.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Compare {

/// An engine with the settings under which a scene is run.
struct CEngine {
  /// A name of the table of engines; several settings of one engine share it.
  std::string m_sName;
  const CBackend* m_pBackend;
  unsigned m_nSubsteps = 1;
  CEffectChoice m_cEffects = g_cAutomatic;
  // Read by Box2D only.
  eProfile m_eProfile = eProfile::Shipped;
  unsigned m_nVelocityIterations = 8;
  unsigned m_nPositionIterations = 3;
  float m_fSagittaFactor = 1.0f; ///< Times the scene's sagitta tolerance: below 1 for more pieces of arcs.
  float m_fScale = 1.0f;         ///< Metres of Box2D to a metre of the scene.

  /// The scene's world with these settings.
  CWorldDesc MakeWorldDesc(const CScene& scene) const;
  /// The differences from the engine as it comes: "4 substeps, 10x scale"; "as it comes" without any.
  std::string GetLabel() const;
};

/// The world that a game gets by default.
inline constexpr const char* g_sNative = "native";
/// The same engine with balls that are never swept.
inline constexpr const char* g_sNativeApproximate = "native-approximate";
/// Box2D as it ships.
inline constexpr const char* g_sBox2D = "box2d";

/// A row of the table of engines.
struct CEngineRow {
  std::string m_sName;    ///< of --engines, run.json and every column
  std::string m_sSpoken;  ///< in sentences
  std::string m_sShort;   ///< above a narrow column, at most 7 characters
  std::string m_sMeaning; ///< what it is, in some words
  std::string m_sBackend; ///< CBackend::GetName
  CEffectChoice m_cEffects;
  eProfile m_eProfile;
  std::string m_sMark;   ///< its mark in pictures: "circle", "triangle", "rect", "rectRot" or "rectRounded"
  std::string m_sColour; ///< of the mark on white
  std::string m_sDark;   ///< of the mark on black
};

/// All rows: settings of native and of Box2D that are worth a column, and behind them each other engine of
/// GetBackends, as it comes.
std::span<const CEngineRow> GetEngineRows();
/// The row of a name. @throws std::out_of_range if there is none
const CEngineRow& GetEngineRow(std::string_view name);

/// The table as engines, as they come.
/// @throws std::runtime_error if one of them was not built
std::vector<CEngine> GetEngines();

/// Reads the file of the scene again, for each engine.
/// @throws CSceneError naming the field and the engine, if one of them cannot hold the scene
void RequireHeld(const CScene& scene, const std::vector<CEngine>& engines);

/// A warning about a ball that starts faster than Box2D moves any, if that is among the engines; else empty.
std::string WarnOfSpeed(const CScene& scene, const std::vector<CEngine>& engines);

/// The first engine that has another backend than the first of all; none if there is no such. Settings of one
/// backend share their CollisionDetected, with any effects and profile, so these two are compared
/// with each other.
std::optional<std::size_t> FindOther(const std::vector<CEngine>& engines);

std::optional<std::size_t> FindEngine(const std::vector<CEngine>& engines, std::string_view name);

/// "shipped" or "tuned".
const char* GetName(eProfile profile);

} // namespace Shapes::Compare
