// SPDX-License-Identifier: MIT
// JSON schemas, judged by a validator that is not ours: jsonschema for Python.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Shapes::Compare::Tests {

/// A file of the source tree.
/// @param name  its path relative to the root
nlohmann::json ReadJsonSource(const std::string& name);

/// For each document where it breaks the schema and how; empty if it fits.
/// @throws std::runtime_error if the validator fails
std::vector<std::string> FindSchemaFaults(const nlohmann::json& schema,
                                          const std::vector<nlohmann::json>& documents);

} // namespace Shapes::Compare::Tests
