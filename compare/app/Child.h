// SPDX-License-Identifier: MIT
// Other programs.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Shapes::Compare {

/// Where the shell would find a program; none if it would not.
std::optional<std::filesystem::path> FindProgram(const std::string& name);

/// Runs a program. It reads nothing, what it prints is lost, its errors go into a file.
/// @param check called again and again meanwhile; if it throws, the program is killed
/// @return "" if it succeeded, else how it ended: "exit code 2", "signal 11"
/// @throws std::runtime_error if it cannot be started
std::string RunProgram(const std::vector<std::string>& words, const std::filesystem::path& errors,
                       const std::function<void()>& check);

/// Starts a program that may outlive this one; nothing is read or printed.
/// @throws std::runtime_error if it cannot be started
void StartProgram(const std::vector<std::string>& words);

/// A folder that is there as long as this is.
class CTemporaryFolder {
public:
  /// @throws std::runtime_error if it cannot be made
  CTemporaryFolder();
  ~CTemporaryFolder();
  CTemporaryFolder(const CTemporaryFolder&) = delete;
  CTemporaryFolder& operator=(const CTemporaryFolder&) = delete;
  const std::filesystem::path& GetPath() const { return m_cPath; }

private:
  std::filesystem::path m_cPath;
};

} // namespace Shapes::Compare
