// The plant: the coach in a thread with a period of a millisecond; view, parameters and signals in another.

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>

#include "client.hpp"
#include "loop.hpp"
#include "options.hpp"
#include "realtime.hpp"
#include "view.hpp"

namespace {

using namespace hil_rig;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

const Options kDefaults = {{"duration", "0"},              // s of the model; 0: until SIGINT or SIGTERM
                           {"listen", "127.0.0.1:7001"},   // commands
                           {"driver", "127.0.0.1:7002"},   // who gets the motion
                           {"control", "127.0.0.1:7003"},  // settings of parameters
                           {"priority", "80"},             // of SCHED_FIFO; 0: as it is
                           {"cpu", "-1"},                  // to stay on; -1: any
                           {"histogram", ""}};             // file for the histograms

// SIGINT and SIGTERM as a file to wait for; no other thread sees them either.
int open_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
}

// Takes the settings that wait, answers them, and hands all parameters over to the loop when one changed.
void serve_settings(const Socket& control, coach_rig::Parameters& parameters, Shared& shared) {
  std::array<std::uint8_t, kLargestPacket + 64> bytes;
  sockaddr_in from{};
  for (long size = control.receive(bytes, &from); size >= 0; size = control.receive(bytes, &from)) {
    const std::optional<Header> header = open(bytes.data(), static_cast<std::size_t>(size));
    if (!header || header->type != Type::setting) continue;
    const bool taken = set_parameter(parameters, header->subject, payload_of<Setting>(bytes.data()).value);
    if (taken) shared.parameters.publish(parameters);
    Header answer = *header;
    answer.type = Type::answer;
    answer.flags = taken ? kTaken : 0;
    Setting now;
    if (header->subject < coach_rig::kParameters) now.value = values_of(parameters)[header->subject];
    Packet packet;
    control.send({packet.data(), encode(answer, now, packet)}, from);
  }
}

void take_events(Shared& shared, View& view) {
  for (Event event; shared.events.pop(event);) view.say(words_of(event));
}

// Work of the thread beside the loop until the loop is done.
void watch(const Socket& control, int signals, coach_rig::Parameters parameters, Shared& shared) {
  View view(stdout, isatty(STDOUT_FILENO) == 1);
  Glance glance;
  while (!shared.done.load(std::memory_order_acquire)) {
    pollfd waiting[] = {{signals, POLLIN, 0}, {control.descriptor(), POLLIN, 0}};
    poll(waiting, 2, 100);
    signalfd_siginfo taken{};
    if ((waiting[0].revents & POLLIN) != 0 && read(signals, &taken, sizeof taken) > 0) {
      shared.stop.store(true);
      view.say("stopped by signal " + std::to_string(taken.ssi_signo));
    }
    serve_settings(control, parameters, shared);
    take_events(shared, view);
    if (shared.glance.take(glance)) view.show(glance);
  }
  take_events(shared, view);
}

void write_histogram(const std::string& name, const Tally& tally) {
  File file(std::fopen(name.c_str(), "w"), std::fclose);
  if (!file) throw std::runtime_error("cannot write " + name);
  print(file.get(), std::array{&tally.wakeup, &tally.work});
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv, kDefaults);
  const Realtime realtime = {number_of(options, "priority", 0, 98), number_of(options, "cpu", -1, 1023)};
  LoopSettings settings;
  settings.cycles = std::lround(number_of(options, "duration", 0.0, 1e6) / kStep);
  settings.peer = address_of(options.at("driver"));
  settings.session = new_session();
  const Socket commands(address_of(options.at("listen"))), control(address_of(options.at("control")));
  const int signals = open_signals();
  const auto plant = std::make_unique<Plant>();
  const auto shared = std::make_unique<Shared>();
  const auto tally = std::make_unique<Tally>();
  if (const mbgen::Status status = start(*plant); !status.ok()) {
    throw std::runtime_error(std::string("the coach does not assemble: ") + mbgen::text(status.code));
  }
  std::printf("%s, model hash %s, a step each %g ms\n", coach_rig::kModel, coach_rig::kHash, 1e3 * kStep);
  const int awake = keep_awake(stderr);
  std::thread loop([&] {
    enter_realtime(realtime, stderr);
    run_loop(settings, commands, *plant, *shared, *tally);
  });
  watch(control, signals, {}, *shared);
  loop.join();
  if (awake >= 0) close(awake);
  close(signals);
  print_result(stdout, *tally, *plant);
  if (const std::string& name = options.at("histogram"); !name.empty()) write_histogram(name, *tally);
  return tally->status.ok() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  return hil_rig::guarded("hil_plant", [&] { return run(argc, argv); });
}
