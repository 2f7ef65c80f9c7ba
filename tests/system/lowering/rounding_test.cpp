// The factor by which each rewriting of a program multiplies its roundings: programs in double precision against the
// traced programs in long double, where they are worst. The error at one state is one throw: it may be nearly zero by
// chance, before or after. So an error is the root of a mean square over neighbours of a state, whose roundings differ
// and whose condition does not.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen::testing {
namespace {

using Precise = long double;

using Function = Precise (*)(Precise, Precise, Precise);

Precise applied(Op op, Precise a, Precise b, Precise c) {
  static const std::map<Op, Function> kFunctions = {
      {Op::add, [](Precise x, Precise y, Precise) { return x + y; }},
      {Op::subtract, [](Precise x, Precise y, Precise) { return x - y; }},
      {Op::multiply, [](Precise x, Precise y, Precise) { return x * y; }},
      {Op::divide, [](Precise x, Precise y, Precise) { return x / y; }},
      {Op::negate, [](Precise x, Precise, Precise) { return -x; }},
      {Op::sqrt, [](Precise x, Precise, Precise) { return std::sqrt(x); }},
      {Op::sin, [](Precise x, Precise, Precise) { return std::sin(x); }},
      {Op::cos, [](Precise x, Precise, Precise) { return std::cos(x); }},
      {Op::atan2, [](Precise x, Precise y, Precise) { return std::atan2(x, y); }},
      {Op::abs, [](Precise x, Precise, Precise) { return std::abs(x); }},
      {Op::min, [](Precise x, Precise y, Precise) { return std::min(x, y); }},
      {Op::max, [](Precise x, Precise y, Precise) { return std::max(x, y); }},
      {Op::select, [](Precise x, Precise y, Precise z) { return x >= 0 ? y : z; }}};
  const auto found = kFunctions.find(op);
  if (found == kFunctions.end()) throw std::runtime_error(std::string("no long double for ") + op_name(op));
  return found->second(a, b, c);
}

using Inputs = std::map<Slot, double>;

std::vector<double> inputs_of(const Program& program, const Inputs& at) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(at.at(slot));
  return inputs;
}

std::vector<Precise> precisely(const Program& program, const Inputs& at) {
  const std::vector<double> inputs = inputs_of(program, at);
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

/// Largest error of an output over the largest output of its group, of all groups.
double error_of(const Program& program, const Inputs& at, const std::vector<Precise>& truth) {
  const std::vector<double> values = interpret(program, inputs_of(program, at));
  std::map<SlotGroup, std::pair<Precise, Precise>> largest;  // value and error
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(truth[i])) continue;
    auto& [value, error] = largest[program.outputs[i].slot.group];
    value = std::max(value, std::abs(truth[i]));
    error = std::max(error, std::abs(values[i] - truth[i]));
  }
  Precise most = 0;
  for (const auto& [group, of_group] : largest)
    if (of_group.first > 0) most = std::max(most, of_group.second / of_group.first);
  return static_cast<double>(most);
}

using Random = std::mt19937_64;
constexpr int kNeighbours = 64;     // 16 leave factors of 2 to chance, 200 give what 64 do
constexpr int kFewNeighbours = 4;   // for telling which states are bad
constexpr double kNear = 1e-9;      // rad, m and their rates
constexpr std::size_t kTried = 60;  // states, of which the worst are looked at
constexpr std::size_t kWorst = 8;
/// A program that is this good may become twice as bad as that: its error is that of its numbers.
constexpr double kExact = 4 * DBL_EPSILON;

/// A state with its neighbours, and the outputs there as the traced program has them.
struct Surroundings {
  std::vector<Inputs> inputs;
  std::vector<std::vector<Precise>> truth;

  double error_of(const Program& program) const {
    double sum = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      sum += std::pow(testing::error_of(program, inputs[i], truth[i]), 2) / static_cast<double>(inputs.size());
    return std::sqrt(sum);
  }
};

Surroundings around(const Inputs& state, const Program& traced, int neighbours, Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Surroundings all;
  for (int i = 0; i < neighbours; ++i) {
    Inputs near = state;
    for (auto& [slot, value] : near) value += kNear * unit(random);
    all.truth.push_back(precisely(traced, near));
    all.inputs.push_back(std::move(near));
  }
  return all;
}

/// States up to `reach` rad or m from the reference, a third of that and a tenth.
std::vector<Inputs> random_states(const Program& program, double reach, Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Inputs> states;
  for (std::size_t k = 0; k < kTried; ++k) {
    const double positions = reach / std::array<double, 3>{1, 3, 10}[k % 3];
    Inputs& state = states.emplace_back();
    for (const Slot& slot : program.inputs)
      state[slot] = (slot.group == SlotGroup(Array::z) ? positions : 1.0) * unit(random);
  }
  return states;
}

/// The reference states of a vehicle, and some around them, further out, where closures become badly conditioned.
std::vector<Inputs> vehicle_states(const Program& program, const Topology& topology, const std::string& file,
                                   Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Inputs> states;
  const std::vector<ReferenceState> known = reference_states(topology, file);
  for (const double reach : {0.0, 0.2, 0.5, 0.8})
    for (const ReferenceState& at : known) {
      Inputs& state = states.emplace_back();
      for (const Slot& slot : program.inputs) {
        const auto place = static_cast<std::size_t>(slot.index);
        state[slot] = slot.group == SlotGroup(Array::z)     ? at.state.z[place] + reach * unit(random)
                      : slot.group == SlotGroup(Array::zd)  ? at.state.zd[place]
                      : slot.group == SlotGroup(Array::tau) ? at.tau[place]
                                                            : unit(random);
      }
    }
  return states;
}

/// The states at which a program is worst, with their neighbours.
std::vector<Surroundings> worst_of(const std::vector<Inputs>& states, const Program& traced, Random& random) {
  std::vector<std::pair<double, const Inputs*>> all;
  for (const Inputs& state : states) {
    const double error = around(state, traced, kFewNeighbours, random).error_of(traced);
    if (error > 0 && error < 1e-3) all.emplace_back(error, &state);  // above: nothing is known there
  }
  std::ranges::sort(all, std::greater(), [](const auto& entry) { return entry.first; });
  std::vector<Surroundings> worst;
  for (std::size_t k = 0; k < std::min(kWorst, all.size()); ++k)
    worst.push_back(around(*all[k].second, traced, kNeighbours, random));
  return worst;
}

/// The errors of one program from stage to stage.
class Track {
 public:
  Track(std::string name, std::vector<Surroundings> states, const Program& traced)
      : name_(std::move(name)), states_(std::move(states)), before_(errors_of(traced)) {}

  /// Times its error before: the most that the stage made of it at any of the states.
  double factor_of(const Program& program) {
    const std::vector<double> now = errors_of(program);
    double most = 0;
    for (std::size_t k = 0; k < now.size(); ++k) most = std::max(most, now[k] / std::max(before_[k], kExact));
    before_ = now;
    return most;
  }
  Track renamed(std::string name) const {
    Track other = *this;
    other.name_ = std::move(name);
    return other;
  }
  double worst() const { return *std::ranges::max_element(before_); }
  const std::string& name() const { return name_; }

 private:
  std::vector<double> errors_of(const Program& program) const {
    std::vector<double> errors;
    for (const Surroundings& state : states_) errors.push_back(state.error_of(program));
    return errors;
  }
  std::string name_;
  std::vector<Surroundings> states_;
  std::vector<double> before_;
};

const char* const kPairs = "in pairs";
constexpr double kMost = 2;  // docs/method/identities.md

struct RoundingCase {
  const char* model;
  const char* states = "";  // "": random ones
  double reach = 2;
};

void PrintTo(const RoundingCase& rounding_case, std::ostream* out) { *out << rounding_case.model; }

class Roundings : public ::testing::TestWithParam<RoundingCase> {
 protected:
  void follow(const Stage& stage) {
    const WholePrograms& whole = stage.so_far.whole;
    const WrittenPrograms& emitted = stage.so_far.emitted;
    const bool is_whole = all_programs(emitted).empty();
    for (const Role role : {Role::accelerations, Role::accelerations_chosen, Role::closure_terms, Role::multipliers}) {
      const Program& program = program_of(is_whole ? whole.programs : emitted.programs, role);
      if (!program.outputs.empty()) follow(stage, name_of(role), program);
    }
    const auto& in_pairs = is_whole ? whole.in_pairs : emitted.in_pairs;
    if (!in_pairs || whole.around_laws) return;
    if (std::ranges::find(tracks_, kPairs, &Track::name) == tracks_.end()) {  // they replace the accelerations
      const auto numbers = std::ranges::find(tracks_, name_of(Role::accelerations), &Track::name);
      tracks_.push_back(numbers->renamed(kPairs));
    }
    follow(stage, kPairs, unfolded(in_pairs->program));
  }

 private:
  void follow(const Stage& stage, const std::string& name, const Program& program) {
    const auto track = std::ranges::find(tracks_, name, &Track::name);
    if (track == tracks_.end()) return begin(stage, name, program);
    const double factor = track->factor_of(program);
    std::printf("%s, %s, %s: error %.1e, factor %.2f\n", GetParam().model, name.c_str(),
                std::string(stage.name).c_str(), track->worst(), factor);
    EXPECT_LE(factor, kMost) << name << " " << stage.name;
  }

  void begin(const Stage& stage, const std::string& name, const Program& program) {
    Random random(38);
    const auto [model, file, reach] = GetParam();
    const std::vector<Inputs> states = *file != 0 ? vehicle_states(program, stage.so_far.topology, file, random)
                                                  : random_states(program, reach, random);
    std::vector<Surroundings> worst = worst_of(states, program, random);
    ASSERT_FALSE(worst.empty()) << name;
    tracks_.emplace_back(name, std::move(worst), program);
  }
  std::vector<Track> tracks_;
};

TEST_P(Roundings, OfEachRewritingStayWithinItsFactor) {
  if constexpr (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is double here";
  Result<Model> model = read_model_file(source_path(GetParam().model));
  ASSERT_TRUE(model);
  CompileOptions options;
  options.watch = [&](const Stage& stage) {
    follow(stage);
    return true;
  };
  ASSERT_TRUE(compile(*model, options));
}

const RoundingCase kRoundingCases[] = {
    {"models/coach_mechanism.json", "tests/data/reference/coach_states.json"},
    {"models/truck_mechanism.json", "tests/data/reference/truck_states.json"},
    {"models/andrews_squeezer.json"},
    {"models/agile_eye.json"},
    {"models/delta.json"},
    {"models/iftomm/a04_bricard.json"},
    {"models/axles/iltis.json", "", 0.5},
    {"tests/data/models/spatial_four_bar.json"},
};

INSTANTIATE_TEST_SUITE_P(Models, Roundings, ::testing::ValuesIn(kRoundingCases),
                         [](const auto& info) { return std::filesystem::path(info.param.model).stem().string(); });

}  // namespace
}  // namespace mbgen::testing
