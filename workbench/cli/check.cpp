// mbgen check: every problem of a model, or "ok".

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/beams.hpp"
#include "workbench/describe/dump.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {
namespace {

struct CheckOptions {
  std::string model, dump;
  std::vector<std::string> set;
  bool json = false;
};

struct Findings {
  Diagnostics problems, notes;
  int bodies = 0, freedoms = 0, driven = 0;  ///< moving; including driven ones; prescribed by motions
  std::string beams = {};                    ///< their frequencies as text
  nlohmann::ordered_json beams_json = nlohmann::ordered_json::array();
};

/// Faults of the model or of its initial state, or notes on them.
Findings findings_of(const CheckOptions& options) {
  Findings findings;
  try {
    Model read = read_set_model(options.model, options.set);
    findings.notes = grouped(read.notes);  // a likely mistake of units may be the cause of the refusal
    const Compilation compilation = expect(decide(std::move(read)));
    const Model& model = compilation.model;
    findings.notes = all_notes(compilation);
    findings.bodies = static_cast<int>(model.bodies.size()) - (model.ground >= 0 ? 1 : 0);
    findings.freedoms = compilation.analysis.degrees_of_freedom;
    findings.driven = static_cast<int>(model.motions.size());
    const std::vector<BeamFrequencies> beams = beam_frequencies(model);
    findings.beams = beams_text(beams);
    findings.beams_json = beams_json(beams);
    const Initial& initial = model.initial;
    if (!initial.equilibrium && initial.positions.empty() && initial.velocities.empty()) return findings;
    const Start start = initial_start(compilation, input_values(model, {}));
    for (Diagnostic& note : start_notes(compilation, start)) findings.notes.push_back(std::move(note));
  } catch (const UserError& error) {
    if (error.problems().empty()) throw;
    findings.problems = error.problems();
  }
  return findings;
}

int run(const CheckOptions& options) {
  if (!options.dump.empty()) {
    print(dump_stage(read_set_model(options.model, options.set), options.dump, known_start));
    return kDone;
  }
  const auto [problems, notes, bodies, freedoms, driven, beams, beams_as_json] = findings_of(options);
  if (options.json) {
    nlohmann::ordered_json report = {{"model", options.model}, {"ok", problems.empty()}};
    if (problems.empty()) report.update({{"bodies", bodies}, {"freedoms", freedoms}, {"driven", driven}});
    if (!beams_as_json.empty()) report["beams"] = beams_as_json;
    report["problems"] = diagnostics_json(problems);
    report["notes"] = diagnostics_json(notes);
    print(json_text(report));
  } else if (print_notes(notes); problems.empty()) {
    print(fmt::format("{}: ok\n  bodies {}, freedoms {}, of them driven {}, notes {}\n{}", options.model, bodies,
                      freedoms, driven, notes.size(), beams));
  } else {
    throw UserError(problems);
  }
  return problems.empty() ? kDone : kUserFault;
}

}  // namespace

void add_check(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  NamedCommand command = application.add_command("check", "read and verify a model, report every problem at once");
  command.footer(
      "Example: mbgen check models/coach.json\n"
      "Standard error has notes on allowed input that may be a mistake: axes of tyres and wheels out of balance, "
      "wheels\n"
      "that stand while their tyres run, damping that adds energy, likely mistakes of units, bodies that nothing\n"
      "holds, joints that loops lock, entries of tyre files that the model does not use, and the distances by which\n"
      "initial values that do not fit together are moved.");
  add_model_argument(command, options->model);
  add_set_option(command, options->set);
  add_json_option(command, options->json);
  add_dump_option(command, options->dump);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
