// Reactions against statics and dynamics worked out by hand. Lengths in m, g = 10 m/s^2.

#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

// Rounding of forces of some hundred newtons.
constexpr double kTolerance = 1e-9;

Model planar(const std::string& sections) {
  return model_of(R"({"mbgen": 1, "name": "test", "gravity": [0, 0, -10], )" + sections + "}");
}

// Wall, weld, beam of 4 kg and 2 m, driven hinge held at zero, beam of 2 kg and 1 m, weld, tip mass of 1 kg.
TEST(Statics, CantileveredChain) {
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"wall": [0, 0, 0]}},
      "first": {"mass": 4, "com": [1, 0, 0], "inertia": [0, 1, 1], "points": {"a": [0, 0, 0], "b": [2, 0, 0]}},
      "second": {"mass": 2, "com": [2.5, 0, 0], "inertia": [0, 1, 1], "points": {"b": [2, 0, 0], "c": [3, 0, 0]}},
      "tip": {"mass": 1, "com": [3, 0, 0], "inertia": [0, 0, 0], "points": {"c": [3, 0, 0]}}
    },
    "joints": {
      "clamp": {"type": "fixed", "from": "ground.wall", "to": "first.a"},
      "hinge": {"type": "revolute", "from": "first.b", "to": "second.b", "axis": "y"},
      "glue": {"type": "fixed", "from": "tip.c", "to": "second.c"}
    },
    "motions": {"hold": {"joint": "hinge", "angle": 0}})"),
                                   {});
  expect_vector(r.force.at("clamp"), {0, 0, 70}, kTolerance, "clamp force");
  // A force up at arm x turns about -y: the wall turns the beam about -y to hold 4 * 10 * 1 + 2 * 10 * 2.5 + 10 * 3.
  expect_vector(r.moment.at("clamp"), {0, -120, 0}, kTolerance, "clamp moment");
  expect_vector(r.force_from.at("clamp"), {0, 0, -70}, kTolerance, "wall force");
  expect_vector(r.moment_from.at("clamp"), {0, 120, 0}, kTolerance, "wall moment");
  expect_vector(r.force.at("hinge"), {0, 0, 30}, kTolerance, "hinge force");
  expect_vector(r.moment.at("hinge"), {0, -20, 0}, kTolerance, "hinge moment");
  // From the tip to the beam: the tip hangs on it.
  expect_vector(r.force.at("glue"), {0, 0, -10}, kTolerance, "glue force");
  expect_vector(r.moment.at("glue"), {0, 0, 0}, kTolerance, "glue moment");
}

// Beam of 6 m and 3 kg on a pin and a roller, 90 N at a third: a closed planar loop that cannot move.
TEST(Statics, SimplySupportedBeam) {
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"a": [0, 0, 0], "b": [6, 0, 0], "aside": [0, 5, 0]}},
      "beam": {"mass": 3, "com": [3, 0, 0], "inertia": [0, 9, 9],
               "points": {"a": [0, 0, 0], "b": [6, 0, 0], "load": [2, 0, 0]}},
      "roller": {"points": {"b": [6, 0, 0]}},
      "pendulum": {"mass": 1, "com": [0, 5, -1], "inertia": [0, 0, 0], "points": {"pin": [0, 5, 0]}}
    },
    "joints": {
      "pin": {"type": "revolute", "from": "ground.a", "to": "beam.a", "axis": "y"},
      "track": {"type": "prismatic", "from": "ground.b", "to": "roller.b", "axis": "x"},
      "bearing": {"type": "revolute", "from": "beam.b", "to": "roller.b", "axis": "y", "cut": true},
      "swing": {"type": "revolute", "from": "ground.aside", "to": "pendulum.pin", "axis": "y"}
    },
    "forces": {"load": {"at": "beam.load", "force": [5, 0, -90]}})"),
                                   {});
  expect_vector(r.force.at("pin"), {-5, 0, 75}, kTolerance, "pin");
  expect_vector(r.force.at("track"), {0, 0, 45}, kTolerance, "track");
  expect_vector(r.force.at("bearing"), {0, 0, -45}, kTolerance, "bearing on the roller");
  expect_vector(r.force_from.at("bearing"), {0, 0, 45}, kTolerance, "bearing on the beam");
  expect_vector(r.moment.at("bearing"), {0, 0, 0}, kTolerance, "bearing moment");
  expect_vector(r.force.at("swing"), {0, 0, 10}, kTolerance, "swing");
}

// Two rods at right angles hold a weight of 100 N: 80 N and 60 N by resolving along each.
TEST(Statics, WeightOnTwoRods) {
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"a": [-3, 0, 4], "b": [4, 0, 3], "o": [0, 0, 0]}},
      "node": {"mass": 10, "com": [0, 0, 0], "inertia": [1, 1, 1], "points": {"o": [0, 0, 0]}}
    },
    "joints": {"plane": {"type": "planar", "from": "ground.o", "to": "node.o", "axis": "y"}},
    "rods": {"left": {"from": "ground.a", "to": "node.o"}, "right": {"from": "node.o", "to": "ground.b"}})"),
                                   {});
  expect_vector(r.force.at("left"), {-48, 0, 64}, kTolerance, "left on the node");
  expect_vector(r.force_from.at("left"), {48, 0, -64}, kTolerance, "left on ground");
  expect_vector(r.force.at("right"), {-48, 0, -36}, kTolerance, "right on ground");
  expect_vector(r.force.at("plane"), {0, 0, 0}, kTolerance, "plane");
}

// A-frame of three rods, 6 m wide and 4 m high, 100 N on top: legs 62.5 N in compression, tie 37.5 N in tension. Rods
// with weight: half of each leg's adds to the load at the top, and the ends carry the halves of theirs.
TEST(Statics, AFrameOfRods) {
  for (const double mass : {0.0, 2.0}) {
    Model model = planar(R"(
      "bodies": {
        "ground": {"points": {"a": [-3, 0, 0], "b": [3, 0, 0], "c": [0, 0, 4]}},
        "foot": {"mass": 0.001, "com": [3, 0, 0], "inertia": [1, 1, 1], "points": {"b": [3, 0, 0]}},
        "top": {"mass": 10, "com": [0, 0, 4], "inertia": [1, 1, 1], "points": {"c": [0, 0, 4]}}
      },
      "joints": {
        "roller": {"type": "prismatic", "from": "ground.b", "to": "foot.b", "axis": "x"},
        "plane": {"type": "planar", "from": "ground.c", "to": "top.c", "axis": "y"}
      },
      "rods": {
        "left": {"from": "ground.a", "to": "top.c"}, "right": {"from": "foot.b", "to": "top.c"},
        "tie": {"from": "ground.a", "to": "foot.b"}
      },
      "outputs": {
        "left": {"multiplier": "left"}, "right": {"multiplier": "right"}, "tie": {"multiplier": "tie", "equation": 0}
      })");
    for (Rod& rod : model.rods) rod.mass = mass;
    const double weight = 10 * mass, apex = 100 + weight;  // of one rod; on the legs at the top
    const Reading r = read_reactions(model, {});
    const double along_ground = 3.0 / 8 * apex;  // thrust of each leg
    expect_vector(r.force.at("left"), {along_ground, 0, (apex - weight) / 2}, kTolerance, "left on the top");
    expect_vector(r.force.at("right"), {-along_ground, 0, (apex - weight) / 2}, kTolerance, "right on the top");
    expect_vector(r.force_from.at("left"), {-along_ground, 0, -(apex + weight) / 2}, kTolerance, "left on ground");
    expect_vector(r.force.at("tie"), {-along_ground, 0, -weight / 2}, kTolerance, "tie on the foot");
    expect_vector(r.force_from.at("tie"), {along_ground, 0, -weight / 2}, kTolerance, "tie on ground");
    expect_vector(r.force.at("roller"), {0, 0, apex / 2 + weight + 0.01}, kTolerance, "roller");
    if (mass != 0) continue;
    const Mechanism m = analysed(model);
    const std::vector<double> y = outputs_at(GenericSolver(m.model, m.topology, m.analysis), start_state(m),
                                             std::vector<double>(m.topology.size(), 0.0));
    EXPECT_NEAR(y[0], -62.5, kTolerance);
    EXPECT_NEAR(y[1], -62.5, kTolerance);
    EXPECT_NEAR(y[2], 37.5, kTolerance);
  }
}

// A tail lift at rest: the platform hangs on a lower arm and an upper bar, both 2 m long and level, 0.5 m apart; 200 N
// stand 1 m behind the pins. Platform: the bar pulls 400 N, the pin pushes 400 N back and carries 200 N. Arm: the
// cylinder from 1.5 m below the hinge takes hold of it at 2 m, at a slope of 3 in 4: its 200 N of lift are 1000/3 N.
TEST(Statics, TailLift) {
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"low": [0, 0, 0], "high": [0, 0, 0.5], "foot": [0, 0, -1.5], "aside": [0, 5, 0]}},
      "arm": {"points": {"low": [0, 0, 0], "pin": [2, 0, 0]}},
      "platform": {"mass": 20, "com": [3, 0, 0], "inertia": [1, 1, 1],
                   "points": {"pin": [2, 0, 0], "top": [2, 0, 0.5]}},
      "bar": {"points": {"high": [0, 0, 0.5], "top": [2, 0, 0.5]}},
      "pendulum": {"mass": 1, "com": [0, 5, -1], "inertia": [0, 0, 0], "points": {"pin": [0, 5, 0]}}
    },
    "joints": {
      "hinge": {"type": "revolute", "from": "ground.low", "to": "arm.low", "axis": "y"},
      "pin": {"type": "revolute", "from": "arm.pin", "to": "platform.pin", "axis": "y"},
      "bar_foot": {"type": "revolute", "from": "ground.high", "to": "bar.high", "axis": "y"},
      "bar_top": {"type": "revolute", "from": "bar.top", "to": "platform.top", "axis": "y", "cut": true},
      "swing": {"type": "revolute", "from": "ground.aside", "to": "pendulum.pin", "axis": "y"}
    },
    "rods": {"cylinder": {"from": "ground.foot", "to": "arm.pin"}})"),
                                   {});
  expect_vector(r.force.at("bar_top"), {-400, 0, 0}, kTolerance, "bar on the platform");
  expect_vector(r.force.at("bar_foot"), {-400, 0, 0}, kTolerance, "ground on the bar");
  expect_vector(r.force.at("pin"), {400, 0, 200}, kTolerance, "pin on the platform");
  expect_vector(r.force.at("cylinder"), {800.0 / 3, 0, 200}, kTolerance, "cylinder on the arm");
  expect_vector(r.force.at("hinge"), {400 - 800.0 / 3, 0, 0}, kTolerance, "hinge on the arm");
}

// A door on two hinges on one axis: the one that closes the loop says nothing new and gets nothing, the other holds
// all.
TEST(Statics, RedundantHingeCarriesNothing) {
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"low": [0, 0, 0], "high": [0, 0, 2]}},
      "door": {"mass": 30, "com": [0.4, 0, 1], "inertia": [10, 11.6, 1.6], "points": {"low": [0, 0, 0], "high": [0, 0, 2]}}
    },
    "joints": {
      "low": {"type": "revolute", "from": "ground.low", "to": "door.low", "axis": "z"},
      "high": {"type": "revolute", "from": "ground.high", "to": "door.high", "axis": "z", "cut": true}
    })"),
                                   {});
  expect_vector(r.force.at("high"), {0, 0, 0}, 0, "high");
  expect_vector(r.moment.at("high"), {0, 0, 0}, 0, "high moment");
  expect_vector(r.force.at("low"), {0, 0, 300}, kTolerance, "low");
  expect_vector(r.moment.at("low"), {0, -120, 0}, kTolerance, "low moment");
}

// Pendulum of length 2 to the centre of mass: towards the pin m l w^2 + m g cos, across m g sin (1 - m l^2 / I_pin).
TEST(Dynamics, Pendulum) {
  const double angle = 0.7, rate = 1.3, m = 3, l = 2, inertia = 0.9, g = 10;
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"pin": [0, 0, 0]}},
      "bob": {"mass": 3, "com": [0, 0, -2], "inertia": [0.9, 0.9, 0.1], "points": {"pin": [0, 0, 0]}}
    },
    "joints": {"pin": {"type": "revolute", "from": "ground.pin", "to": "bob.pin", "axis": "y"}})"),
                                   {{"pin", {angle, rate}}});
  const double towards = m * l * rate * rate + m * g * std::cos(angle),
               across = m * g * std::sin(angle) * (1 - m * l * l / (inertia + m * l * l));
  // A positive angle about y moves the bob to -x; inwards is (sin, 0, cos), across, against the fall, (-cos, 0, sin).
  expect_vector(
      r.force.at("pin"),
      {towards * std::sin(angle) - across * std::cos(angle), 0, towards * std::cos(angle) + across * std::sin(angle)},
      kTolerance, "pin");
  expect_vector(r.moment.at("pin"), {0, 0, 0}, kTolerance, "pin moment");
}

// A rotor driven at constant speed without gravity: its eccentricity pulls with m e w^2, and its product of inertia
// takes w^2 J_xz about its y axis.
TEST(Dynamics, UnbalancedRotor) {
  Model model = planar(R"(
    "bodies": {
      "ground": {"points": {"bearing": [0, 0, 0]}},
      "rotor": {"mass": 5, "com": [0.01, 0, 0], "inertia": [0.3, 0.3, 0.5, 0, 0.02, 0], "points": {"bearing": [0, 0, 0]}}
    },
    "joints": {"bearing": {"type": "revolute", "from": "ground.bearing", "to": "rotor.bearing", "axis": "z"}},
    "motions": {"spin": {"joint": "bearing", "angle": "30*t + 0.4"}})");
  model.gravity = {0.0, 0.0, 0.0};
  const Reading r = read_reactions(model, {});
  const double w = 30, angle = 0.4, pull = 5 * 0.01 * w * w, turn = 0.02 * w * w;
  expect_vector(r.force.at("bearing"), {-pull * std::cos(angle), -pull * std::sin(angle), 0}, kTolerance, "bearing");
  expect_vector(r.moment.at("bearing"), {-turn * std::sin(angle), turn * std::cos(angle), 0}, kTolerance, "moment");
}

// A point mass on a cone: tension m g / cos at W^2 = g / (l cos).
TEST(Dynamics, ConicalPendulum) {
  const double angle = 0.6, l = 1.5, whirl = std::sqrt(10 / (l * std::cos(angle)));
  const Reading r = read_reactions(planar(R"(
    "bodies": {
      "ground": {"points": {"top": [0, 0, 0]}},
      "bob": {"mass": 2, "com": [0, 0, -1.5], "inertia": [0, 0, 0], "points": {"top": [0, 0, 0]}}
    },
    "joints": {"top": {"type": "universal", "from": "ground.top", "to": "bob.top", "axis": "x", "axis2": "y"}})"),
                                   {{"top_rx", {0, whirl * std::tan(angle)}}, {"top_ry", {angle, 0}}});
  const double tension = 2 * 10 / std::cos(angle);
  expect_vector(r.force.at("top"), {tension * std::sin(angle), 0, tension * std::cos(angle)}, kTolerance, "top");
  expect_vector(r.moment.at("top"), {0, 0, 0}, kTolerance, "top moment");
}

// A spring between two coordinates works on each joint by itself: 2 N m/rad times the difference of 0.5 rad.
TEST(Dynamics, GearLikeSpringLoadsBothJoints) {
  Model model = planar(R"(
    "bodies": {
      "ground": {"points": {"a": [0, 0, 0], "b": [1, 0, 0]}},
      "first": {"mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1], "points": {"a": [0, 0, 0]}},
      "second": {"mass": 1, "com": [1, 0, 0], "inertia": [1, 1, 1], "points": {"b": [1, 0, 0]}}
    },
    "joints": {
      "a": {"type": "revolute", "from": "ground.a", "to": "first.a", "axis": "z"},
      "b": {"type": "revolute", "from": "ground.b", "to": "second.b", "axis": "z"}
    },
    "joint_springs": {"gear": {"joint": "a", "relative_to": "b", "stiffness": 2}})");
  const Reading r = read_reactions(model, {{"a", {0.7, 0}}, {"b", {0.2, 0}}});
  EXPECT_NEAR(r.moment.at("a").z, -1, kTolerance);
  EXPECT_NEAR(r.moment.at("b").z, 1, kTolerance);
}

// The components in body axes are those of the end that is asked for.
TEST(Dynamics, BodyAxesAreThoseOfTheEnd) {
  Model model = planar(R"(
    "bodies": {
      "ground": {"points": {"pin": [0, 0, 0]}},
      "bob": {"pose": {"rotation": {"axis": "y", "angle": {"deg": 90}}}, "mass": 3, "com": [1, 0, 0],
              "inertia": [0, 0, 0], "points": {"pin": [0, 0, 0]}}
    },
    "joints": {"pin": {"type": "revolute", "from": "ground.pin", "to": "bob.pin", "axis": "y"}},
    "outputs": {
      "along": {"reaction": "pin", "axis": "x", "frame": "body"},
      "upwards": {"reaction": "pin", "axis": "z"},
      "on_ground": {"reaction": "pin", "axis": "z", "frame": "body", "end": "from"}
    })");
  const Mechanism m = analysed(model);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state{{0.7}, {1.3}, {}, 0};
  const std::vector<double> y = outputs_at(solver, state, {0.0});
  // Body x points from the pin down to the mass: the pin pulls back along it.
  EXPECT_NEAR(y[0], -(3 * 1.3 * 1.3 + 30 * std::cos(0.7)), kTolerance);
  EXPECT_NEAR(y[1], -y[2], kTolerance);
}

}  // namespace
}  // namespace mbgen
