// The plant without a network, then the loop itself with one: how it drives, and that it never asks for memory. Linked
// with tests/support/heap.cpp, which counts.

#include <cmath>
#include <cstdio>
#include <memory>

#include "driver_model.hpp"
#include "loop.hpp"

extern "C" long heap_calls();

namespace {

using namespace hil_rig;

int failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "loop_check.cpp: not so: %s\n", what);
  ++failures;
}

// Plant and driver in lock step: the double lane change.
void check_drive() {
  const Driver driver;
  Plant plant;
  expect(start(plant).ok(), "the coach stands in equilibrium");
  double farthest = 0, out = 0, behind = 0;
  for (int i = 0; i < 11000; ++i) {
    const Motion motion = motion_of(plant);
    farthest = std::max(farthest, std::abs(motion.y - path(driver, motion.x)));
    out = std::max(out, motion.y);
    if (!step(plant, drive(driver, motion)).ok()) return expect(false, "every step goes well");
    using coach_rig::Coordinate;
    behind = std::max({behind, std::abs(plant.state.z[Coordinate::pitman_arm] - plant.inputs.steering),
                       std::abs(plant.state.zd[Coordinate::pitman_arm] - plant.inputs.steering_rate)});
  }
  const Motion end = motion_of(plant);
  coach_rig::ClosureResidual residual;
  expect(closure_residual(plant.parameters, plant.inputs, plant.state, residual).ok(), "there are residuals");
  expect(std::abs(end.time - 11) < 1e-9 && end.x > 200, "it drives 11 s");
  expect(farthest < 0.8, "it keeps to the path");
  expect(out > 3.4 && std::abs(end.y) < 0.3, "it changes the lane and comes back");
  expect(std::abs(end.forward_speed - 20) < 0.3, "it keeps the speed");
  expect(residual.largest_position < 1e-9, "the loops stay closed");
  expect(behind < 1e-12, "the pitman arm is where the servo is, with its rate");
}

void check_parameters() {
  coach_rig::Parameters parameters;
  const Values own = values_of(parameters);
  for (std::uint32_t i = 0; i < own.size(); ++i) {
    expect(set_parameter(parameters, i, 2 * own[i]), "every parameter can be set");
    expect(values_of(parameters)[i] == 2 * own[i], "and is set by its number");
  }
  expect(!set_parameter(parameters, static_cast<std::uint32_t>(own.size()), 1), "there is none beyond the last");
  expect(!set_parameter(parameters, 0, std::nan("")), "no number is refused");
  expect(!set_parameter(parameters, 0, 11 * own[0]), "what is far away is refused");
  expect(values_of(parameters)[0] == 2 * own[0], "and nothing is changed then");
}

// A failing step: the plant stays, the status says why.
void check_failure() {
  Plant plant;
  start(plant);
  plant.parameters.drag_area = std::nan("");
  const double before = plant.state.t;
  const mbgen::Status status = step(plant, {});
  expect(status.code == mbgen::Code::parameter_not_a_number, "a parameter that is none is found");
  expect(plant.state.t == before, "the plant stays as it was");
}

void check_loop(std::uint16_t port) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const Socket socket(at);
  const auto plant = std::make_unique<Plant>();
  const auto shared = std::make_unique<Shared>();
  const auto tally = std::make_unique<Tally>();
  start(*plant);
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) {
    Packet packet;
    const std::size_t size = encode({Type::command, 5, sequence, 0, 0, 0}, Command{0.05, 500}, packet);
    socket.send({packet.data(), size}, at);
    packet[20] ^= 1;
    socket.send({packet.data(), size}, at);
    socket.send({packet.data(), 7}, at);
  }
  coach_rig::Parameters parameters;
  parameters.bar_front = 12000;
  shared->parameters.publish(parameters);
  LoopSettings settings;
  settings.cycles = 300;
  settings.peer = at;  // its own motions come back to it, and are refused
  settings.session = 9;
  const long before = heap_calls();
  expect(before > 0, "calls of the heap are counted");
  run_loop(settings, socket, *plant, *shared, *tally);
  expect(heap_calls() == before, "300 cycles do not touch the heap");
  const Counts& counts = tally->link.counts;
  expect(tally->status.ok() && tally->cycles == 300, "the loop does its cycles");
  expect(std::abs(plant->state.t - 0.3) < 1e-9, "a step each");
  expect(tally->wakeup.count == 300 && tally->work.count == 300, "each is in both histograms");
  expect(counts.corrupt == 40, "garbage is counted");
  expect(counts.accepted + counts.stale == 20, "commands are taken or too old");
  expect(counts.refused == 299, "motions are no commands");
  expect(counts.received == counts.accepted + counts.stale + counts.corrupt + counts.refused, "each counts once");
  expect(plant->parameters.bar_front == 12000, "the parameter is taken over");
  expect(shared->done, "the loop says that it is done");
  Glance glance;
  expect(shared->glance.take(glance) && glance.cycles == 300, "the last cycle is seen");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  check_drive();
  check_parameters();
  check_failure();
  check_loop(static_cast<std::uint16_t>(std::atoi(argv[1])));
  return failures == 0 ? 0 : 1;
}
