// The recorded client: answers each motion with the command that the recording has for its time, whatever the coach
// does.

#include <cstdio>

#include "client.hpp"
#include "options.hpp"
#include "recording.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace hil_rig;
  const Options options = read_options(
      argc, argv,
      {{"listen", "127.0.0.1:7002"}, {"plant", "127.0.0.1:7001"}, {"patience", "2"}, {"recording", "recording.csv"}});
  const std::vector<RecordedCommand> rows = read_recording(options.at("recording"));
  const ClientSettings settings = client_settings(options);
  const ClientResult result =
      run_client(settings, [&](const Motion& motion) { return recorded_command(rows, motion.time); });
  std::printf("replay: %ld motions, %ld dropped, at the end %.2f m along and %.3f m left, %s\n", result.motions,
              result.dropped, result.last.x, result.last.y, result.ended ? "the plant ended" : "the plant fell silent");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hil_rig::guarded("hil_replay", [&] { return run(argc, argv); });
}
