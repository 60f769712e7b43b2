// SPDX-License-Identifier: MIT
// JSON schemas, judged by a validator that is not ours: jsonschema for Python.
#pragma once

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Shapes::Compare::Tests {

/// A file of the source tree.
/// @param name  its path relative to the root
inline nlohmann::json ReadJsonSource(const std::string& name) {
  std::ifstream in(std::filesystem::path(SHAPES_SOURCE_DIR) / name);
  if (!in) throw std::runtime_error(name + " cannot be read");
  return nlohmann::json::parse(in);
}

/// For each document where it breaks the schema and how; empty if it fits.
/// @throws std::runtime_error if the validator fails
inline std::vector<std::string> FindSchemaFaults(const nlohmann::json& schema,
                                                 const std::vector<nlohmann::json>& documents) {
  static int calls = 0;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("shapes-schema-test-" + std::to_string(getpid()) + "-" + std::to_string(++calls));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "schema") << schema.dump();
  std::ofstream lines(folder / "documents");
  for (const nlohmann::json& document : documents)
    lines << document.dump() << '\n';
  lines.close();
  const std::string command = "'" SHAPES_PYTHON "' '" SHAPES_SOURCE_DIR
                              "/tests/compare/schema/validate.py' '" +
                              (folder / "schema").string() + "' '" + (folder / "documents").string() +
                              "' > '" + (folder / "faults").string() + "'";
  const int status = std::system(command.c_str());
  std::vector<std::string> faults;
  std::ifstream in(folder / "faults");
  for (std::string line; std::getline(in, line);)
    faults.push_back(line);
  std::filesystem::remove_all(folder);
  if (status != 0 || faults.size() != documents.size()) throw std::runtime_error("failed: " + command);
  return faults;
}

} // namespace Shapes::Compare::Tests
