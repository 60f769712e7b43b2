// SPDX-License-Identifier: MIT
#include "Engines.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

std::vector<CEngineRow> MakeRows() {
  // Colours have a contrast of 3:1 to the page; those of one family differ in lightness, and marks tell all
  // of them apart without colour.
  std::vector<CEngineRow> rows{
      {g_sNative, "native", "native", "what a game gets by default", "native", g_cAutomatic,
       eProfile::Shipped, "circle", "#0061a8", "#6cbcff"},
      {g_sNativeApproximate, "native-approximate", "approx.", "no ball is swept", "native", g_cApproximate,
       eProfile::Shipped, "triangle", "#2f8f9d", "#5fd0c5"},
      {g_sBox2D, "Box2D", "box2d", "Box2D as it ships", "box2d", g_cAutomatic, eProfile::Shipped, "rect",
       "#c2410c", "#ff9a52"},
      {"box2d-tuned", "tuned Box2D", "tuned", "Box2D set for accuracy", "box2d", g_cAutomatic,
       eProfile::Tuned, "rectRot", "#7b1d84", "#d68cff"},
  };
  for (const CBackend& backend : GetBackends()) {
    const std::string name(backend.GetName());
    if (std::ranges::find(rows, name, &CEngineRow::m_sBackend) == rows.end())
      rows.push_back({name, name, name.substr(0, 7), "the engine as it comes", name, g_cAutomatic,
                      eProfile::Shipped, "rectRounded", "#5b6570", "#a9b1bb"});
  }
  return rows;
}

constexpr float g_fMostMetres = 2.0f; // b2_maxTranslation of a step

} // namespace

CWorldDesc CEngine::MakeWorldDesc(const CScene& scene) const {
  CWorldDesc desc = scene.m_cWorld;
  desc.m_nSubsteps = m_nSubsteps;
  desc.m_cEffects = m_cEffects;
  desc.m_cBox2D.m_eProfile = m_eProfile;
  desc.m_cBox2D.m_nVelocityIterations = m_nVelocityIterations;
  desc.m_cBox2D.m_nPositionIterations = m_nPositionIterations;
  desc.m_cBox2D.m_fLengthUnit /= m_fScale;
  // The tolerance is in Box2D's metres: scaled too, so that the scale alone does not change the pieces.
  desc.m_cBox2D.m_fSagittaTolerance *= m_fScale * m_fSagittaFactor;
  return desc;
}

std::string CEngine::GetLabel() const {
  const CEngine as{m_sName, m_pBackend};
  std::string label;
  const auto add = [&](const std::string& part) {
    if (!label.empty()) label += ", ";
    label += part;
  };
  if (m_nSubsteps != as.m_nSubsteps) add(fmt::format("{} substeps", m_nSubsteps));
  if (m_fScale != as.m_fScale) add(fmt::format("{:g}x scale", m_fScale));
  if (m_fSagittaFactor != as.m_fSagittaFactor) add(fmt::format("arcs {:g}x finer", 1.0f / m_fSagittaFactor));
  if (m_nVelocityIterations != as.m_nVelocityIterations || m_nPositionIterations != as.m_nPositionIterations)
    add(fmt::format("{}+{} iterations", m_nVelocityIterations, m_nPositionIterations));
  return label.empty() ? "as it comes" : label;
}

std::span<const CEngineRow> GetEngineRows() {
  static const std::vector<CEngineRow> rows = MakeRows();
  return rows;
}

const CEngineRow& GetEngineRow(std::string_view name) {
  for (const CEngineRow& row : GetEngineRows())
    if (row.m_sName == name) return row;
  throw std::out_of_range("no engine: " + std::string(name));
}

std::vector<CEngine> GetEngines() {
  std::vector<CEngine> engines;
  for (const CEngineRow& row : GetEngineRows()) {
    const CBackend* pBackend = GetBackend(row.m_sBackend);
    if (pBackend == nullptr)
      throw std::runtime_error(
          fmt::format("this build has no engine {}: expected all that are compared", row.m_sBackend));
    engines.push_back({row.m_sName, pBackend, 1, row.m_cEffects, row.m_eProfile});
  }
  return engines;
}

void RequireHeld(const CScene& scene, const std::vector<CEngine>& engines) {
  for (const CEngine& engine : engines)
    try {
      LoadScene(scene.m_cPath,
                [&](const CScene& read) { return engine.m_pBackend->MakeWorld(engine.MakeWorldDesc(read)); });
    } catch (const CSceneError& e) {
      throw CSceneError(fmt::format("{} on {} (--engines takes others)", e.what(), engine.m_sName));
    }
}

std::string WarnOfSpeed(const CScene& scene, const std::vector<CEngine>& engines) {
  float way = 0.0f; // the longest of a step
  for (const CSceneBall& ball : scene.m_stdBalls)
    way = std::max(way, ball.m_cDesc.m_vVel.stableNorm() * (1.0f + ball.m_fSpeedSpread) *
                            scene.m_cWorld.m_fTimeStep);
  const float unit = scene.m_cWorld.m_cBox2D.m_fLengthUnit;
  // The tuned profile cuts such steps.
  if (!FindEngine(engines, g_sBox2D) || way <= g_fMostMetres * unit) return "";
  return fmt::format(
      "{}: a ball moves by {:.3g} units in a step, and Box2D moves none by more than {:g} length_units ({:g} "
      "each): set length_unit",
      scene.m_sName, way, g_fMostMetres, unit);
}

std::optional<std::size_t> FindOther(const std::vector<CEngine>& engines) {
  for (std::size_t i = 1; i < engines.size(); ++i)
    if (engines[i].m_pBackend != engines[0].m_pBackend) return i;
  return std::nullopt;
}

std::optional<std::size_t> FindEngine(const std::vector<CEngine>& engines, std::string_view name) {
  for (std::size_t e = 0; e < engines.size(); ++e)
    if (engines[e].m_sName == name) return e;
  return std::nullopt;
}

const char* GetName(eProfile profile) { return profile == eProfile::Tuned ? "tuned" : "shipped"; }

} // namespace Shapes::Compare
