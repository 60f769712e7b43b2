// SPDX-License-Identifier: MIT
// A world as it is now, as descriptors: to go on in another one, or as a scene file.
#pragma once

#include <Shapes/Shapes.h>

namespace Shapes::Games {

/// Everything that can collide or sense, at its present pose and speed; what has stops stands still.
CSceneDesc Describe(const CWorld& world);

} // namespace Shapes::Games
