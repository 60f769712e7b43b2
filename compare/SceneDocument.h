// SPDX-License-Identifier: MIT
// The text of a scene file as JSON that fits the schema. Used by Scene.cpp alone.
#pragma once

#include "Scene.h"

#include <nlohmann/json.hpp>

namespace Shapes::Compare {

/// The document in the file. Its fields are the known ones, each is there once and of the right type and
/// sign.
/// @throws CSceneError if the file is missing, unreadable, no JSON or does not fit the schema
nlohmann::json ReadSceneDocument(const std::filesystem::path& file);
/// The same of the text of such a file.
nlohmann::json ParseSceneDocument(const std::string& file, const std::string& text);

/// @throws CSceneError "<file>: <path>: expected <expected>, got <got>"
[[noreturn]] void RefuseField(const std::string& file, const nlohmann::json::json_pointer& path,
                              const std::string& expected, const std::string& got);

/// What stands at a path, for a message: the value, shortened if it is long, or "nothing".
std::string Got(const nlohmann::json& doc, const nlohmann::json::json_pointer& path);

} // namespace Shapes::Compare
