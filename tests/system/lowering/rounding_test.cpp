// What each rewriting of a program makes of its roundings: the accelerations of a program in double precision against
// the same program, as it was traced, in long double.

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen::testing {
namespace {

using Precise = long double;

Precise applied(Op op, Precise a, Precise b, Precise c) {
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::negate:
      return -a;
    case Op::sin:
      return std::sin(a);
    case Op::cos:
      return std::cos(a);
    case Op::abs:
      return std::abs(a);
    case Op::min:
      return std::min(a, b);
    case Op::max:
      return std::max(a, b);
    case Op::select:
      return a >= 0 ? b : c;
    default:
      throw std::runtime_error("an operation that mechanisms do not have");
  }
}

std::vector<Precise> precisely(const Program& program, const std::vector<double>& inputs) {
  std::vector<Precise> values(program.nodes.size()), outputs;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& node = program.nodes[i];
    Precise operands[3] = {0, 0, 0};
    for (int k = 0; k < arity(node.op); ++k) operands[k] = values[node.operands[k]];
    if (node.op == Op::constant)
      values[i] = node.constant;
    else if (node.op == Op::input)
      values[i] = inputs[static_cast<std::size_t>(node.input)];
    else
      values[i] = applied(node.op, operands[0], operands[1], operands[2]);
  }
  for (const OutputValue& output : program.outputs) outputs.push_back(values[output.value]);
  return outputs;
}

std::vector<double> inputs_of(const Program& program, const ReferenceState& at) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) {
    const auto place = static_cast<std::size_t>(slot.index);
    inputs.push_back(slot.group == SlotGroup(Array::z)     ? at.state.z[place]
                     : slot.group == SlotGroup(Array::zd)  ? at.state.zd[place]
                     : slot.group == SlotGroup(Array::tau) ? at.tau[place]
                                                           : 0.0);
  }
  return inputs;
}

/// Largest error of the accelerations over the largest of them, at each state.
std::vector<double> errors_of(const Program& program, const std::vector<ReferenceState>& states,
                              const std::vector<std::vector<Precise>>& truth) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const std::vector<double> values = interpret(program, inputs_of(program, states[k]));
    Precise largest = 0, error = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (program.outputs[i].slot.group != SlotGroup(Array::zdd)) continue;
      largest = std::max(largest, std::abs(truth[k][i]));
      error = std::max(error, std::abs(values[i] - truth[k][i]));
    }
    errors.push_back(static_cast<double>(error / largest));
  }
  return errors;
}

/// The reference states, and some around them, further out, where closures become badly conditioned.
std::vector<ReferenceState> states_of(const Topology& topology, const std::string& name) {
  std::vector<ReferenceState> states = reference_states(topology, "tests/data/reference/" + name + "_states.json");
  std::mt19937_64 random(38);
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::vector<ReferenceState> known = states;
  for (const double reach : {0.2, 0.5, 0.8})
    for (ReferenceState state : known) {
      for (double& z : state.state.z) z += reach * unit(random);
      states.push_back(std::move(state));
    }
  return states;
}

/// Times its error before: the most that a stage may make of it at any state, docs/method/identities.md.
double most_of(std::string_view stage) {
  static const std::map<std::string_view, double> kOthers = {{"sums", 20}};
  const auto found = kOthers.find(stage);
  return found == kOthers.end() ? 2 : found->second;
}

class Roundings : public ::testing::TestWithParam<const char*> {};

TEST_P(Roundings, OfEachRewritingStayWithinItsFactor) {
  if constexpr (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is double here";
  const std::string name = GetParam();
  Result<Model> model = read_model_file(source_path("models/" + name + "_mechanism.json"));
  ASSERT_TRUE(model);
  std::vector<ReferenceState> states;
  std::vector<std::vector<Precise>> truth;
  std::vector<double> before;
  CompileOptions options;
  options.watch = [&](const Stage& stage) {
    const Program& program = stage.programs.accelerations;
    if (program.outputs.empty()) return true;
    if (truth.empty()) {
      states = states_of(stage.so_far.topology, name);
      for (const ReferenceState& state : states) truth.push_back(precisely(program, inputs_of(program, state)));
    }
    const std::vector<double> errors = errors_of(program, states, truth);
    double most = 0;
    for (std::size_t k = 0; k < before.size(); ++k)
      most = std::max(most, errors[k] / std::max(before[k], 8 * DBL_EPSILON));
    std::printf("%s %-14s worst %.1e, factor %.2f\n", name.c_str(), std::string(stage.name).c_str(),
                *std::ranges::max_element(errors), most);
    EXPECT_LE(most, most_of(stage.name)) << stage.name;
    before = errors;
    return stage.name != "shorter-sums";
  };
  ASSERT_TRUE(compile(*model, options));
  ASSERT_FALSE(truth.empty());
}

INSTANTIATE_TEST_SUITE_P(Vehicles, Roundings, ::testing::Values("coach", "truck"));

}  // namespace
}  // namespace mbgen::testing
