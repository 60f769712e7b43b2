// SPDX-License-Identifier: MIT
#include "Schema.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace Shapes::Compare::Tests {

using nlohmann::json;
namespace fs = std::filesystem;

json ReadJsonSource(const std::string& name) {
  std::ifstream in(fs::path(SHAPES_SOURCE_DIR) / name);
  if (!in) throw std::runtime_error(name + " cannot be read");
  return json::parse(in);
}

std::vector<std::string> FindSchemaFaults(const json& schema, const std::vector<json>& documents) {
  static int calls = 0;
  const fs::path folder = fs::temp_directory_path() /
                          ("shapes-schema-test-" + std::to_string(getpid()) + "-" + std::to_string(++calls));
  fs::create_directories(folder);
  std::ofstream(folder / "schema") << schema.dump();
  std::ofstream lines(folder / "documents");
  for (const json& document : documents)
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
  fs::remove_all(folder);
  if (status != 0 || faults.size() != documents.size()) throw std::runtime_error("failed: " + command);
  return faults;
}

} // namespace Shapes::Compare::Tests
