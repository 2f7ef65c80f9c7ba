// mbgen evaluate: accelerations at given states; interface of all oracles.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/inverse_path.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/engines/kept_decisions.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/motion/inverse_motion.hpp"
#include "workbench/motion/reactions.hpp"
#include "workbench/start/states_file.hpp"

namespace mbgen::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EvaluateOptions {
  std::string model, form, states;
  EngineArguments engine;
  bool project = false;
  bool reactions = false;
  bool inverse = false;
  bool json = true;
  std::vector<std::string> set;
};

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// {motion: generalised driving force}.
Json drive_json(const Model& model, const std::vector<double>& drive) {
  Json result = Json::object();
  for (std::size_t m = 0; m < drive.size(); ++m) result[model.motions[m].name] = number_or_null(drive[m]);
  return result;
}

Json evaluate_state(const Engine& engine, const Compilation& compilation, const StatesFile& file,
                    const FileState& asked, const EvaluateOptions& options) {
  LoadedState at = asked.at;
  GenericDerivative derivative;
  std::vector<double> lambda, drive;
  engine.set_inputs(asked.inputs);
  std::vector<std::array<double, 6>> wrenches;
  Status status = options.project ? engine.project(at.state) : Status{};
  if (status.ok()) status = engine.accelerations(at, derivative);
  if (status.ok()) status = check_finite(derivative);
  if (status.ok()) status = engine.multipliers(at, derivative, lambda);
  if (status.ok() && options.reactions) status = engine.reactions(at, derivative, wrenches);
  if (status.ok()) status = engine.driving_forces(at, derivative, drive);

  Json result;
  result["zdd"] = status.ok() ? Json(in_file_order(file, derivative.zdd)) : Json(nullptr);
  result["lambda"] = status.ok() ? Json(lambda) : Json(nullptr);
  if (!compilation.model.motions.empty()) {
    result["drive"] = status.ok() ? drive_json(compilation.model, drive) : Json(nullptr);
  }
  result["status"] = describe(compilation, status);
  Residuals residuals;
  const bool has_residuals = engine.residuals(at.state, residuals).ok();
  result["position_residual"] = has_residuals ? number_or_null(residuals.position) : Json(nullptr);
  result["velocity_residual"] = has_residuals ? number_or_null(residuals.velocity) : Json(nullptr);
  if (options.reactions) {
    result["reactions"] = status.ok() ? reactions_json(compilation.model, wrenches) : Json(nullptr);
  }
  if (options.project && status.ok()) {
    result["z"] = in_file_order(file, at.state.z);
    result["zd"] = in_file_order(file, at.state.zd);
  }
  return result;
}

/// Largest difference of given accelerations from the ones under loops and motions.
double acceleration_residual(const std::vector<double>& given, const std::vector<double>& zdd) {
  double largest = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!std::isnan(given[i])) largest = std::max(largest, std::abs(given[i] - zdd[i]));
  return largest;
}

/// {actuator: value}.
Json by_actuators(const Model& model, const std::vector<double>& values) {
  Json result = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) result[model.actuators[i].name] = values[i];
  return result;
}

/// {actuator: how far its force is beyond its limit}, of those beyond.
Json beyond_limits_json(const Model& model, const std::vector<double>& force) {
  const std::vector<double> beyond = beyond_limits(model, force);
  Json result = Json::object();
  for (std::size_t i = 0; i < beyond.size(); ++i)
    if (beyond[i] != 0) result[model.actuators[i].name] = beyond[i];
  return result;
}

Json inverse_of_state(const Engine& engine, const Compilation& compilation, const StatesFile& file,
                      const FileState& asked, const EvaluateOptions& options) {
  LoadedState at = asked.at;
  engine.set_inputs(asked.inputs);
  InverseMotion motion;
  if (options.project) {
    GenericSolver poses(compilation.model, compilation.topology, compilation.analysis);
    poses.set_inputs(asked.inputs);
    motion.status = close_around(poses, compilation, asked.given_zdd, at.state);
  }
  if (motion.ok()) motion = actuator_forces(engine, compilation, asked.inputs, at, asked.given_zdd);
  const bool is_good = motion.ok();
  Json result;
  result["actuators"] = is_good ? by_actuators(compilation.model, motion.force) : Json(nullptr);
  if (std::ranges::any_of(compilation.model.actuators, [](const auto& one) { return one.limit.has_value(); }))
    result["beyond_limit"] = is_good ? beyond_limits_json(compilation.model, motion.force) : Json(nullptr);
  result["zdd"] = is_good ? Json(in_file_order(file, motion.derivative.zdd)) : Json(nullptr);
  result["status"] = describe(compilation, motion);
  if (const std::string hint = hint_of(motion); !hint.empty()) result["hint"] = hint;
  Residuals residuals;
  const bool has_residuals = engine.residuals(at.state, residuals).ok();
  result["position_residual"] = has_residuals ? number_or_null(residuals.position) : Json(nullptr);
  result["velocity_residual"] = has_residuals ? number_or_null(residuals.velocity) : Json(nullptr);
  result["acceleration_residual"] =
      is_good ? Json(acceleration_residual(asked.given_zdd, motion.derivative.zdd)) : Json(nullptr);
  if (options.project && is_good) {
    result["z"] = in_file_order(file, at.state.z);
    result["zd"] = in_file_order(file, at.state.zd);
  }
  return result;
}

/// Names the states whose given accelerations leave others open, on standard error. Result: the exit code.
int told_open(const std::string& file, const Json& states) {
  int exit_code = kDone;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!states[i].contains("hint")) continue;
    print_message("{}: /states/{}: {}\n  hint: {}\n", file, i, states[i]["status"].get<std::string>(),
                  states[i]["hint"].get<std::string>());
    exit_code = kUserFault;
  }
  return exit_code;
}

int run(const EvaluateOptions& options) {
  if (options.inverse && options.reactions)
    throw UserError("evaluate: --inverse prints no reactions: leave out --inverse or --reactions\n");
  Model model = read_set_model(options.model, options.set);
  if (options.reactions) add_reaction_outputs(model);
  EngineChoice choice = chosen_engine(options.engine);
  choice.form = chosen_form(options.form);
  const Compilation compilation = expect(decide_for(std::move(model), choice));
  if (options.inverse) require_inverse_dynamics(compilation, "evaluate");
  const std::vector<double> inputs = input_values(compilation.model, options.engine.inputs);
  const StatesFile file = read_states(options.states, compilation, inputs);
  Engine engine = make_engine(compilation, choice);
  if (options.reactions) use_reaction_outputs(engine, compilation.model);
  Json result;
  result["joint_order"] = file.joint_order;
  result["states"] = Json::array();
  const auto evaluate = options.inverse ? inverse_of_state : evaluate_state;
  for (const FileState& state : file.states)
    result["states"].push_back(evaluate(engine, compilation, file, state, options));
  print(result.dump() + "\n");
  return options.inverse ? told_open(options.states, result["states"]) : kDone;
}

}  // namespace

void add_evaluate(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<EvaluateOptions>();
  NamedCommand command = application.add_command("evaluate", "print the accelerations at given states, as JSON");
  command.footer(
      "Example: mbgen evaluate models/pendulum.json --states states.json\n"
      "where states.json is {\"joint_order\": [names], \"states\": [{\"z\": [], \"zd\": [], \"tau\": []}]}; a state "
      "may\n"
      "also have \"x\", \"t\" and \"inputs\": {name: value}. tau are joint forces beside the forces of the model.\n"
      "Of a model with motions, \"drive\" are the generalised driving forces.\n"
      "A state that has no accelerations has \"zdd\": null and a status that says why; the exit code is then 0 too.");
  add_model_argument(command, options->model);
  command.add_option("--states", options->states, "file of states (JSON)").required();
  command.add_flag("--project", options->project,
                   "make each state consistent first, and print its z and zd (default: take it as given)");
  command.add_flag("--reactions", options->reactions,
                   "print the reaction of every joint and rod on its \"to\" body: force, and moment about the joint's "
                   "point on that body, global axes");
  command.add_flag(
      "--inverse", options->inverse,
      "print the forces of the actuators that give the independent coordinates the accelerations \"zdd\" of "
      "each state, an array or {name: number}; the inputs of the actuators do not act");
  add_set_option(command, options->set);
  add_batch_option(command, options->engine.choice.lanes);
  add_json_option(command, options->json);
  add_form_option(command, options->form);
  add_engine_options(command, options->engine);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
