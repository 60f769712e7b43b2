// SPDX-License-Identifier: MIT
#include "Chart.h"
#include "Report.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

constexpr std::array<const char*, 3> g_stdNames{"report.html", "run.json", "contacts.csv"};

[[noreturn]] void Refuse(const std::filesystem::path& file) {
  throw std::runtime_error(file.string() + ": cannot be written (" + std::strerror(errno) + ")");
}

// Under another name first: a file that is there stays whole until the new one is.
void WriteFile(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path part = file.string() + ".part";
  errno = 0;
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) Refuse(file);
}

} // namespace

void RequireWritable(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder and cannot be made one" +
                             (error ? " (" + error.message() + ")" : ""));
  // Each file is opened as it will be, but kept as it is if it is there.
  for (const char* pName : g_stdNames) {
    const std::filesystem::path file = folder / pName;
    const bool isThere = std::filesystem::exists(file, error);
    errno = 0;
    if (!std::ofstream(file, std::ios::binary | std::ios::app)) Refuse(file);
    if (!isThere) std::filesystem::remove(file, error);
  }
}

void WriteChart(const CRunReport& report, const std::filesystem::path& file) {
  WriteFile(file, DrawChart(MakeOverallChart(report, MakeOverall(report)), g_cWideChart, true) + "\n");
}

void WriteReport(const CRunReport& report, const std::filesystem::path& folder) {
  RequireWritable(folder);
  WriteFile(folder / g_stdNames[0],
            MakeHtml(MakePageJson(report), MakeReplayJson(report), MakeChartsJson(report)));
  WriteFile(folder / g_stdNames[1], MakeJson(report));
  WriteFile(folder / g_stdNames[2], MakeCsv(report));
}

} // namespace Shapes::Compare
