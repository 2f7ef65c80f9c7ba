#include "compiler/emit/cost_sheet.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compiler/emit/mapped.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/solver/fine_blocks.hpp"
#include "mbgen/worst_case.hpp"

namespace mbgen {
namespace {

using CostJson = nlohmann::ordered_json;

constexpr int kTitleWidth = 70, kKindCell = 8;
constexpr int kBoundWidth = 30, kBoundCell = 15;
constexpr const char* kKinds[] = {"add", "multiply", "divide", "sqrt", "trigonometric", "other", "total"};
constexpr const char* kKindTitles[] = {"+ -", "*", "/", "sqrt", "trig", "other", "+ - * /"};
constexpr const char* kCalls[] = {"accelerations", "closures", "factorisations", "operations"};

/// How hard the calls of a function are.
enum class Hardness {
  regular,  ///< frozen partitions serve
  pivoted,  ///< they do not, in a single call
  step      ///< a step that takes every fallback, as often as it may
};

/// Operations of a program, 0 if there is none.
long operations_of(const CostJson& programs, const char* program) {
  return programs.contains(program) ? programs[program]["operations"]["total"].get<long>() : 0L;
}

/// Calls and operations under one function.
CostJson call_json(const EmitContext& context, const CostJson& programs, const char* function, const char* title,
                   CallCount calls, Hardness hardness) {
  const auto operations = [&](const char* program) { return operations_of(programs, program); };
  const bool chooses = hardness != Hardness::regular && context.layout.chooses_again && !context.layout.blocks.empty();
  const bool shares = chooses && hardness == Hardness::step;
  const int projections = context.layout.has_closure ? calls.projections : 0;
  const long closures = shares ? kStepClosures : static_cast<long>(projections) * kMostClosures;
  const long terms = chooses ? operations("closure_terms") : 0;
  const long of_acceleration =
      operations("accelerations") + terms + (chooses ? operations("accelerations_chosen") : 0L);
  const long of_implicit = calls.matrices == 0 ? 0 : operations("tangents") + kImplicitStages * operations("changes");
  const bool is_step = std::string_view(function).starts_with("step_");
  // Once, if an instant begins the step.
  const bool takes = is_step && takes_reactions(context.model);
  const long of_samples = is_step ? operations("sampled") + (takes ? operations("multipliers") : 0) : 0;
  const int accelerations = calls.accelerations + (takes ? 1 : 0);
  return {{"function", function},
          {"case", title},
          {"accelerations", accelerations},
          {"projections", projections},
          {"closures", closures},
          {"factorisations", chooses ? accelerations + closures + (shares ? kSideFactorisations : 0) : 0L},
          {"operations", accelerations * of_acceleration + closures * (operations("closure") + terms) +
                             (shares ? kSideTerms * terms : 0) + calls.matrices * of_implicit + of_samples}};
}

/// Most calls in a step. most: of a System without passages; evaluations: of the accelerations of one with them.
CallCount worst_step(const EmitContext& context, CallCount most, CallCount regular, int evaluations) {
  if (context.layout.blocks.empty()) return regular + CallCount{evaluations / 2, 1 + evaluations / 2};
  if (!context.layout.chooses_again) return most;
  return {evaluations, regular.projections * 2 + evaluations / 2, most.matrices};
}

/// Inverse dynamics, and the maps between motors and joints: closures and factorisations at pivots chosen at run time.
void add_actuator_calls(const EmitContext& context, const CostJson& programs, CostJson& calls) {
  const auto add = [&](const char* function, const char* title, long closures, long factorisations, long operations) {
    const bool has_loops = !context.layout.blocks.empty();
    calls.push_back({{"function", function},
                     {"case", title},
                     {"accelerations", 0},
                     {"projections", 0},
                     {"closures", has_loops ? closures : 0},
                     {"factorisations", has_loops ? factorisations : 0},
                     {"operations", operations}});
  };
  const auto operations = [&](const char* program) { return operations_of(programs, program); };
  if (context.layout.actuators == 0) return;
  const long regular = operations("inverse_dynamics");
  const long look = operations("closure_terms") + operations("actuators");
  add("inverse_dynamics", "regular", 0, 0, regular);
  if (context.layout.pivots_actuators)
    add("inverse_dynamics", "worst", 2, 2,
        regular + look + operations("closure_terms") + operations("required_forces"));
  if (!context.layout.maps_actuators) return;
  const long driven = context.layout.drives > 0 ? operations("closure") : 0;
  add("complete_joints", "worst", kMostClosures, kMostClosures,
      kMostClosures * (look + driven) + operations("actuators"));
  add("actuator_positions", "regular", 0, 0, operations("actuators"));
  for (const char* function :
       {"complete_accelerations", "actuator_jacobian", "forces_at_actuators", "forces_at_independent"})
    add(function, "regular", 1, 1, look);
}

CostJson calls_json(const EmitContext& context, const CostJson& programs) {
  constexpr CallCount kEvaluation = {1, 0}, kProjection = {0, 1};
  CostJson calls = CostJson::array();
  const auto add = [&](const char* function, const char* title, CallCount count, Hardness hardness) {
    calls.push_back(call_json(context, programs, function, title, count, hardness));
  };
  const auto add_call = [&](const char* function, CallCount count) {
    add(function, "regular", count, Hardness::regular);
    if (context.layout.has_closure) add(function, "worst", count, Hardness::pivoted);
  };
  const auto add_step = [&](const char* function, const StepCalls& step, int evaluations) {
    add(function, "regular", step.regular, Hardness::regular);
    if (context.layout.has_closure)
      add(function, "worst", worst_step(context, step.worst, step.starting, evaluations), Hardness::step);
  };
  add_call("accelerations", kEvaluation);
  if (context.layout.has_closure) add_call("assemble", kProjection);
  add_step("step_rk4", kRk4Calls, kRk4Evaluations);
  add("step_abm4", "starting", kAbm4Calls.starting, Hardness::regular);
  add_step("step_abm4", kAbm4Calls, kAbm4Evaluations);
  add_actuator_calls(context, programs, calls);
  if (context.model.solver.is_implicit()) add_step("step_rosenbrock", kRosenbrockCalls, kRosenbrockEvaluations);
  return calls;
}

/// A line of a table: a title and cells of equal width.
template <class Cells>
std::string row(const std::string& title, int title_width, const Cells& cells, int cell_width) {
  std::string text = fmt::format("  {:<{}}", title, title_width);
  for (const auto& cell : cells) text += fmt::format("{:>{}}", cell, cell_width);
  return text + "\n";
}

/// The numbers of these keys.
template <std::size_t count>
std::vector<long> numbers_at(const CostJson& json, const char* const (&keys)[count]) {
  return mapped(keys, [&](const char* key) { return json[key].get<long>(); });
}

std::string bounds_text(const CostJson& worst) {
  std::string text = "\n" + row("At most, in one call", kBoundWidth, kCalls, kBoundCell);
  for (const CostJson& call : worst["calls"])
    text += row(fmt::format("{}, {}", call["function"].get<std::string>(), call["case"].get<std::string>()),
                kBoundWidth, numbers_at(call, kCalls), kBoundCell);
  if (!worst.contains("newton_iterations")) return text;
  text += fmt::format(
      "\n"
      "  A step projects: Newton, at most {} times, with one evaluation of the closures before each iteration and one\n"
      "  after the last. Worst is a step that is taken twice, plainly and with care. Singular positions: at most {}\n"
      "  spacings are tried, with {} states around them. {}\n",
      worst["newton_iterations"].get<int>(), worst["spacings"].get<int>(), worst["nodes"].get<int>(),
      worst.contains("step_closures")
          ? fmt::format("All of it shares {} evaluations of the closures.", worst["step_closures"].get<int>())
          : "Each stage may meet one.");
  if (!worst["factorisation"].empty()) text += "  A factorisation is one of every loop block:\n";
  for (const CostJson& loop : worst["factorisation"]) {
    text += fmt::format("    {}: {} equations in {} coordinates, {} pivots{}\n", loop["loop_block"].get<std::string>(),
                        loop["equations"].get<int>(), loop["coordinates"].get<int>(), loop["pivots"].get<int>(),
                        loop.contains("fine_blocks")
                            ? fmt::format(", clear of singular positions in {} fine blocks of at most {}",
                                          loop["fine_blocks"].get<int>(), loop["largest_fine_block"].get<int>())
                            : "");
  }
  return text;
}

}  // namespace

CostJson worst_case_json(const EmitContext& context, const CostJson& programs) {
  CostJson worst = CostJson::object();
  if (context.layout.has_closure) {
    worst["newton_iterations"] = kNewtonIterations;
    const bool shares = context.layout.chooses_again && !context.layout.blocks.empty();
    worst["spacings"] = shares ? kPassageTries : kSpacings;
    worst["nodes"] = shares ? kPassageNodes : 2 * kNodes;
    if (shares) worst["step_closures"] = kStepClosures;
    worst["factorisation"] = CostJson::array();
    for (std::size_t b = 0; context.layout.chooses_again && b < context.layout.blocks.size(); ++b) {
      const BlockPlaces& block = context.layout.blocks[b];
      worst["factorisation"].push_back({{"loop_block", context.names.loop_blocks[b]},
                                        {"equations", block.equations},
                                        {"coordinates", block.coordinates},
                                        {"pivots", block.rank}});
      const FineBlocks fine = fine_blocks(context.analysis.blocks[b], b, block, context.programs.closure_terms);
      if (fine.parts.empty()) continue;
      worst["factorisation"].back()["fine_blocks"] = fine.parts.size();
      worst["factorisation"].back()["largest_fine_block"] = fine.largest();
    }
  }
  worst["calls"] = calls_json(context, programs);
  return worst;
}

CostJson operations_json(const OperationCount& count) {
  return {{"add", count.add},      {"multiply", count.multiply},           {"divide", count.divide},
          {"sqrt", count.sqrt},    {"trigonometric", count.trigonometric}, {"other", count.other},
          {"total", count.total()}};
}

std::string operations_table(const std::string& title, const CostJson& sections, const CostJson& total,
                             const char* section_key) {
  const auto counts = [](const std::string& name, const CostJson& json) {
    return row(name, kTitleWidth, numbers_at(json, kKinds), kKindCell);
  };
  std::string text = "\n" + row(title, kTitleWidth, kKindTitles, kKindCell);
  for (const CostJson& section : sections) text += counts(section[section_key].get<std::string>(), section);
  return text + counts("total", total);
}

std::string cost_text(const CostJson& manifest, const std::string& banner) {
  std::string text = banner + "\n";
  for (const auto& [name, program] : manifest["programs"].items())
    text += operations_table("Operations of " + name, program["sections"], program["operations"], "title");
  return text + bounds_text(manifest["worst_case"]) +
         "\n"
         "  Operations are those of the programs above; sums over coordinates and the elimination itself come on top.\n"
         "  Bytes, stack and microseconds on a machine: mbgen generate --measure.\n";
}

}  // namespace mbgen
