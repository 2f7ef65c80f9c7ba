#pragma once
// Messages sensor_msgs/JointState and the arrays of a generated solver. Message: any type with the fields name,
// position, velocity and effort.

#include <algorithm>
#include <cstddef>

namespace mbgen_ros2 {

/// Place of a name in a message, -1 for none.
template <class Message>
int place_of(const Message& message, const char* name) {
  const auto found = std::find(message.name.begin(), message.name.end(), name);
  return found == message.name.end() ? -1 : static_cast<int>(found - message.name.begin());
}

/// Names of a message, in the order of the solver; its positions and velocities become zeros. Call it once, outside of
/// the control loop.
template <class Message, std::size_t count>
void set_names(const char* const (&names)[count], Message& message) {
  message.name.assign(names, names + count);
  message.position.assign(count, 0.0);
  message.velocity.assign(count, 0.0);
}

/// Positions and velocities of all coordinates, rad or m. Requires: set_names. Allocates nothing.
template <class Message, class State>
void write_state(const State& state, Message& message) {
  std::copy(std::begin(state.z), std::end(state.z), message.position.begin());
  std::copy(std::begin(state.zd), std::end(state.zd), message.velocity.begin());
}

/// Reads positions and velocities by name, in whatever order the message has them. Result: the first name that the
/// message lacks, nullptr for none; the values are then complete. A message without velocities has zeros.
template <class Message, std::size_t count>
const char* read_positions(const Message& message, const char* const (&names)[count], double (&position)[count],
                           double (&velocity)[count]) {
  for (std::size_t i = 0; i < count; ++i) {
    const int place = place_of(message, names[i]);
    const auto at = static_cast<std::size_t>(place);
    if (place < 0 || at >= message.position.size()) return names[i];
    position[i] = message.position[at];
    velocity[i] = at < message.velocity.size() ? message.velocity[at] : 0;
  }
  return nullptr;
}

}  // namespace mbgen_ros2
