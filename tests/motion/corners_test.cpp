// Corners of laws under error control: found and started from anew, against closed forms, beside the same motion that
// takes them as they come.

#include <numbers>

#include "tests/support/cli_support.hpp"
#include "workbench/motion/controlled_engine.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli_test {
namespace {

/// A motion to its end, and what it took.
struct Controlled {
  GenericState state;
  ErrorControlRecord record;
};

class CornersOfLaws : public CommandLine {
 protected:
  /// A body on a slide along x that starts from here, with these laws.
  Controlled slid(double from, double speed, double duration, bool finds_corners, const std::string& laws) const {
    const Compilation c = *decide(write("slide.json", fmt::format(
                                                          R"({{ "mbgen": 1, "name": "slide", "gravity": [-10, 0, 0],
                "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
                            "body": {{ "mass": 2, "inertia": [0, 0, 0], "points": {{ "O": [0, 0, 0] }} }} }},
                "joints": {{ "x": {{ "type": "prismatic", "from": "ground.O", "to": "body.O", "axis": "x" }} }},
                "initial": {{ "positions": {{ "x": {} }}, "velocities": {{ "x": {} }} }}, {} }})",
                                                          from, speed, laws)));
    const InputsOverTime inputs = inputs_over_time(c.model, {}, "", Interpolation::pchip);
    const Start start = initial_start(c, inputs.at(0));
    ErrorControl control;
    control.tolerance = 1e-9;
    control.end = duration;
    control.finds_corners = finds_corners;
    const auto record = std::make_shared<ErrorControlRecord>();
    const Engine engine = with_error_control(c, make_generic_engine(c, {}), inputs, control, record);
    Controlled result{start.state, {}};
    EXPECT_TRUE(engine.step(result.state, duration).ok());
    result.record = *record;
    return result;
  }
  static void report(const char* what, double error, const ErrorControlRecord& record) {
    std::printf("%s, %s corners: error %.1e in %ld steps, %ld rejected, %ld evaluations, %ld corners\n", what,
                record.control.finds_corners ? "finding" : "without", error, record.steps, record.rejected,
                record.evaluations, record.corners);
  }
};

// From 0.2 m onto a spring of 4e4 N/m, ten times: in contact for half an oscillation and a little more. At the top
// again it has the height and the speed of the start.
TEST_F(CornersOfLaws, BodyThatBouncesOnAStop) {
  const double omega = std::sqrt(4e4 / 2), impact = std::sqrt(2 * 10 * 0.2);
  const double contact = 2 / omega * (std::numbers::pi - std::atan(impact * omega / 10));
  const double duration = 10 * (2 * impact / 10 + contact);
  double errors[2];
  long evaluations[2];
  for (const bool finds : {false, true}) {
    const Controlled end = slid(0.2, 0, duration, finds,
                                R"("bump_stops": { "floor": { "joint": "x", "side": "below", "clearance": 0,
                                   "stiffness": 4e4, "exponent": 1 } })");
    errors[finds] = std::abs(end.state.z[0] - 0.2) + std::abs(end.state.zd[0]);
    evaluations[finds] = end.record.evaluations;
    report("bounce", errors[finds], end.record);
    EXPECT_EQ(end.record.corners, finds ? 20 : 0);
  }
  EXPECT_LT(errors[1], 3e-5);
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(evaluations[1], evaluations[0]);
}

// Friction that holds 12 N and falls with the speed below 1 mm/s: 3 m/s are gone after 0.5 s but for that, then the
// rest dies away with 0.17 ms.
TEST_F(CornersOfLaws, BlockThatComesToRest) {
  const double deceleration = 12.0 / 2, least = 1e-3;
  const double way = (9 - least * least) / (2 * deceleration) + least * least / deceleration;
  double errors[2];
  long evaluations[2];
  for (const bool finds : {false, true}) {
    const Controlled end = slid(0, 3, 0.6, finds, R"j("joint_forces": { "floor": { "joint": "x",
      "force": "20 - 12*max(-1, min(1, zd.x/1e-3))" } })j");
    errors[finds] = std::abs(end.state.z[0] - way);
    evaluations[finds] = end.record.evaluations;
    report("rest", errors[finds], end.record);
    EXPECT_EQ(end.record.corners, finds ? 1 : 0);
  }
  EXPECT_LT(errors[1], 2e-9);
  EXPECT_LT(evaluations[1], evaluations[0]);
}

}  // namespace
}  // namespace mbgen::cli_test
