// SPDX-License-Identifier: MIT
// A scene file that has every field there is.
#pragma once

#include <nlohmann/json.hpp>

namespace Shapes::Compare::Tests {

inline nlohmann::json OneOfEach() {
  return nlohmann::json::parse(R"({
    "$schema": "scene.schema.json", "name": "all", "description": "one of each", "length_unit": 2,
    "gravity": [1, -9.5], "time_step": 0.0078125, "duration": 3, "lasting": 4,
    "bounds": {"left": -5, "bottom": -6, "right": 7, "top": 8},
    "shapes": [
      {"type": "point", "name": "post", "position": [1, 2], "elasticity": 0.5, "filter": [2, 3], "motion": "kinematic",
       "shuttle": {"way": [1, 0], "speed": 2, "period": 1, "phase": 0.5}},
      {"type": "line_segment", "p0": [3, 0], "p1": [-3, 1], "sides": "back", "sensor": true, "motion": "static",
       "filter": [0, 65535]},
      {"type": "circle", "position": [4, 4], "radius": 0.25, "drain": true, "motion": "kinematic",
       "flip": {"angle": 1, "speed": 1, "period": 2}},
      {"type": "arc", "position": [0, 5], "radius": 2, "angles": [3, 0.5], "sides": "front", "motion": "kinematic",
       "rotation_speed": -0.5, "rotation_center": [0, 4]},
      {"type": "capsule", "p0": [1, 1], "p1": [2, 3], "radii": [0.5, 0.25], "sensor": true, "name": "finger"}],
    "compounds": [
      {"rotation_center": [-2, -2], "flip": {"angle": -1, "speed": 1, "period": 2, "phase": 0.5},
       "shapes": [{"type": "line_segment", "p0": [-2, -2], "p1": [-1, -2], "elasticity": 0.75, "sides": "both"},
                  {"type": "point", "position": [-1, -2], "name": "tip"},
                  {"type": "circle", "position": [-1, -2], "radius": 0.5, "sensor": true},
                  {"type": "arc", "position": [-1, -2], "radius": 0.5, "angles": [0, 1], "drain": false},
                  {"type": "capsule", "p0": [0, 0], "p1": [3, 1], "radii": [0.5, 0.25], "filter": [2, 1]}]},
      {"rotation_center": [0, 0], "rotation_speed": 1, "shapes": [{"type": "point", "position": [-1, -2]}]}],
    "balls": [
      {"position": [0, 0], "velocity": [3, 4], "radius": 0.5, "mass": 2, "elasticity": 0.25, "filter": [4, 1],
       "spread": {"position": [0.5, 1], "direction": 0.125, "speed": 0.5},
       "grid": {"columns": 2, "rows": 3, "spacing": [0.5, 1]}}]})");
}

} // namespace Shapes::Compare::Tests
