// SPDX-License-Identifier: MIT
// JSON schemas, judged by a validator that is not ours: jsonschema for Python.
#pragma once

#include "app/Child.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace Shapes::Compare::Tests {

/// A file of the source tree.
/// @param name  its path relative to the root
inline nlohmann::json ReadJsonSource(const std::string& name) {
  std::ifstream in(std::filesystem::path(SHAPES_SOURCE_DIR) / name);
  if (!in) throw std::runtime_error(name + " cannot be read");
  return nlohmann::json::parse(in);
}

/// A scene that has every field there is; fuzzing begins with it, too.
inline nlohmann::json OneOfEach() { return ReadJsonSource("tests/fuzz/corpus/scene/everything.json"); }

/// Calls f with each value of a document, and its path.
template <class F>
void VisitValues(const nlohmann::json& value, const F& f,
                 const nlohmann::json::json_pointer& path = nlohmann::json::json_pointer()) {
  f(value, path);
  if (value.is_structured())
    for (const auto& part : value.items())
      VisitValues(part.value(), f, path / part.key());
}

/// For each document where it breaks the schema and how; empty if it fits.
/// @throws std::runtime_error if the validator fails
inline std::vector<std::string> FindSchemaFaults(const nlohmann::json& schema,
                                                 const std::vector<nlohmann::json>& documents) {
  const CTemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.GetPath();
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
  if (status != 0 || faults.size() != documents.size()) throw std::runtime_error("failed: " + command);
  return faults;
}

} // namespace Shapes::Compare::Tests
