// SPDX-License-Identifier: MIT
// What a run found, and the three forms in which it is handed out.
#pragma once

#include "../metrics/Cost.h"
#include "../metrics/Restart.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace Shapes::Compare {

struct CSceneReport {
  CScene m_cScene;
  CRestartResult m_cRestart;
  std::vector<CCost> m_stdCosts; ///< of each engine
};

struct CRunReport {
  std::string m_sCommand; ///< what reproduces it
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = 0; ///< asked for in each scene
  std::vector<CEngine> m_stdEngines;
  std::vector<CSceneReport> m_stdScenes;
};

/// The table for a terminal, ASCII, at most 116 columns.
std::string MakeTable(const CRunReport& report);

/// run.json. docs/accuracy.md describes it.
std::string MakeJson(const CRunReport& report);

/// contacts.csv: a row for each impact.
std::string MakeCsv(const CRunReport& report);

/// Writes run.json and contacts.csv into a folder, which is made if it is not there.
/// @throws std::runtime_error naming the file that cannot be written
void WriteReport(const CRunReport& report, const std::filesystem::path& folder);

/// Whether the folder can be written to, before any work is done; makes it.
/// @throws std::runtime_error naming the folder and the reason
void RequireWritable(const std::filesystem::path& folder);

} // namespace Shapes::Compare
