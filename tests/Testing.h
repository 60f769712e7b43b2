// SPDX-License-Identifier: MIT
// Nearly every test includes this.
#pragma once

#include "Balls.h"
#include "Descs.h"
#include "EveryShape.h"
#include "Messages.h"
#include "Numbers.h"
#include "Random.h"
#include "Steps.h"
#include "geometry/Cases.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <ostream>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace Shapes {

using Tests::CRandom, Tests::HowMany, Tests::ForEachCase;

} // namespace Shapes
