#pragma once
// The figures that generated code has to reach. The tables of docs/evidence/performance.md print them beside the
// measured ones.

#include <string>
#include <string_view>
#include <vector>

namespace mbgen::compare {

/// Figures that are compared with a target.
enum class Figure {
  single_microseconds,
  lane_microseconds,  ///< per instance, eight instances in lanes
  operations,
  times_straightforward,
  times_mujoco,
  times_simbody,
  hot_bytes,
  compile_seconds,
  generation_seconds
};

struct Target {
  std::string_view model;
  Figure figure;
  double value;
};

/// Upper limits, but for the `times_` figures, which are lower ones.
inline constexpr Target kTargets[] = {
    {"coach_mechanism", Figure::single_microseconds, 0.45},  {"coach_mechanism", Figure::lane_microseconds, 0.14},
    {"coach_mechanism", Figure::operations, 4500},           {"coach_mechanism", Figure::times_straightforward, 45},
    {"coach_mechanism", Figure::times_mujoco, 50},           {"coach_mechanism", Figure::times_simbody, 500},
    {"coach_mechanism", Figure::hot_bytes, 32 * 1024},       {"coach_mechanism", Figure::compile_seconds, 10},
    {"coach_mechanism", Figure::generation_seconds, 1},      {"truck_mechanism", Figure::single_microseconds, 1.8},
    {"truck_mechanism", Figure::lane_microseconds, 0.40},    {"truck_mechanism", Figure::operations, 12000},
    {"truck_mechanism", Figure::times_straightforward, 110}, {"truck_mechanism", Figure::times_mujoco, 40},
    {"truck_mechanism", Figure::times_simbody, 750},         {"truck_mechanism", Figure::hot_bytes, 80 * 1024},
    {"truck_mechanism", Figure::compile_seconds, 40},        {"truck_mechanism", Figure::generation_seconds, 3},
    {"chain_7", Figure::single_microseconds, 0.30},          {"chain_30", Figure::single_microseconds, 1.8},
};

constexpr bool is_lower_limit(Figure figure) {
  return figure == Figure::times_straightforward || figure == Figure::times_mujoco || figure == Figure::times_simbody;
}

}  // namespace mbgen::compare
