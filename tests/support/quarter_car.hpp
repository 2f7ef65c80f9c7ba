#pragma once
// A quarter car on a road.

#include <fmt/format.h>

#include <string>

#include "tests/support/reaction_support.hpp"

namespace mbgen::testing {

constexpr double kGravity = 9.81;  // m/s^2
inline const std::string kRubber =
    R"("tyre_data": { "rubber": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3,
  "FNOMIN": 4000, "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } })";

constexpr double kSprung = 300, kUnsprung = 40, kSpring = 2e4, kDamper = 1500, kTyre = 2e5,
                 kTyreDamper = 200;  // kg, N/m, N s/m

/// A quarter car that is pulled along a road at a speed, m/s; at rest on a flat one its coordinates are zero. Output:
/// the load of its tyre. contact: a member of the tyre, with a comma in front, or nothing.
inline MechanismInState quarter_car(const std::string& road, double speed, const std::string& contact = "") {
  const double centre = 0.3 - (kSprung + kUnsprung) * kGravity / kTyre;
  return MechanismInState(analysed(model_of(fmt::format(
      R"({{ "mbgen": 1, "name": "quarter_car",
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, {0}] }} }},
      "carriage": {{ "mass": 1, "com": [0, 0, {0}], "inertia": [1, 1, 1], "points": {{ "O": [0, 0, {0}] }} }},
      "hub": {{ "mass": {1}, "com": [0, 0, {0}], "inertia": [1, 1, 1], "points": {{ "O": [0, 0, {0}] }} }},
      "body": {{ "mass": {2}, "com": [0, 0, {0}], "inertia": [1, 1, 1], "points": {{ "O": [0, 0, {0}] }} }} }},
    "joints": {{ "x": {{ "type": "prismatic", "from": "ground.O", "to": "carriage.O", "axis": "x" }},
      "hub": {{ "type": "prismatic", "from": "carriage.O", "to": "hub.O", "axis": "z" }},
      "body": {{ "type": "prismatic", "from": "carriage.O", "to": "body.O", "axis": "z" }} }},
    "motions": {{ "pull": {{ "joint": "x", "position": "{3}*t" }} }},
    "joint_springs": {{ "strut": {{ "joint": "body", "relative_to": "hub", "stiffness": {4}, "damping": {5},
      "preload": {6} }} }}, {7},
    "roads": {{ "road": {8} }},
    "tyres": {{ "tyre": {{ "centre": "hub.O", "data": "rubber", "stiffness": {9}, "damping": {10}, "friction": 0,
      "rolling_resistance": 0{11} }} }},
    "outputs": {{ "load": {{ "tyre": "tyre", "quantity": "load" }} }} }})",
      centre, kUnsprung, kSprung, speed, kSpring, kDamper, -kSprung * kGravity, kRubber, road, kTyre, kTyreDamper,
      contact))));
}

}  // namespace mbgen::testing
