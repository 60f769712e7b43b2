// SPDX-License-Identifier: MIT
// Scenes for the tests of the metrics, those made by hand so that what has to come out is known.
#pragma once

#include "Testing.h"
#include "metrics/ImpactTrials.h"
#include "metrics/Statistics.h"
#include "scene/Trial.h"

namespace Shapes::Compare::Tests {

inline void AddShape(CScene& scene, const CAnyShapeDesc& desc) {
  CSceneShape shape;
  shape.m_cDesc = desc;
  scene.m_stdShapes.push_back(shape);
}

inline void AddBall(CScene& scene, const CDynamicCircleDesc& desc) {
  CSceneBall ball;
  ball.m_cDesc = desc;
  scene.m_stdBalls.push_back(ball);
}

/// Of 60 steps a second.
inline CScene MakeScene(float halfWidth, float duration, const std::vector<CAnyShapeDesc>& shapes = {},
                        const std::vector<CDynamicCircleDesc>& balls = {}, const Vector2& gravity = {0, 0}) {
  CScene scene;
  scene.m_sName = "made";
  scene.m_cBounds = CAabb2D({-halfWidth, halfWidth}, {halfWidth, -halfWidth});
  scene.m_fDuration = duration;
  scene.m_cWorld.m_vGravity = gravity;
  for (const CAnyShapeDesc& shape : shapes)
    AddShape(scene, shape);
  for (const CDynamicCircleDesc& ball : balls)
    AddBall(scene, ball);
  return scene;
}

/// To judge so many impacts of at most so many random trials.
template <class TOptions = CImpactTrialOptions>
TOptions MakeOptions(std::size_t contacts, std::uint64_t mostTrials, std::uint64_t seed = 5) {
  TOptions options;
  options.m_nSeed = seed;
  options.m_nContacts = contacts;
  options.m_nMostTrials = mostTrials;
  return options;
}
inline CImpactTrialResult Judge(const CScene& scene, std::size_t contacts, std::uint64_t mostTrials,
                                std::uint64_t seed = 5, const std::vector<CEngine>& engines = GetEngines()) {
  return RunImpactTrials(scene, engines, MakeOptions(contacts, mostTrials, seed));
}

/// The same with at most 20 trials for each impact.
inline CImpactTrialResult Judge(const CScene& scene, std::size_t contacts) {
  return Judge(scene, contacts, 20 * contacts);
}

/// One that comes with the tool.
inline CScene LoadBundled(const std::string& name) {
  return LoadScene(std::string(SHAPES_SCENES_DIR) + "/" + name + ".json");
}

/// The descriptors of a scene that was loaded.
inline CSceneDesc ToDesc(const CScene& scene) {
  CSceneDesc desc;
  desc.m_cWorld = scene.m_cWorld;
  desc.m_stdNotes = {scene.m_sDescription};
  desc.m_stdShapes = GetShapes(scene);
  for (const CSceneBall& ball : scene.m_stdBalls)
    desc.m_stdBalls.push_back(ball.m_cDesc);
  return desc;
}

/// Whether so many hits do not contradict the rate: within 3.3 standard errors, one in a thousand.
inline bool Holds(std::size_t hits, std::size_t n, double rate) {
  const CInterval i = Wilson(hits, n, 3.3);
  return i.m_fLow <= rate && rate <= i.m_fHigh;
}

/// The engine of this name, alone.
inline std::vector<CEngine> OnlyEngine(std::string_view name) {
  std::vector<CEngine> engines = GetEngines();
  std::erase_if(engines, [&](const CEngine& e) { return e.m_sName != name; });
  return engines;
}

inline constexpr std::size_t g_nNative = 0, g_nApproximate = 1, g_nBox2D = 2,
                             g_nTuned = 3; // in the order of GetEngines

/// Of these, without other engines that were built.
inline std::span<const CEngineRow> GetKnownRows() { return GetEngineRows().first(g_nTuned + 1); }

} // namespace Shapes::Compare::Tests
