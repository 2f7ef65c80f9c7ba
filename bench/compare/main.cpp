// mbgen_compare: generated code beside other solvers of the same mechanisms, in one process, in turns. bench/compare.sh

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/compare/table.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::compare {
namespace {

constexpr int kDone = 0, kUserFault = 1, kDisagreement = 2;

struct Options {
  std::vector<std::string> models;
  Settings settings;
  bool json = false, massless = false, no_code = false;
};

bool has_rods(const std::string& path) { return !expect(read_model_file(path)).rods.empty(); }

int run(const Options& options) {
  std::vector<Comparison> comparisons;
  bool agree = true;
  const auto compare = [&](const std::string& path, bool rods_are_massless) {
    Settings settings = options.settings;
    settings.rods_are_massless = rods_are_massless;
    comparisons.push_back(compare_on(path, settings));
    agree = agree && comparisons.back().disagreeing.empty();
    if (!options.json) print(table_text(comparisons.back()) + "\n");
  };
  if (!options.json) print(machine_text() + "\n\n");
  for (const std::string& path : options.models) {
    compare(path, false);
    if (options.massless && has_rods(path)) compare(path, true);
  }
  if (options.json) print(json_text(comparisons));
  return agree ? kDone : kDisagreement;
}

int main_of(int argc, char** argv) {
  CLI::App application("mbgen_compare times solvers of the same mechanism in turns, after their answers agree.");
  Options options;
  options.settings.states_directory = MBGEN_SOURCE_DIR "/../shared/reference";
  application.add_option("MODEL", options.models, "model files (JSON)")->required();
  application.add_option("--states", options.settings.states_directory,
                         "directory of <mechanism>_states.json, used where they are; else random states");
  application.add_option("--rounds", options.settings.rounds, "turns of each contestant (default: 100)");
  application.add_option("--seconds", options.settings.seconds, "of each contestant in one turn (default: 0.003)");
  application.add_flag("--massless-rods", options.massless, "also compare with the mass of all rods taken away");
  application.add_flag("--no-code", options.no_code, "do not measure code size, compile time and instructions");
  application.add_flag("--json", options.json, "print the result for machines");
  application.footer(
      "Columns: microseconds of processor time for one evaluation, over the turns; how many times longer than the "
      "first row in the same\n"
      "turn; largest difference of an acceleration from the reference, relative to the largest acceleration of the "
      "state.\n"
      "Exit codes: 0 done, 1 the input is at fault, 2 solvers do not agree (1e-9) and nobody was timed.");
  try {
    application.parse(argc, argv);
    options.settings.counts_code = !options.no_code;
    return run(options);
  } catch (const CLI::ParseError& error) {
    return application.exit(error) == 0 ? kDone : kUserFault;
  } catch (const UserError& error) {
    fmt::print(stderr, "{}", error.what());
    return kUserFault;
  }
}

}  // namespace
}  // namespace mbgen::compare

int main(int argc, char** argv) { return mbgen::compare::main_of(argc, argv); }
