// SPDX-License-Identifier: MIT
#include "Run.h"

#include "scene/Interrupt.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

// A larger scale makes what an engine can hold smaller.
bool CanHold(const CEngine& engine, const CScene& scene) {
  try {
    CTrialWorld(scene, engine, MakeStart(scene, 0, 0).m_stdBalls, 0.0);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// The settings of these engines under which the scene can be played.
std::vector<CEngine> SelectSettings(const std::vector<CEngine>& engines, const CScene& scene) {
  std::vector<CEngine> sweep = GetParameterSweep();
  std::erase_if(sweep, [&](const CEngine& setting) {
    return !CanHold(setting, scene) ||
           std::none_of(engines.begin(), engines.end(),
                        [&](const CEngine& engine) { return engine.m_sName == setting.m_sName; });
  });
  return sweep;
}

} // namespace

CRunSizes CRunSizes::ForContacts(std::size_t contacts) const {
  CRunSizes sizes = *this;
  sizes.m_nContacts = contacts;
  if (contacts >= m_nContacts) return sizes;
  const double share = static_cast<double>(contacts) / static_cast<double>(m_nContacts);
  const auto shrink = [&](std::size_t& n, std::size_t least) {
    n = std::min(n, std::max(least, static_cast<std::size_t>(share * static_cast<double>(n))));
  };
  shrink(sizes.m_nBallSteps, 500);
  shrink(sizes.m_nSweepContacts, 10);
  shrink(sizes.m_nConfirmation, 10);
  shrink(sizes.m_nSweepBallSteps, 100);
  shrink(sizes.m_nHeatContacts, 5);
  shrink(sizes.m_nBounces, 100);
  shrink(sizes.m_nLongSteps, 5000);
  shrink(sizes.m_nFrames, 60);
  shrink(sizes.m_nEffectContacts, 10);
  shrink(sizes.m_nEffectBallSteps, 100);
  shrink(sizes.m_nCountedSteps, 20);
  return sizes;
}

CSceneReport RunScene(const CScene& scene, const std::vector<CEngine>& engines, const CRunSizes& sizes,
                      std::uint64_t seed, const std::function<void(eStage, double)>& progress) {
  const auto during = [&](eStage part) { return [&progress, part](double share) { progress(part, share); }; };
  const auto getTrials = [&](std::size_t contacts, eStage part) {
    return CTrials{seed, contacts, g_nTrialsPerContact * contacts, during(part)};
  };
  CSceneReport report;
  report.m_cScene = scene;

  report.m_cImpactTrials =
      RunImpactTrials(scene, engines, {getTrials(sizes.m_nContacts, eStage::ImpactTrials)});
  const std::vector<CContact>& contacts = report.m_cImpactTrials.m_stdContacts;
  report.m_cDifference = SummariseDifference(contacts);

  const CParameterSweepOptions sweep{getTrials(sizes.m_nSweepContacts, eStage::ParameterSweep),
                                     sizes.m_nConfirmation, sizes.m_nSweepBallSteps, sizes.m_nSweepRepeats};
  report.m_cWork = MeasureWorkPrecision(scene, SelectSettings(engines, scene), sweep);

  const std::vector<CCost> costs =
      MeasureCost(scene, engines, seed, sizes.m_nRepeats, sizes.m_nBallSteps, during(eStage::Timing));
  report.m_cHeatMap = MeasureHeatMap(scene, engines, seed, sizes.m_nHeatContacts, during(eStage::HeatMap));
  const CEffectOptions effects{getTrials(sizes.m_nEffectContacts, eStage::Effects), sizes.m_nEffectRepeats,
                               sizes.m_nEffectBallSteps, sizes.m_nCountedSteps,
                               std::filesystem::read_symlink("/proc/self/exe").string()};
  report.m_cEffects = MeasureEffects(scene, engines, effects);

  progress(eStage::LongRuns, 0.0);
  const std::vector<CLongRun> longRuns =
      MeasureLongRuns(scene, engines, seed, sizes.m_nBounces, sizes.m_nLongSteps);
  const std::vector<CLasting> lasting =
      MeasureLasting(scene, engines, seed, sizes.m_nLastingTrials, during(eStage::Lasting));
  progress(eStage::Replay, 0.0);
  report.m_stdClips = MakeClips(scene, engines, report.m_cImpactTrials, seed, sizes.m_nFrames);

  for (std::size_t e = 0; e < engines.size(); ++e)
    report.m_stdEngines.push_back({MakeTotals(contacts, e), report.m_cImpactTrials.m_stdGhosts.at(e),
                                   MakeBins(contacts, e), MakeHistogram(contacts, e), costs.at(e),
                                   longRuns.at(e), lasting.at(e)});
  return report;
}

CRunReport RunScenes(const std::vector<CScene>& scenes, const std::vector<CEngine>& engines,
                     const CRunSizes& sizes, std::uint64_t seed, CProgress& progress,
                     const std::function<void()>& check,
                     const std::function<void(const CSceneReport&)>& finished) {
  CRunReport report;
  report.m_nSeed = seed;
  report.m_nContacts = sizes.m_nContacts;
  report.m_stdEngines = engines;
  std::string name;
  try {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      name = scenes[i].m_sName;
      progress.BeginScene(i, name);
      report.m_stdScenes.push_back(RunScene(scenes[i], engines, sizes, seed, [&](eStage part, double share) {
        check();
        progress.Report(part, share);
      }));
      progress.Clear();
      if (finished) finished(report.m_stdScenes.back());
    }
  } catch (const CInterrupted&) {
    report.m_bInterrupted = true;
  } catch (const std::exception& e) {
    throw std::runtime_error(name + ": " + e.what());
  }
  progress.Clear();
  return report;
}

} // namespace Shapes::Compare
