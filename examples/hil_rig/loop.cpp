#include "loop.hpp"

#include "realtime.hpp"

namespace hil_rig {

namespace {

constexpr std::int64_t kPeriod = 1000000;  // ns, kStep
constexpr int kPacketsPerCycle = 64;       // more wait for the next: the work of a cycle is bounded

struct Cycle {
  const LoopSettings& settings;
  const Socket& socket;
  Plant& plant;
  Shared& shared;
  Tally& tally;
  std::uint32_t sequence = 0;
  Phase phase = Phase::silent;

  void say(Event::Kind kind, long value) noexcept {
    if (!shared.events.push({kind, tally.cycles, value})) ++tally.unsaid;
  }

  void take_packets(std::int64_t now) noexcept {
    std::array<std::uint8_t, kLargestPacket + 64> bytes;  // a longer one shows by its size
    for (int i = 0; i < kPacketsPerCycle; ++i) {
      const long size = socket.receive(bytes);
      if (size < 0) return;
      const std::uint32_t session = tally.link.session;
      const bool opened = tally.link.opened;
      tally.link = receive(tally.link, settings.policy, bytes.data(), static_cast<std::size_t>(size), now);
      if (tally.link.opened && (!opened || tally.link.session != session)) {
        say(Event::Kind::session, static_cast<long>(tally.link.session));
      }
    }
  }

  void send_motion(std::int64_t now, bool last) noexcept {
    Header header{Type::motion, settings.session, ++sequence, now, 0, last ? kLast : 0};
    if (!tally.status.ok()) header.flags |= kFailed;
    Packet packet;
    const std::size_t size = encode(header, motion_of(plant), packet);
    if (!socket.send({packet.data(), size}, settings.peer)) ++tally.unsent;
  }

  // One cycle at `now`, ns since the loop began. Result: whether it is the last.
  bool run(std::int64_t now) noexcept {
    take_packets(now);
    if (coach_rig::Parameters taken; shared.parameters.take(taken)) {
      plant.parameters = taken;
      say(Event::Kind::parameters, 0);
    }
    const Phase before = phase;
    phase = phase_of(tally.link, settings.policy, now);
    if (phase != before) say(Event::Kind::phase, static_cast<long>(phase));
    tally.status = step(plant, command_at(tally.link, settings.policy, now));
    if (!tally.status.ok()) say(Event::Kind::failed, static_cast<long>(tally.status.code));
    ++tally.cycles;
    const bool last =
        shared.stop.load(std::memory_order_relaxed) || tally.cycles == settings.cycles || !tally.status.ok();
    send_motion(now, last);
    return last;
  }

  void show() noexcept {
    shared.glance.publish({tally.cycles, tally.overruns, tally.missed, mean(tally.wakeup), tally.wakeup.largest,
                           mean(tally.work), tally.work.largest, phase, tally.link.counts, motion_of(plant)});
  }
};

}  // namespace

void run_loop(const LoopSettings& settings, const Socket& socket, Plant& plant, Shared& shared, Tally& tally) noexcept {
  Cycle cycle{settings, socket, plant, shared, tally};
  Plant rehearsal = plant;
  tally.status = step(rehearsal, {});  // brings code and data into the caches before the clock runs
  const std::int64_t begin = monotonic_now();
  std::int64_t wake = begin + kPeriod;
  for (bool last = false; !last;) {
    sleep_until(wake);
    const std::int64_t awake = monotonic_now();
    last = cycle.run(awake - begin);
    const std::int64_t ready = monotonic_now();
    add(tally.wakeup, awake - wake, tally.cycles - 1);
    add(tally.work, ready - awake, tally.cycles - 1);
    wake += kPeriod;
    if (ready > wake && !last) {
      const std::int64_t missed = (ready - wake + kPeriod - 1) / kPeriod;
      ++tally.overruns;
      tally.missed += static_cast<long>(missed);
      wake += missed * kPeriod;
      cycle.say(Event::Kind::overrun, static_cast<long>(missed));
    }
    cycle.show();
  }
  shared.done.store(true, std::memory_order_release);
}

}  // namespace hil_rig
