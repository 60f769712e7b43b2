// SPDX-License-Identifier: MIT
#pragma once

#include "../world/Engine.h"

namespace Shapes::Native {

extern const CBackend::CEntry g_cEntry;

} // namespace Shapes::Native
