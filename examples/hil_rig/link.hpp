#pragma once
// Policy for packets that are lost, late, doubled or broken: pure functions over packets and times, without sockets and
// clocks. docs/use/hil_rig.md has the policy as a table.

#include <cmath>

#include "packet.hpp"

namespace hil_rig {

constexpr std::int64_t kMillisecond = 1000000;  // ns

/// The numbers of the policy.
struct Policy {
  std::int64_t stale = 50 * kMillisecond;   ///< ns, a command that answers an older motion is dropped
  std::int64_t hold = 100 * kMillisecond;   ///< ns, so long the last command counts
  std::int64_t ramp = 1000 * kMillisecond;  ///< ns, in which it then goes to neutral: all values zero
  Command largest = {0.6, 12000};           ///< commands beyond are refused
};

/// Every packet that came is counted once in what follows `received`.
struct Counts {
  long received = 0;
  long accepted = 0;
  long corrupt = 0;    ///< size, magic, version, type or checksum wrong
  long refused = 0;    ///< whole, but values not finite or beyond their limits, or a time to come
  long foreign = 0;    ///< of another session while the present one speaks
  long duplicate = 0;  ///< came before
  long late = 0;       ///< a newer one came before
  long stale = 0;      ///< new by its number, but answers too old a motion
  long lost = 0;       ///< numbers that never came, not a part of `received`
};

/// Which numbers of a sender came: the newest one, and 64 before it.
struct Numbers {
  std::uint32_t newest = 0;
  std::uint64_t before = 0;  ///< bit k: number newest - 1 - k came
};

enum class Order { newer, duplicate, late };

/// Takes down a number. Result: what it is to those before; `skipped` grows by the numbers between and shrinks when
/// one of them comes after all.
constexpr Order note(Numbers& numbers, std::uint32_t sequence, long& skipped) {
  const auto ahead = static_cast<std::int32_t>(sequence - numbers.newest);
  if (ahead > 0) {
    numbers.before = ahead > 64 ? 0 : (ahead == 64 ? 0 : numbers.before << ahead) | (std::uint64_t{1} << (ahead - 1));
    numbers.newest = sequence;
    skipped += ahead - 1;
    return Order::newer;
  }
  if (ahead == 0) return Order::duplicate;
  if (ahead < -64) return Order::late;  // too long ago to tell
  const std::uint64_t bit = std::uint64_t{1} << (-ahead - 1);
  if ((numbers.before & bit) != 0) return Order::duplicate;
  numbers.before |= bit;
  --skipped;
  return Order::late;
}

/// The receiving end of the plant.
struct Link {
  bool opened = false;
  std::uint32_t session = 0;
  Numbers numbers;
  std::int64_t heard = 0;  ///< ns, when the last command was accepted
  std::int64_t echo = 0;   ///< ns, time of the motion that it answered
  Command command;
  Counts counts;
};

/// Whether a whole packet says something that a plant can do.
inline bool is_sound(const Policy& policy, const Header& header, const Command& command, std::int64_t now) {
  return header.type == Type::command && std::abs(command.steering) <= policy.largest.steering &&
         std::abs(command.drive_torque) <= policy.largest.drive_torque && header.time >= 0 && header.time <= now;
}

/// The link after a packet that came at `now` (ns on the plant's clock).
inline Link receive(Link link, const Policy& policy, const std::uint8_t* bytes, std::size_t size, std::int64_t now) {
  Counts& counts = link.counts;
  ++counts.received;
  const std::optional<Header> header = open(bytes, size);
  if (!header) return ++counts.corrupt, link;
  const Command command = header->type == Type::command ? payload_of<Command>(bytes) : Command{};
  if (!is_sound(policy, *header, command, now)) return ++counts.refused, link;
  const bool stale = now - header->time > policy.stale;
  if (!link.opened || header->session != link.session) {
    if (link.opened && now - link.heard <= policy.hold) return ++counts.foreign, link;
    if (stale) return ++counts.stale, link;
    link.opened = true;
    link.session = header->session;
    link.numbers = {header->sequence, ~std::uint64_t{0}};
  } else {
    const Order order = note(link.numbers, header->sequence, counts.lost);
    if (order == Order::duplicate) return ++counts.duplicate, link;
    if (order == Order::late) return ++counts.late, link;
    if (stale) return ++counts.stale, link;
  }
  ++counts.accepted;
  link.heard = now;
  link.echo = header->time;
  link.command = command;
  return link;
}

enum class Phase { silent, fresh, ramp, neutral };

constexpr const char* text(Phase phase) {
  constexpr const char* kTexts[] = {"no driver yet", "driven", "ramps to neutral", "neutral"};
  return kTexts[static_cast<int>(phase)];
}

/// Where the policy stands at `now`.
constexpr Phase phase_of(const Link& link, const Policy& policy, std::int64_t now) {
  if (!link.opened) return Phase::silent;
  const std::int64_t quiet = now - link.heard;
  if (quiet <= policy.hold) return Phase::fresh;
  return quiet < policy.hold + policy.ramp ? Phase::ramp : Phase::neutral;
}

/// The plant's command at `now`: the last command, held, then its ramp to neutral.
constexpr Command command_at(const Link& link, const Policy& policy, std::int64_t now) {
  switch (phase_of(link, policy, now)) {
    case Phase::fresh:
      return link.command;
    case Phase::ramp: {
      const double left = 1 - static_cast<double>(now - link.heard - policy.hold) / static_cast<double>(policy.ramp);
      return {left * link.command.steering, left * link.command.drive_torque};
    }
    default:
      return {};
  }
}

}  // namespace hil_rig
