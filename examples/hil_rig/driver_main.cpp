// The driver: drives a double lane change at 20 m/s, or along the straight, and may record what it did.

#include <cstdio>
#include <memory>

#include "client.hpp"
#include "driver_model.hpp"
#include "options.hpp"

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

int run(int argc, char** argv) {
  using namespace hil_rig;
  const Options options = read_options(argc, argv,
                                       {{"listen", "127.0.0.1:7002"},
                                        {"plant", "127.0.0.1:7001"},
                                        {"lane-change", "3.5"},
                                        {"speed", "20"},
                                        {"patience", "2"},
                                        {"record", ""}});
  Driver driver;
  driver.lane_change = number_of(options, "lane-change", -10.0, 10.0);
  driver.speed = number_of(options, "speed", 5.0, 30.0);
  File record(nullptr, std::fclose);
  if (const std::string& name = options.at("record"); !name.empty()) {
    record.reset(std::fopen(name.c_str(), "w"));
    if (!record) throw std::runtime_error("cannot write " + name);
    std::fputs("t [s],steering [rad],drive_torque [N m]\n", record.get());
  }
  const ClientSettings settings = client_settings(options);
  double worst = 0, recorded = -1;
  const ClientResult result = run_client(settings, [&](const Motion& motion) {
    const Command command = drive(driver, motion);
    worst = std::max(worst, std::abs(motion.y - path(driver, motion.x)));
    if (record && motion.time >= recorded + 0.05) {
      recorded = motion.time;
      std::fprintf(record.get(), "%.3f,%.5f,%.1f\n", motion.time, command.steering, command.drive_torque);
    }
    return command;
  });
  std::printf("driver: %ld motions, %ld dropped, largest distance from the path %.2f m, %s\n", result.motions,
              result.dropped, worst, result.ended ? "the plant ended" : "the plant fell silent");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hil_rig::guarded("hil_driver", [&] { return run(argc, argv); });
}
