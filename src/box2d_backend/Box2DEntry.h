// SPDX-License-Identifier: MIT
#pragma once

#include "../world/Engine.h"

namespace Shapes::Box2D {

extern const CBackend::CEntry g_cEntry;

} // namespace Shapes::Box2D
