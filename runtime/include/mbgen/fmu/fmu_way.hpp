#pragma once
// Closing of an instance's loops along the path from the last closed state, so that they keep their assembly mode, and
// the solution there. See fmu_state.hpp.

#include "mbgen/fmu/fmu_state.hpp"

namespace mbgen::fmu {

/// Rotation of a coordinate of a loop in one part of the path from the last closed state, rad, by its velocities; if
/// the parts fail, twice as many are tried each time.
constexpr double kTurnOfPart = 0.25;
constexpr int kMostParts = 64, kMostPartsAtFirst = 4096;

/// Positions and velocities over time that differ by more than velocities at both ends explain are no motion.
constexpr double kSameMotion = 4;

/// Between a and b: b itself at the end.
inline double between(double a, double b, int part, int parts) noexcept {
  return part == parts ? b : a + (b - a) * part / parts;
}

/// Motion of one coordinate from the last closed state to a given one.
struct Way {
  double from, rate_from, to, rate_to;
  double time;  ///< s, or 0 where it is no motion

  /// By the cubic that has positions and velocities of both ends. The rate is per second.
  void at(int part, int parts, double& position, double& rate) const noexcept {
    position = between(from, to, part, parts);
    rate = between(rate_from, rate_to, part, parts);
    if (time == 0 || part == parts) return;
    const double s = static_cast<double>(part) / parts, change = to - from;
    const double square = 3 * change - time * (2 * rate_from + rate_to),
                 cube = time * (rate_from + rate_to) - 2 * change;
    position = from + s * (time * rate_from + s * (square + s * cube));
    rate = rate_from + s * (2 * square + 3 * s * cube) / time;
  }
};

/// The way of independent coordinate i.
template <class Model>
Way way_of(const Run<Model>& run, int i, double time) noexcept {
  const typename Model::State &from = run.closed.state, &to = run.state;
  return {from.z[i], from.zd[i], to.z[i], to.zd[i], time};
}

/// Seconds from the last closed state, where the independent coordinates have moved as velocities say; else 0.
template <class Model>
double time_of_motion(const Run<Model>& run) noexcept {
  const double time = run.state.t - run.closed.state.t;
  for (int k = 0; k < Model::kVelocityStates; ++k) {
    const Way way = way_of(run, run.choice.coordinate[k], time);
    const double fastest = std::fmax(std::abs(way.rate_from), std::abs(way.rate_to));
    if (!(std::abs(way.to - way.from) <= kSameMotion * time * fastest)) return 0;
  }
  return time;
}

/// Parts of the way to begin with: one where no coordinate of a loop turns far.
template <class Model>
int parts_at_first(const Run<Model>& run, double time, const unsigned char* independent) noexcept {
  double largest = 0;
  for (int i = 0; i < Model::kCoordinates; ++i) {
    if (Model::kBlockOf[i] < 0 || !Model::is_rotation(i)) continue;
    const double turn = independent[i] != 0 ? run.state.z[i] - run.closed.state.z[i] : time * run.closed.state.zd[i];
    largest = std::fmax(largest, std::abs(turn));
  }
  return static_cast<int>(std::fmin(std::ceil(std::fmax(largest / kTurnOfPart, 1)), kMostPartsAtFirst));
}

/// Inputs and parameters on the way.
template <class Model>
Closed<Model> given_at(const Run<Model>& run, int part, int parts) noexcept {
  const Closed<Model>& from = run.closed;
  Closed<Model> given{{}, current_inputs(run), run.parameters};
  if (part == parts) return given;
  for (int i = 0; i < Model::kInputs; ++i) {
    const auto member = Model::kInputMember[i];
    given.inputs.*member = between(from.inputs.*member, given.inputs.*member, part, parts);
  }
  for (int i = 0; i < Model::kParameters; ++i) {
    const auto member = Model::kParameterMember[i];
    given.parameters.*member = between(from.parameters.*member, run.parameters.*member, part, parts);
  }
  given.parameters = typename Model::Parameters(given.parameters);
  return given;
}

/// Closes the loops of `run` from its last closed state in equal parts of the way; dependent coordinates are guessed by
/// their velocities. The state is spoilt when it fails. Fails: loop_not_closed also where a part leads over a dead
/// point to another way of assembly. service: the least of each block between the ends.
template <class Model>
Status close_in_parts(const Run<Model>& run, int parts, double time, const unsigned char* independent,
                      typename Model::State& state, double* service) noexcept {
  const Closed<Model>& from = run.closed;
  state = from.state;
  for (int i = 0; i < Model::kAuxiliaryStates; ++i) state.x[i] = run.state.x[i];
  for (int b = 0; b < kBlocks<Model>; ++b) service[b] = HUGE_VAL;
  for (int part = 1; part <= parts; ++part) {
    const Closed<Model> given = given_at(run, part, parts);
    const typename Model::State before = state;
    state.t = between(from.state.t, run.state.t, part, parts);
    for (int i = 0; i < Model::kCoordinates; ++i) {
      if (independent[i] == 0) {
        state.z[i] += time / parts * state.zd[i];
      } else {
        way_of(run, i, time).at(part, parts, state.z[i], state.zd[i]);
      }
    }
    const Status status = Model::assemble_from_independent(given.parameters, given.inputs, independent, state);
    if (!status.ok()) return status;
    const int block = Model::block_with_other_side(given.parameters, given.inputs, before, state, independent);
    if (block >= 0) return {Code::loop_not_closed, block};
    if (part == parts) break;
    double here[kBlocks<Model>];
    Model::independent_condition(given.parameters, given.inputs, state, independent, run.choice.reference, here);
    for (int b = 0; b < Model::kLoopBlocks; ++b) service[b] = std::fmin(service[b], here[b]);
  }
  return {};
}

/// The same in as many parts as it takes to stay on the way of assembly.
template <class Model>
Status close_from_last(const Run<Model>& run, typename Model::State& state, double* service) noexcept {
  unsigned char independent[Model::kCoordinates];
  mark(run.choice, independent);
  const double time = time_of_motion(run);
  const int first = parts_at_first(run, time, independent), most = first > kMostParts ? 2 * first : kMostParts;
  Status status;
  for (int parts = first; parts <= most; parts *= 2) {
    status = close_in_parts(run, parts, time, independent, state, service);
    if (status.code != Code::loop_not_closed && status.code != Code::loop_singular) return status;
  }
  return status;
}

/// Condition of the independent coordinates, per block, there and along the path. Requires: solved.
template <class Model>
const double* service_of(Core<Model>& core) noexcept {
  if (!core.has_service) {
    unsigned char independent[Model::kCoordinates];
    mark(core.run.choice, independent);
    Model::independent_condition(core.run.parameters, current_inputs(core.run), core.solved, independent,
                                 core.run.choice.reference, core.service);
    for (int b = 0; b < Model::kLoopBlocks; ++b) core.service[b] = std::fmin(core.service[b], core.service_on_way[b]);
    core.has_service = true;
  }
  return core.service;
}

/// When the motion leads to, or came from, a dead point of each block: dead_point_times of independent.hpp. Requires:
/// solved.
template <class Model>
void find_dead_points(const Core<Model>& core, double direction, double* times) noexcept {
  unsigned char independent[Model::kCoordinates];
  mark(core.run.choice, independent);
  Model::dead_point_times(core.run.parameters, current_inputs(core.run), core.solved, core.derivative, independent,
                          direction, times);
}

/// Whether a ball should have its other angles. Co-simulation changes them inside of its steps.
template <class Model>
bool leaves_charts([[maybe_unused]] const Run<Model>& run,
                   [[maybe_unused]] const typename Model::State& state) noexcept {
  if constexpr (kHasCharts<Model>) {
    return Model::leaves_charts(run.parameters, run.inputs, state);
  } else {
    return false;
  }
}

/// An event indicator: the condition of the states of its loop block minus the limit for other coordinates, or whether
/// all balls have suitable angles. Requires: solved, and a call of service_of.
template <class Model>
double indicator_of(const Core<Model>& core, int indicator) noexcept {
  const int block = Model::kIndicatorBlock[indicator];
  if (block >= 0) return core.service[block] - kWornPivot;
  return leaves_charts(core.run, core.solved) ? -1 : 1;
}

/// Two predictions of the time of a dead point, from both sides, that mean the same one may differ by this factor.
constexpr double kSameDeadPoint = 1.1;

/// The first indicator whose loop block may have passed a dead point of its independent coordinates since the last
/// accepted point, or -1: it is at the dead point, or the motions at both ends indicate that it lies between them.
/// States on both sides of a dead point have the same coordinates, so that a step across it would bounce back.
/// Requires: solved.
template <class Model>
int lost_indicator(Core<Model>& core) noexcept {
  const Run<Model>& run = core.run;
  const double since = run.state.t - run.accepted_time;
  double back[kBlocks<Model>];
  bool has_back = false;
  for (int k = 0; k < Model::kIndicators; ++k) {
    const int block = Model::kIndicatorBlock[k];
    if (block < 0) continue;
    if (service_of(core)[block] < kLostPivot) return k;
    if (!(run.dead_point[block] < since)) continue;
    if (!has_back) find_dead_points(core, -1, back);
    has_back = true;
    if (run.dead_point[block] + back[block] <= kSameDeadPoint * since) return k;
  }
  return -1;
}

/// Value reference of the first event indicator.
template <class Model>
constexpr unsigned kFirstIndicator = static_cast<unsigned>(1 + Model::kParameters + Model::kInputs + Model::kOutputs +
                                                           3 * Model::kCoordinates + Model::kAuxiliaryStates +
                                                           kFlowing<Model> + 3 * Model::kChosenStates +
                                                           Model::kStartParameters);

/// Closes the loops if they are open, and computes accelerations and outputs. At the start the given positions are the
/// guess, later the last closed state. In continuous time of model exchange a state that may be beyond a dead point is
/// refused with the reason.
template <class Model>
bool solve(Core<Model>& core) noexcept {
  if (core.is_solved) return true;
  if (is_impossible(core)) return false;
  const Run<Model>& run = core.run;
  core.solved = run.state;
  core.has_service = false;
  core.status = {};
  for (double& service : core.service_on_way) service = HUGE_VAL;
  if (!run.is_closed) {
    core.status = (run.mode & (kInstantiated | kInitialization)) != 0
                      ? Model::assemble(run.parameters, run.inputs, core.solved)
                      : close_from_last(run, core.solved, core.service_on_way);
  }
  const typename Model::Inputs inputs = current_inputs(run);
  if (core.status.ok()) core.status = Model::derivative(run.parameters, inputs, core.solved, core.derivative);
  if (core.status.ok()) {
    core.status = Model::outputs(run.parameters, inputs, core.solved, core.derivative, core.outputs);
  }
  if (core.status.ok() && run.mode == kContinuous && !run.is_closed) {
    const int lost = lost_indicator(core);
    if (lost >= 0) {
      core.refusal = Refusal::of_variable(kFirstIndicator<Model> + static_cast<unsigned>(lost),
                                          "has fallen too far in this step: the loop may have passed a dead point of "
                                          "its states; take a smaller step, up to the event");
      return false;
    }
  }
  core.is_solved = core.status.ok();
  if (core.is_solved && run.mode == kContinuous)
    core.evaluations.add(core.solved.t, core.solved.zd, [](int i) { return Model::is_rotation(i); });
  return core.is_solved;
}

/// Accepts the solution: the next ones start from it. Requires: solved.
template <class Model>
void commit(Core<Model>& core) noexcept {
  core.run.state = core.solved;
  core.run.is_closed = true;
}

}  // namespace mbgen::fmu
