// SPDX-License-Identifier: MIT
// The text of a scene file as JSON, and how a field of it is refused. SceneFields.h reads the fields.
#pragma once

#include "Scene.h"

#include <nlohmann/json.hpp>

namespace Shapes::Compare {

using CJson = nlohmann::json;
using CJsonPath = CJson::json_pointer;

/// The document in the file. Each field is there once; which fields there are is not checked.
/// @throws CSceneError if the file is missing, unreadable or no JSON
CJson ReadSceneDocument(const std::filesystem::path& file);
/// The same of the text of such a file.
CJson ParseSceneDocument(const std::string& file, const std::string& text);

/// @throws CSceneError "<file>: <path>: expected <expected>, got <got>"
[[noreturn]] void RefuseField(const std::string& file, const CJsonPath& path, const std::string& expected,
                              const std::string& got);

/// The value at a path for a message, shortened if it is long, or "nothing".
std::string Got(const CJson& doc, const CJsonPath& path);

} // namespace Shapes::Compare
