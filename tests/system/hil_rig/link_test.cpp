// The policy over packets: what is taken, what is dropped and how it is counted, without a socket or a clock.

#include "link.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "faults.hpp"

namespace hil_rig {
namespace {

constexpr Policy kPolicy;
constexpr std::int64_t kMs = kMillisecond;

Bytes command_packet(std::uint32_t sequence, std::int64_t echo, Command command = {0.1, 100},
                     std::uint32_t session = 1) {
  Packet packet;
  const std::size_t size = encode({Type::command, session, sequence, echo, 0, 0}, command, packet);
  return {packet.begin(), packet.begin() + static_cast<long>(size)};
}

Link given(const Link& link, const Bytes& packet, std::int64_t now) {
  return receive(link, kPolicy, packet.data(), packet.size(), now);
}

long dropped(const Counts& c) { return c.corrupt + c.refused + c.foreign + c.duplicate + c.late + c.stale; }

TEST(Link, IsNeutralUntilADriverSpeaks) {
  const Link link;
  EXPECT_EQ(phase_of(link, kPolicy, 5000 * kMs), Phase::silent);
  EXPECT_EQ(command_at(link, kPolicy, 5000 * kMs).steering, 0);
  const Link spoken = given(link, command_packet(41, 10 * kMs), 11 * kMs);
  EXPECT_EQ(phase_of(spoken, kPolicy, 11 * kMs), Phase::fresh);
  EXPECT_EQ(command_at(spoken, kPolicy, 11 * kMs).drive_torque, 100);
  EXPECT_EQ(spoken.counts.accepted, 1);
  EXPECT_EQ(spoken.counts.lost, 0) << "a driver may begin at any number";
}

TEST(Link, HoldsThenRampsThenIsNeutral) {
  const Link link = given({}, command_packet(1, 0, {0.2, -400}), 0);
  EXPECT_EQ(command_at(link, kPolicy, 100 * kMs).steering, 0.2);
  EXPECT_EQ(phase_of(link, kPolicy, 101 * kMs), Phase::ramp);
  EXPECT_NEAR(command_at(link, kPolicy, 600 * kMs).steering, 0.1, 1e-12);
  EXPECT_NEAR(command_at(link, kPolicy, 600 * kMs).drive_torque, -200, 1e-9);
  EXPECT_NEAR(command_at(link, kPolicy, 1099 * kMs).steering, 0.0002, 1e-12);
  EXPECT_EQ(phase_of(link, kPolicy, 1100 * kMs), Phase::neutral);
  EXPECT_EQ(command_at(link, kPolicy, 1100 * kMs).steering, 0);
  const Link again = given(link, command_packet(2, 2000 * kMs), 2001 * kMs);
  EXPECT_EQ(command_at(again, kPolicy, 2001 * kMs).steering, 0.1) << "a driver that comes back is heard";
}

TEST(Link, DropsDuplicatesAndWhatWasOvertaken) {
  Link link = given({}, command_packet(10, 0, {0.1, 0}), 0);
  link = given(link, command_packet(13, 0, {0.3, 0}), 0);
  EXPECT_EQ(link.counts.lost, 2);
  link = given(link, command_packet(12, 0, {0.2, 0}), 0);
  EXPECT_EQ(link.counts.late, 1);
  EXPECT_EQ(link.counts.lost, 1) << "it was not lost after all";
  link = given(link, command_packet(12, 0, {0.2, 0}), 0);
  link = given(link, command_packet(13, 0, {0.2, 0}), 0);
  EXPECT_EQ(link.counts.duplicate, 2);
  link = given(link, command_packet(9, 0, {0.2, 0}), 0);
  EXPECT_EQ(link.counts.duplicate, 3) << "what was before the driver was heard is nothing new";
  EXPECT_EQ(link.command.steering, 0.3);
  EXPECT_EQ(link.counts.received, link.counts.accepted + dropped(link.counts));
}

TEST(Link, NumbersGoRound) {
  Link link = given({}, command_packet(0xfffffffe, 0), 0);
  for (std::uint32_t sequence = 0xffffffff; sequence != 3; ++sequence)
    link = given(link, command_packet(sequence, 0), 0);
  EXPECT_EQ(link.counts.accepted, 5);
  EXPECT_EQ(link.counts.lost, 0);
  link = given(link, command_packet(0xffffffff, 0), 0);
  EXPECT_EQ(link.counts.duplicate, 1);
}

TEST(Link, AJumpForgetsWhatWasBefore) {
  for (const std::uint32_t jump : {63u, 64u, 65u, 1000u}) {
    Link link = given({}, command_packet(100, 0), 0);
    link = given(link, command_packet(100 + jump, 0), 0);
    EXPECT_EQ(link.counts.lost, static_cast<long>(jump) - 1);
    link = given(link, command_packet(100, 0), 0);
    EXPECT_EQ(link.counts.duplicate, jump <= 64 ? 1 : 0) << jump;
    EXPECT_EQ(link.counts.late, jump <= 64 ? 0 : 1) << jump;
  }
}

TEST(Link, DropsWhatAnswersAnOldMotion) {
  Link link = given({}, command_packet(1, 0), 50 * kMs);
  EXPECT_EQ(link.counts.accepted, 1) << "50 ms is not too old";
  link = given(link, command_packet(2, 20 * kMs), 71 * kMs);
  EXPECT_EQ(link.counts.stale, 1);
  EXPECT_EQ(link.heard, 50 * kMs) << "it does not prolong the hold";
  link = given(link, command_packet(3, 60 * kMs), 72 * kMs);
  EXPECT_EQ(link.counts.accepted, 2);
  EXPECT_EQ(link.counts.lost, 0);
}

TEST(Link, RefusesWhatNoPlantCanDo) {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");
  Link link;
  for (const Command command : {Command{none, 0}, Command{0, none}, Command{infinite, 0}, Command{0, -infinite},
                                Command{0.61, 0}, Command{0, -12001}}) {
    link = given(link, command_packet(1, 0, command), 0);
  }
  link = given(link, command_packet(1, 2 * kMs), kMs);  // answers a motion to come
  link = given(link, command_packet(1, -1), kMs);
  EXPECT_EQ(link.counts.refused, 8);
  EXPECT_FALSE(link.opened);
  Packet packet;
  const std::size_t size = encode({Type::motion, 1, 1, 0, 0, 0}, Motion{}, packet);
  link = receive(link, kPolicy, packet.data(), size, 0);
  EXPECT_EQ(link.counts.refused, 9) << "a motion is no command";
}

TEST(Link, HearsOneDriverAtATime) {
  Link link = given({}, command_packet(50, 0, {0.1, 0}, 1), 0);
  link = given(link, command_packet(1, 0, {0.2, 0}, 2), 30 * kMs);
  EXPECT_EQ(link.counts.foreign, 1);
  EXPECT_EQ(link.command.steering, 0.1);
  link = given(link, command_packet(2, 100 * kMs, {0.2, 0}, 2), 101 * kMs);
  EXPECT_EQ(link.counts.accepted, 2) << "the first has been silent for long enough";
  EXPECT_EQ(link.session, 2u);
  EXPECT_EQ(link.counts.lost, 0);
  link = given(link, command_packet(51, 100 * kMs, {0.1, 0}, 1), 102 * kMs);
  EXPECT_EQ(link.counts.foreign, 2);
  link = given(link, command_packet(51, 100 * kMs, {0.1, 0}, 1), 300 * kMs);
  EXPECT_EQ(link.counts.stale, 1) << "an old packet of a driver that was does not take over";
  EXPECT_EQ(link.session, 2u);
}

// The link through a network with faults, against sets of numbers.
TEST(Link, CountsWhatTheNetworkDid) {
  FaultyNetwork network;
  Link link;
  std::set<std::uint32_t> came;
  long duplicates = 0, late = 0, accepted = 0;
  for (std::uint32_t sequence = 1; sequence <= 20000; ++sequence) {
    const std::int64_t now = sequence * kMs;
    for (const Bytes& packet : deliver(network, command_packet(sequence, now))) {
      link = given(link, packet, now);
      const auto header = open(packet.data(), packet.size());
      if (!header) continue;
      const bool newest = came.empty() || header->sequence > *came.rbegin();
      (!came.insert(header->sequence).second ? duplicates : newest ? accepted : late) += 1;
      EXPECT_EQ(link.numbers.newest, *came.rbegin());
    }
  }
  const Counts& counts = link.counts;
  EXPECT_EQ(counts.corrupt, network.corrupted + network.garbage);
  EXPECT_EQ(counts.duplicate, network.doubled);
  EXPECT_EQ(counts.duplicate, duplicates);
  EXPECT_EQ(counts.late, late);
  EXPECT_EQ(counts.accepted, accepted);
  EXPECT_EQ(counts.received, accepted + dropped(counts));
  const long spanned = static_cast<long>(*came.rbegin() - *came.begin()) + 1;
  EXPECT_EQ(counts.lost, spanned - static_cast<long>(came.size()));
  EXPECT_GT(counts.late, 1000);
  EXPECT_GT(network.lost, 1500);
}

}  // namespace
}  // namespace hil_rig
