// SPDX-License-Identifier: MIT
#include "Chart.h"
#include "Report.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shapes::Compare {
namespace {

constexpr int g_nMostLinks = 40; // as the system follows
constexpr std::array<const char*, 3> g_stdNames{"report.html", "run.json", "contacts.csv"};

// Paths of files and what goes into them.
using CTexts = std::vector<std::pair<std::filesystem::path, std::string>>;

[[noreturn]] void Refuse(const std::filesystem::path& file) {
  throw std::runtime_error(file.string() + ": cannot be written (" + std::strerror(errno) + ")");
}

// The file that is meant: a link stays one, and what it leads to is written.
std::filesystem::path FollowLinks(std::filesystem::path file) {
  std::error_code error;
  for (int i = 0; i < g_nMostLinks && std::filesystem::is_symlink(file, error); ++i)
    file = file.parent_path() / std::filesystem::read_symlink(file, error);
  return file;
}

bool AreSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  const auto full = [&](const std::filesystem::path& file) { // also of one that is not there yet
    return std::filesystem::weakly_canonical(std::filesystem::absolute(FollowLinks(file), error), error);
  };
  return std::filesystem::equivalent(a, b, error) || full(a) == full(b);
}

// Opened as it will be, but kept as it is if it is there. Devices and pipes are not even opened.
void RequireFile(const std::filesystem::path& name) {
  const std::filesystem::path file = FollowLinks(name);
  std::error_code error;
  const bool isThere = std::filesystem::exists(file, error);
  if (isThere && !std::filesystem::is_regular_file(file, error))
    throw std::runtime_error(name.string() + ": cannot be written (expected a regular file, or none yet)");
  errno = 0;
  if (!std::ofstream(file, std::ios::binary | std::ios::app)) Refuse(name);
  if (!isThere) std::filesystem::remove(file, error);
}

// Under other names first: what is there stays whole until all that is new is.
void WriteFiles(const CTexts& files) {
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> parts; // and what they become
  std::error_code error;
  try {
    for (const auto& [name, text] : files) {
      const std::filesystem::path file = FollowLinks(name), part = file.string() + ".part";
      std::filesystem::remove(part, error); // of a run that was killed
      errno = 0;
      std::ofstream out(part, std::ios::binary);
      if (!out) Refuse(name);
      parts.emplace_back(part, file);
      out << text;
      out.close();
      if (!out) Refuse(name);
    }
    for (const auto& [part, file] : parts) {
      std::filesystem::rename(part, file, error);
      errno = error.value();
      if (error) Refuse(file);
    }
  } catch (...) {
    for (const auto& [part, file] : parts)
      std::filesystem::remove(part, error);
    throw;
  }
}

} // namespace

void RequireWritable(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder and cannot be made one" +
                             (error ? " (" + error.message() + ")" : ""));
  for (const char* pName : g_stdNames)
    RequireFile(folder / pName);
}

void RequireChart(const std::filesystem::path& file, const std::filesystem::path& folder,
                  const std::vector<CScene>& scenes) {
  const auto refuse = [&](const char* pWhat) {
    throw std::runtime_error(
        fmt::format("{}: is {}: expected another file for the chart", file.string(), pWhat));
  };
  for (const CScene& scene : scenes)
    if (AreSame(file, scene.m_cPath)) refuse("a scene of this run");
  for (const char* pName : g_stdNames)
    if (AreSame(file, folder / pName)) refuse("a file of the report");
  RequireFile(file);
}

void WriteChart(const CRunReport& report, const std::filesystem::path& file) {
  WriteFiles({{file, DrawChart(MakeOverallChart(report, MakeOverall(report)), g_cWideChart, true) + "\n"}});
}

void WriteReport(const CRunReport& report, const std::filesystem::path& folder) {
  RequireWritable(folder);
  WriteFiles({{folder / g_stdNames[0],
               MakeHtml(MakePageJson(report), MakeReplayJson(report), MakeChartsJson(report))},
              {folder / g_stdNames[1], MakeJson(report)},
              {folder / g_stdNames[2], MakeCsv(report)}});
}

} // namespace Shapes::Compare
