// SPDX-License-Identifier: MIT
#include "Report.h"

#include <fstream>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

} // namespace

void RequireWritable(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder and cannot be made one" +
                             (error ? " (" + error.message() + ")" : ""));
  const std::filesystem::path probe = folder / ".writable";
  WriteFile(probe, "");
  std::filesystem::remove(probe, error);
}

void WriteReport(const CRunReport& report, const std::filesystem::path& folder) {
  RequireWritable(folder);
  WriteFile(folder / "run.json", MakeJson(report));
  WriteFile(folder / "contacts.csv", MakeCsv(report));
}

} // namespace Shapes::Compare
