// SPDX-License-Identifier: MIT
#include "Progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Shapes::Compare {
namespace {

struct CPartTime {
  const char* m_sName;
  double m_fShare;
};

// In the order of eStage.
constexpr CPartTime g_stdParts[] = {{"impacts", 0.2},  {"settings", 0.45}, {"timing", 0.05},
                                    {"heat map", 0.1}, {"effects", 0.1},   {"long runs", 0.05},
                                    {"lasting", 0.02}, {"replay", 0.03}};

constexpr std::chrono::milliseconds g_cRedrawInterval(100); // between two lines
constexpr double g_fFirstGuess = 3.0;                       // seconds after which the rest is guessed

std::string TimeLeft(double seconds) {
  if (seconds < 10.0) return "a few seconds left";
  if (seconds < 95.0) return fmt::format("about {:.0f} s left", std::round(seconds / 10.0) * 10.0);
  return fmt::format("about {:.0f} min left", std::round(seconds / 60.0));
}

} // namespace

double ShareOfScene(eStage part, double share) {
  const auto n = static_cast<std::size_t>(part);
  double before = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    before += g_stdParts[i].m_fShare;
  return before + g_stdParts[n].m_fShare * std::clamp(share, 0.0, 1.0);
}

std::string ProgressText(std::size_t scene, std::size_t scenes, const std::string& name, eStage part,
                         double share, double seconds) {
  std::string text =
      fmt::format("{}/{} {}  {} {:.0f}%", scene + 1, scenes, name,
                  g_stdParts[static_cast<std::size_t>(part)].m_sName, 100.0 * std::clamp(share, 0.0, 1.0));
  const double done = (static_cast<double>(scene) + ShareOfScene(part, share)) / static_cast<double>(scenes);
  if (seconds >= g_fFirstGuess && done > 0.0) text += "  " + TimeLeft(seconds * (1.0 - done) / done);
  return text;
}

CProgress::CProgress(std::size_t scenes, bool shown)
    : m_nScenes(scenes), m_bShown(shown), m_cStart(std::chrono::steady_clock::now()), m_cLast(m_cStart) {}

void CProgress::BeginScene(std::size_t scene, const std::string& name) {
  m_nScene = scene;
  m_sName = name;
  m_cLast = {}; // the first line of a scene comes at once
  Report(eStage::ImpactTrials, 0.0);
}

void CProgress::Report(eStage part, double share) {
  if (!m_bShown) return;
  const auto now = std::chrono::steady_clock::now();
  if (m_bIsOnScreen && now - m_cLast < g_cRedrawInterval) return;
  m_cLast = now;
  m_bIsOnScreen = true;
  const double seconds = std::chrono::duration<double>(now - m_cStart).count();
  fmt::print(stderr, "\r\033[K{}", ProgressText(m_nScene, m_nScenes, m_sName, part, share, seconds));
  std::fflush(stderr);
}

void CProgress::Clear() {
  if (!m_bIsOnScreen) return;
  m_bIsOnScreen = false;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

} // namespace Shapes::Compare
