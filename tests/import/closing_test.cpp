// Robots whose loops are open as written: walking machines of Theo Jansen's legs, all of whose links point along x at
// the zeros of their joints, in URDF and MJCF; and copies by <replicate>.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/import/import_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Point = std::array<double, 2>;  // x, z in m

// Jansen's proportions, m.
constexpr double kA = 0.38, kB = 0.415, kC = 0.393, kD = 0.401, kE = 0.558, kF = 0.394, kG = 0.367, kH = 0.657,
                 kI = 0.49, kJ = 0.5, kK = 0.619, kL = 0.078, kM = 0.15;

/// Where two circles meet.
Point meet(Point p, double rp, Point q, double rq, double side) {
  const double dx = q[0] - p[0], dz = q[1] - p[1], d = std::hypot(dx, dz);
  const double x = (rp * rp - rq * rq + d * d) / (2 * d), h = std::sqrt(rp * rp - x * x) * side;
  return {p[0] + (x * dx - h * dz) / d, p[1] + (x * dz + h * dx) / d};
}

/// Joints of a leg at a crank angle, s = 1 to the left and -1 to the right.
struct Leg {
  Point m, b, p1, p2, p3, p4, p5;
  Leg(double theta, double s)
      : m{kM * std::cos(theta), kM * std::sin(theta)},
        b{-s * kA, -kL},
        p1(meet(m, kJ, b, kB, -s)),
        p2(meet(b, kD, p1, kE, s)),
        p3(meet(m, kK, b, kC, s)),
        p4(meet(p2, kF, p3, kG, s)),
        p5(meet(p4, kH, p3, kI, s)) {}
};
Leg leg_of(int q, int legs) { return {2 * std::numbers::pi * (q / 2) / std::max(1, legs / 2) + 0.4, q % 2 ? -1. : 1.}; }

/// A turn about y that takes x to the direction.
double angle_of(Point from, Point to) { return std::atan2(from[1] - to[1], to[0] - from[0]); }
/// A point in the frame at `origin` whose x axis points to `along`.
Point seen(Point origin, Point along, Point point) {
  const double l = std::hypot(along[0] - origin[0], along[1] - origin[1]);
  const Point u = {(along[0] - origin[0]) / l, (along[1] - origin[1]) / l};
  const Point v = {point[0] - origin[0], point[1] - origin[1]};
  return {v[0] * u[0] + v[1] * u[1], v[1] * u[0] - v[0] * u[1]};
}

/// A link of a leg, its joint and its angle where the leg is closed.
struct LegLink {
  std::string name, parent, joint;
  std::array<double, 3> at;  ///< of the joint in the parent
  double position;           ///< of the joint where the leg is closed
};
struct LegLoop {
  std::string name, one, other;
  Point at_one, at_other;
};

std::vector<LegLink> links_of(int q, const Leg& p) {
  const double y = 0.06 * (q + 1), j = angle_of(p.m, p.p1), k = angle_of(p.m, p.p3), bde = angle_of(p.b, p.p1),
               c = angle_of(p.b, p.p3), f = angle_of(p.p2, p.p4), ghi = angle_of(p.p3, p.p4);
  const Point p2 = seen(p.b, p.p1, p.p2);
  const auto named = [&](const char* name) { return fmt::format("{}{}", name, q); };
  return {{named("j"), "crank", named("m_j"), {p.m[0], y, p.m[1]}, j},
          {named("k"), "crank", named("m_k"), {p.m[0], y, p.m[1]}, k},
          {named("bde"), "world", named("b_bde"), {p.b[0], y, p.b[1]}, bde},
          {named("c"), "world", named("b_c"), {p.b[0], y, p.b[1]}, c},
          {named("f"), named("bde"), named("bde_f"), {p2[0], 0, p2[1]}, f - bde},
          {named("ghi"), named("c"), named("c_ghi"), {kC, 0, 0}, ghi - c}};
}
std::vector<LegLoop> loops_of(int q) {
  const auto named = [&](const char* name) { return fmt::format("{}{}", name, q); };
  return {{named("j_bde"), named("j"), named("bde"), {kJ, 0}, {kB, 0}},
          {named("k_c"), named("k"), named("c"), {kK, 0}, {kC, 0}},
          {named("f_ghi"), named("f"), named("ghi"), {kF, 0}, {kG, 0}}};
}

/// Limits around the closed place within `reach`, without a reach none; the crank stays where it is.
std::string urdf_walker(int legs, double reach) {
  const std::string inertial =
      "<inertial><origin xyz='0.1 0 0'/><mass value='0.5'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' "
      "iyz='0'/></inertial>";
  const auto joint = [&](const LegLink& link, double lower, double upper) {
    return fmt::format(
        "<link name='{}'>{}</link><joint name='{}' type='{}'><parent link='{}'/><child link='{}'/>"
        "<origin xyz='{} {} {}'/><axis xyz='0 1 0'/><limit lower='{}' upper='{}'/></joint>\n",
        link.name, inertial, link.joint, reach > 0 ? "revolute" : "continuous", link.parent, link.name, link.at[0],
        link.at[1], link.at[2], lower, upper);
  };
  std::string links = joint({"crank", "world", "crank_pin", {0, 0, 0}, 0}, 0, 0), loops;
  for (int q = 0; q < legs; ++q) {
    for (const LegLink& link : links_of(q, leg_of(q, legs)))
      links += joint(link, link.position - reach, link.position + 0.7 * reach);
    for (const LegLoop& loop : loops_of(q))
      loops += fmt::format(
          "<loop_joint name='{}' type='revolute'><link1 link='{}' xyz='{} 0 {}'/>"
          "<link2 link='{}' xyz='{} 0 {}'/><axis xyz='0 1 0'/></loop_joint>\n",
          loop.name, loop.one, loop.at_one[0], loop.at_one[1], loop.other, loop.at_other[0], loop.at_other[1]);
  }
  return "<robot name='walker'><link name='world'/>" + links + loops + "</robot>";
}

/// A body, what hangs on it, and the sites that its loops have in it.
std::string mjcf_body(const LegLink& link, const std::vector<LegLink>& links, const std::vector<LegLoop>& loops,
                      double reach) {
  std::string text = fmt::format(
      "<body name='{}' pos='{} {} {}'><joint name='{}' axis='0 1 0' range='{} {}'/>"
      "<inertial pos='0.1 0 0' mass='0.5' diaginertia='0.01 0.01 0.01'/>",
      link.name, link.at[0], link.at[1], link.at[2], link.joint, link.position - reach, link.position + 0.7 * reach);
  for (const LegLoop& loop : loops) {
    if (loop.one == link.name)
      text += fmt::format("<site name='{}_1' pos='{} 0 {}'/>", loop.name, loop.at_one[0], loop.at_one[1]);
    if (loop.other == link.name)
      text += fmt::format("<site name='{}_2' pos='{} 0 {}'/>", loop.name, loop.at_other[0], loop.at_other[1]);
  }
  for (const LegLink& below : links)
    if (below.parent == link.name) text += mjcf_body(below, links, loops, reach);
  return text + "</body>\n";
}

std::string mjcf_walker(int legs, double reach) {
  std::vector<LegLink> links;
  std::vector<LegLoop> loops;
  for (int q = 0; q < legs; ++q) {
    for (const LegLink& link : links_of(q, leg_of(q, legs))) links.push_back(link);
    for (const LegLoop& loop : loops_of(q)) loops.push_back(loop);
  }
  std::string text = "<mujoco model='walker'><compiler angle='radian' autolimits='true'/><worldbody>";
  text += mjcf_body({"crank", "world", "crank_pin", {0, 0, 0}, 0}, links, loops, 1e-9);
  for (const LegLink& link : links)
    if (link.parent == "world") text += mjcf_body(link, links, loops, reach);
  text += "</worldbody><equality>";
  for (const LegLoop& loop : loops)
    text += fmt::format("<connect name='{0}' site1='{0}_1' site2='{0}_2'/>\n", loop.name);
  return text + "</equality></mujoco>";
}

/// The feet P5, in ghi, where the model has its bodies at the reference, against where the closed legs have them.
double foot_error(const Model& model, int legs) {
  double error = 0;
  for (int q = 0; q < legs; ++q) {
    const Leg p = leg_of(q, legs);
    const Point in_link = seen(p.p3, p.p4, p.p5);
    for (const Body& body : model.bodies) {
      if (body.name != fmt::format("ghi{}", q)) continue;
      const auto& [origin, r] = body.pose;
      error = std::max({error, std::abs(origin[0] + r[0] * in_link[0] + r[2] * in_link[1] - p.p5[0]),
                        std::abs(origin[2] + r[6] * in_link[0] + r[8] * in_link[1] - p.p5[1])});
    }
  }
  return error;
}

/// 42 loops and 73 joints that must be somewhere else, without a word of where.
TEST(ImportClosing, AWalkingMachineOf42LoopsClosesByItself) {
  const ImportedModel robot = imported_text(request_of("walker.urdf", urdf_walker(14, 0)));
  EXPECT_EQ(robot.loops, 42);
  const Mechanism m = mechanism_of(robot.json);  // the reader refuses loops that are open at the reference
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
  EXPECT_EQ(random_states(m, 2).size(), 2u);
}

/// Within limits that leave one way to assemble them, the legs are those of the closed form.
TEST(ImportClosing, LimitsChooseTheWayInUrdfAndMjcf) {
  constexpr int kLegs = 14;
  constexpr double kReach = 0.5;
  for (const bool is_urdf : {true, false}) {
    const ImportedModel robot = imported_text(is_urdf ? request_of("walker.urdf", urdf_walker(kLegs, kReach))
                                                      : request_of("walker.xml", mjcf_walker(kLegs, kReach)));
    EXPECT_EQ(robot.loops, 42);
    const Mechanism m = mechanism_of(robot.json);
    EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
    EXPECT_LT(foot_error(m.model, kLegs), 1e-8) << is_urdf;
  }
}

/// A rod that hangs on a ball at one end and is held by sites at the other, and a free body that a weld holds.
TEST(ImportClosing, BallsAndFreeBodiesMoveToo) {
  const ImportedModel robot = imported_text(request_of(
      "m.xml",
      "<mujoco><worldbody><body name='arm'><joint name='arm' axis='0 1 0'/><inertial pos='0.1 0 0' mass='1' "
      "diaginertia='0.1 0.1 0.1'/><site name='tip' pos='0.3 0 0'/></body>"
      "<body name='rod' pos='0.1 0.2 0.3'><joint name='ball' type='ball'/><inertial pos='0.1 0 0' mass='1' "
      "diaginertia='0.1 0.1 0.1'/><site name='end' pos='0.35 0 0'/></body>"
      "<body name='box' pos='3 0 0'><freejoint name='box'/><inertial pos='0 0 0' mass='1' diaginertia='0.1 0.1 "
      "0.1'/></body></worldbody><equality><connect name='rod_end' site1='tip' site2='end'/>"
      "<weld name='box_on_arm' body1='arm' body2='box' relpose='0.2 0 0.1 0.6 0 0.8 0'/></equality></mujoco>"));
  const Mechanism m = mechanism_of(robot.json);
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1);  // the rod turns about its length and holds the arm
  EXPECT_EQ(random_states(m, 2).size(), 2u);
}

/// A parallelogram with a crank of 0.2 m and a coupler of 0.5 m, its last pin moved in the rocker, aside of it, across
/// the plane and along the rocker, m.
ImportRequest parallelogram(double angle, double aside, double across, double along = 0) {
  const auto link = [](const char* name, const char* com) {
    return fmt::format(
        "<link name='{}'><inertial><origin xyz='{}'/><mass value='1'/><inertia ixx='0.01' iyy='0.01' "
        "izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial></link>",
        name, com);
  };
  const auto pin = [](const char* name, const char* from, const char* to, const char* at, double turn) {
    return fmt::format(
        "<joint name='{}' type='continuous'><origin xyz='{}' rpy='0 {} 0'/><parent link='{}'/>"
        "<child link='{}'/><axis xyz='0 1 0'/></joint>",
        name, at, turn, from, to);
  };
  return request_of("parallelogram.urdf",
                    "<robot name='p'><link name='world'/>" + link("crank", "0 0 0.1") + link("coupler", "0.25 0 0") +
                        link("rocker", "0 0 0.1") + pin("a", "world", "crank", "0 0 0", angle) +
                        pin("b", "crank", "coupler", "0 0 0.2", -angle) +
                        pin("d", "world", "rocker", "0.5 0 0", angle) +
                        fmt::format("<loop_joint name='c' type='revolute'><link1 link='coupler' xyz='0.5 0 0'/>"
                                    "<link2 link='rocker' xyz='{} {} {}'/><axis xyz='0 1 0'/></loop_joint></robot>",
                                    aside, across, 0.2 + along));
}

/// Where a link points that points up or along x as written, rad.
double turn_of(const Model& model, const char* name) {
  for (const Body& body : model.bodies)
    if (body.name == name) return std::atan2(body.pose.rotation[2], body.pose.rotation[0]);
  throw std::runtime_error("no such body");
}

/// A gap across the plane moves no joint: the points of the loop take it up. Upright, slanted and at the dead centre.
TEST(ImportClosing, AGapThatNoJointClosesMovesNone) {
  for (const double angle : {0.0, 0.7, std::numbers::pi / 2}) {
    for (const double across : {1e-5, 1e-4, 1e-3}) {
      const ImportedModel robot = imported_text(parallelogram(angle, 0, across));
      EXPECT_TRUE(has_note(robot, fmt::format("loops are open by up to {0:.3g} m as written; {0:.3g} m that no joint "
                                              "closes are taken up by the points",
                                              across)))
          << to_text(robot.notes);
      const Mechanism m = mechanism_of(robot.json);
      EXPECT_EQ(m.analysis.degrees_of_freedom, 1);
      EXPECT_NEAR(turn_of(m.model, "crank"), angle, 1e-9);
      EXPECT_NEAR(turn_of(m.model, "rocker"), angle, 1e-9);
    }
  }
}

/// A rocker that is 0.3 mm off along the coupler, and across it: the pins close the first part by turns of its size.
TEST(ImportClosing, AGapIsClosedByMovesOfItsSize) {
  for (const double across : {0.0, 1e-4}) {
    const ImportedModel robot = imported_text(parallelogram(0, 3e-4, across));
    EXPECT_TRUE(has_note(robot, "joints are moved to close them, \"a\" by ")) << to_text(robot.notes);
    const Mechanism m = mechanism_of(robot.json);
    for (const char* link : {"crank", "coupler", "rocker"})
      EXPECT_LT(std::abs(turn_of(m.model, link)), 2 * 3e-4 / 0.2) << link;
  }
}

/// At the dead centre a gap d along the arms of 0.2 and 0.5 m is closed by turns near (d/l)^(1/2).
TEST(ImportClosing, AtADeadCentreMovesAreThoseOfTheGap) {
  for (const double along : {-1e-3, 1e-3}) {
    const ImportedModel robot = imported_text(parallelogram(std::numbers::pi / 2, 0, 1e-4, along));
    EXPECT_TRUE(has_note(robot, "; 0.0001 m that no joint closes")) << to_text(robot.notes);
    const Model model = mechanism_of(robot.json).model;
    for (const char* link : {"crank", "rocker"})
      EXPECT_LT(std::abs(turn_of(model, link) - std::numbers::pi / 2), 4 * std::sqrt(1e-3 / 0.2)) << link;
  }
}

/// As the copies written out; what refers to them is copied with them.
TEST(ImportMjcf, ReplicatesAreCopies) {
  const auto read = [](const std::string& world, const std::string& rest) {
    return imported_text(
               request_of("m.xml", "<mujoco model='m'><worldbody>" + world + "</worldbody>" + rest + "</mujoco>"))
        .json;
  };
  const std::string bob =
      "<joint name='pin{0}' axis='0 1 0'/><geom type='box' size='0.1 0.2 0.3' pos='0.1 0 -0.5' mass='1'/></body>";
  const auto bob_at = [&](const char* name, const char* place) {
    return fmt::format("<body name='bob{}' {}>", name, place) + fmt::format(fmt::runtime(bob), name);
  };
  const std::string motor = "<motor name='pull{0}' joint='pin{0}' gear='2'/>",
                    spring = "<fixed name='rope{0}' stiffness='3'><joint joint='pin{0}' coef='2'/></fixed>",
                    rope = "<motor name='haul{0}' tendon='rope{0}'/>";
  const auto all = [&](const std::string& text, std::initializer_list<const char*> names) {
    std::string list;
    for (const char* name : names) list += fmt::format(fmt::runtime(text), name);
    return list;
  };
  const auto rest = [&](std::initializer_list<const char*> names) {
    return "<tendon>" + all(spring, names) + "</tendon><actuator>" + all(motor, names) + all(rope, names) +
           "</actuator>";
  };
  // The second copy is turned by 90 degrees and moved along the first one's axes, the third along the second's.
  EXPECT_EQ(
      read("<replicate count='3' offset='0.2 0 0' euler='0 0 90' sep='_'>" + bob_at("", "pos='1 0 0'") + "</replicate>",
           rest({""})),
      read(bob_at("_0", "pos='1 0 0'") + bob_at("_1", "pos='0.2 1 0' euler='0 0 90'") +
               bob_at("_2", "pos='-0.8 0.2 0' euler='0 0 180'"),
           rest({"_0", "_1", "_2"})));
  // Names of inner copies come first.
  EXPECT_NE(read("<replicate count='2' offset='0 1 0'><replicate count='10' offset='2 0 0'>" + bob_at("", "") +
                     "</replicate></replicate>",
                 "")
                .find("\"pin091\""),
            std::string::npos);
}

/// Cardan's joint between shafts at an angle of beta: tan(z1) = cos(beta) tan(z2).
TEST(ImportClosing, AUniversalConstraintIsCardansJoint) {
  const Mechanism m = mechanism_of(
      imported_text(
          request_of(
              "cardan.urdf",
              "<robot name='cardan'><link name='world'/><link name='one'><inertial><mass value='1'/><inertia ixx='1' "
              "iyy='1' "
              "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><link name='two'><inertial><mass value='1'/><inertia "
              "ixx='1' "
              "iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
              "<joint name='z1' type='continuous'><parent link='world'/><child link='one'/><axis xyz='1 0 0'/></joint>"
              "<joint name='z2' type='continuous'><parent link='world'/><child link='two'/><axis xyz='0.8 0.6 "
              "0'/></joint>"
              "<constraint name='cross' type='universal'><parent link='one'/><parent_axis xyz='0 1 0'/>"
              "<child link='two'/><child_axis xyz='0 0 1'/></constraint></robot>"))
          .json);
  const std::vector<GenericState> states = random_states(m, 5, 0.8);
  ASSERT_EQ(states.size(), 5u);
  for (const GenericState& state : states)
    EXPECT_NEAR(std::tan(state.z[index_of(m, "z1")]), 0.8 * std::tan(state.z[index_of(m, "z2")]), 1e-9);
}

/// The far eye of the coupler is turned by 3 mrad about x: tilted, the axis of the tip would hold the planar loop.
TEST(ImportClosing, AnAxisThatIsHardlyTiltedBecomesParallel) {
  std::string text = content_of(source_path("tests/import/two_parents.urdf")).value();
  const std::string eye = "<origin xyz=\"0.3 0 0\"/><parent link=\"coupler\"/>";
  text.replace(text.find(eye), eye.size(), "<origin xyz=\"0.3 0 0\" rpy=\"0.003 0 0\"/><parent link=\"coupler\"/>");
  ImportRequest request = request_of("tilted.urdf", text);
  request.loops = content_of(source_path("tests/import/two_parents_loops.json")).value();
  const ImportedModel model = imported_text(request);
  EXPECT_TRUE(has_note(model, "axis of joint \"tip\" is turned by 0.003 rad, parallel to all other axes"));
  const Mechanism m = mechanism_of(model.json);
  EXPECT_EQ(free_coordinates(m.topology, m.analysis).size(), 1u);
}

}  // namespace
}  // namespace mbgen
