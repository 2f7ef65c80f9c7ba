// mbgen kc: kinematics and compliance of an axle on its rig.

#include "workbench/kc/kc.hpp"

#include <fmt/format.h>

#include <memory>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen::cli {
namespace {

struct KcOptions {
  std::string model, axle, directory;
  StateArguments at;
  KcSettings kc;
  std::vector<std::string> set;
  bool json = false;
};

int run(const KcOptions& options) {
  const Compilation compilation = expect(decide(read_set_model(options.model, options.set)));
  count_notes(compilation);
  const Axle& axle = find_axle(compilation.model, options.axle);
  const OperatingPoint at = operating_point(compilation, options.at).point;
  BlockedSignals signals;
  Progress progress("kc");
  bool is_stopped = false;
  const KcReport report = kinematics_and_compliance(compilation, axle, at, options.kc, [&](long done, long of) {
    progress.show(done, of);
    is_stopped = done < of && signals.taken() != 0;
    return !is_stopped;
  });
  progress.clear();
  if (!options.directory.empty())
    write_files(options.directory, kc_files(report), files_read(compilation.model, options.at));
  print(options.json ? json_text(kc_json(report)) : kc_text(report));
  if (!is_stopped) return kDone;
  print_message("kc: interrupted; {}run the same command again for all curves, or fewer --points\n",
                options.directory.empty() ? "" : fmt::format("{} holds the points up to there, ", options.directory));
  throw Interrupted{signals.taken()};
}

}  // namespace

void add_kc(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<KcOptions>();
  NamedCommand command = application.add_command("kc", "run the rig curves of an axle: kinematics and compliance");
  command.footer(
      "Example: mbgen kc models/coach.json front -o kc\n"
      "The rig holds the body where it is at the start and moves the wheels on pads. Curves go from minus to plus of "
      "the\n"
      "amplitudes; tables, pictures and a page of them go to the directory of --out.");
  add_model_argument(command, options->model);
  command.add_option("AXLE", options->axle, "axle of the model (default: its only one)");
  command.add_option("-o,--out", options->directory, "directory for tables (CSV), pictures (SVG) and the page (HTML)");
  command.add_option("--travel", options->kc.travel, "m, of the wheel centres (default 0.05)");
  command.add_option("--steer", options->kc.steer, "rad or m, of the steering coordinate (default 0.3 rad or 0.03 m)");
  command.add_option("--force", options->kc.force, "N at each wheel (default: half its load, at least 1000)");
  command.add_option("--moment", options->kc.moment, "N m about z at each wheel (default: 0.05 m times the force)");
  command.add_option("--points", options->kc.points, "of a curve").with_shown_default().between(3, 1001);
  options->at.at = "initial";
  command.add_option("--at", options->at.at, "initial: the state that the model starts from (default), or equilibrium")
      .one_of({"initial", "equilibrium"});
  add_input_option(command, options->at.inputs);
  add_set_option(command, options->set);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
