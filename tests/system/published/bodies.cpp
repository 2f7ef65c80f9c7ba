// Single bodies and open chains.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/generic/generic.hpp"
#include "tests/system/published/published.hpp"
#include "tests/system/published/run.hpp"

namespace mbgen::published {

using Json = nlohmann::json;

std::vector<Figure> babyboot() {
  const Json data = reference("babyboot.json");
  const Run start("models/published/babyboot.json", 1e-3);
  std::vector<Figure> figures;
  for (const double h : {1e-3, 1e-4}) {
    Run run = start;
    run.set_step(h);
    run.go_to(10);
    const auto error = [&](const Json& expected) {
      return std::max(std::abs(run.output("qA") - number(expected["qA_deg"])),
                      std::abs(run.output("qB") - number(expected["qB_deg"])));
    };
    const std::string step = h == 1e-3 ? "1e-3 s" : "1e-4 s";
    figures.push_back({"angles at 10 s, MotionGenesis", error(data["motiongenesis"]), h == 1e-3 ? 1e-3 : 4e-6, "deg",
                       step, "14 digits, good to 1.5e-6 deg"});
    figures.push_back({"angles at 10 s, 30 digits", error(data["own"]), h == 1e-3 ? 1e-3 : 2e-6, "deg", step,
                       "1e-22; start errors grow 7e6 times"});
  }
  return figures;
}

std::vector<Figure> free_body() {
  const Json data = reference("rigid_body.json");
  Run run("models/published/free_body.json", 1e-3);
  double error = 0;
  for (const Json& row : data["free_body"]) {
    run.go_to(number(row["t"]));
    const Json& q = row["quat_wxyz"];
    const double w = number(q[0]), x = number(q[1]), y = number(q[2]), z = number(q[3]);
    // Columns of the rotation, by output names: axis of the body, component.
    const std::pair<const char*, double> expected[] = {
        {"xx", 1 - 2 * (y * y + z * z)}, {"xy", 2 * (x * y + w * z)},     {"xz", 2 * (x * z - w * y)},
        {"yx", 2 * (x * y - w * z)},     {"yy", 1 - 2 * (x * x + z * z)}, {"yz", 2 * (y * z + w * x)},
        {"zx", 2 * (x * z + w * y)},     {"zy", 2 * (y * z - w * x)},     {"zz", 1 - 2 * (x * x + y * y)}};
    for (const auto& [name, value] : expected) error = std::max(error, std::abs(run.output(name) - value));
  }
  return {{"direction cosines over 10 s", error, 1e-7, "", "1e-3 s", "closed form, 5e-19"}};
}

std::vector<Figure> heavy_top() {
  const Json data = reference("rigid_body.json");
  Run run("models/published/heavy_top.json", 1e-4);
  double error = 0;
  for (const Json& row : data["heavy_top"]) {
    run.go_to(number(row["t"]));
    const char* const axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) error = std::max(error, std::abs(run.output(axes[k]) - number(row["r_com"][k])));
  }
  return {{"centre of mass over 2 s", error, 1e-8, "m", "1e-4 s", "quadruple precision, 1e-15"}};
}

namespace {

/// The arm of the model, its joints driven or left to torques.
GenericSolver arm(const Compilation& compilation, const Json& at) {
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_parameters({number(at["g"])});
  std::vector<double> inputs;
  for (const Input& input : compilation.model.inputs) {
    const char* const key = input.name[0] == 'q' ? "q" : input.name[0] == 'v' ? "qd" : "qdd";
    inputs.push_back(number(at[key][static_cast<std::size_t>(input.name[1] - '1')]));
  }
  solver.set_inputs(inputs);
  return solver;
}

}  // namespace

std::vector<Figure> kuka() {
  const Compilation driven = compiled("models/published/kuka_iiwa.json");
  Model model = driven.model;
  model.motions.clear();
  const Compilation free = compiled(std::move(model));
  const Json data = reference("kuka_iiwa.json");
  double torque = 0, acceleration = 0, place = 0;
  for (const Json& at : data["cases"]) {
    const GenericState state{at["q"].get<std::vector<double>>(), at["qd"].get<std::vector<double>>(), {}, 0};
    const std::vector<double> tau = at["tau"], no_tau(7);
    const GenericSolver inverse = arm(driven, at), forward = arm(free, at);
    GenericDerivative derivative;
    if (!inverse.accelerations(state, no_tau, derivative).ok()) throw std::runtime_error("no accelerations");
    const std::vector<double> drive = inverse.driving_forces(state, no_tau, derivative);
    const std::vector<double> y = inverse.outputs(state, no_tau, derivative).y;
    for (std::size_t i = 0; i < 7; ++i) torque = std::max(torque, std::abs(drive[i] - tau[i]));
    const char* const keys[] = {"p_NoGo_N", "v_NGo_N", "a_NGo_N"};
    for (std::size_t i = 0; i < 9; ++i) place = std::max(place, std::abs(y[i] - number(at[keys[i / 3]][i % 3])));
    if (!forward.accelerations(state, tau, derivative).ok()) throw std::runtime_error("no accelerations");
    for (std::size_t i = 0; i < 7; ++i)
      acceleration = std::max(acceleration, std::abs(derivative.zdd[i] - number(at["qdd"][i])));
  }
  return {{"inverse dynamics, 26 states", torque, 1e-12, "N m", "-", "1e-12"},
          {"place, velocity, acceleration of the last link", place, 1e-12, "m, s", "-", "1e-12"},
          {"forward dynamics, the same states", acceleration, 1e-9, "rad/s^2", "-",
           "torques good to 4e-14 N m, which inertias of 1e-3 kg m^2 multiply"}};
}

}  // namespace mbgen::published
