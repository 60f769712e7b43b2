// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Backend.h>

namespace Shapes {

const CBackend& GetBox2DBackend();

} // namespace Shapes
