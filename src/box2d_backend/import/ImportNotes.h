// SPDX-License-Identifier: MIT
// Differences of an imported scene from the game's b2World, in sentences.
#pragma once

#include <string>
#include <vector>

#include "ImportSurvey.h"

namespace Shapes::Box2D {

/// The gravity scale that all balls have, 1 if they do not have the same.
float GetCommonGravityScale(const CSurvey& survey);

/// @param elasticities  of the kinds of the survey
std::vector<std::string> MakeNotes(const b2World& world, const CSurvey& survey,
                                   const std::vector<CBounceKind>& kinds,
                                   const std::vector<CBouncePair>& pairs,
                                   const std::vector<float>& elasticities);

} // namespace Shapes::Box2D
