// Hardpoints and axes by points, against the same models in numbers, and the tables of names that documents show.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/named_functions.hpp"
#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen::hardpoints_test {
namespace {

constexpr double kRounding = 2e-15;  // a few operations on numbers of order 1

void expect_near(const Vector3& actual, const Vector3& expected, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], kRounding) << what << ", component " << i;
}

const Body& body_of(const Model& model, const std::string& name) {
  for (const Body& body : model.bodies) {
    if (body.name == name) return body;
  }
  throw std::runtime_error("no body " + name);
}

Vector3 values(const Vector3Quantity& vector) { return {vector[0].value, vector[1].value, vector[2].value}; }

Vector3 point_of(const Model& model, const std::string& body, const std::string& point) {
  for (const Point& one : body_of(model, body).points) {
    if (one.name == point) return values(one.position);
  }
  throw std::runtime_error("body " + body + " has no point " + point);
}

/// Global place of the centre of mass at the reference.
Vector3 centre_of(const Model& model, const std::string& name) {
  const Body& body = body_of(model, name);
  const auto& r = body.pose.rotation;
  const Vector3 c = values(body.com);
  Vector3 at = body.pose.origin;
  for (std::size_t i = 0; i < 9; ++i) at[i / 3] += r[i] * c[i % 3];
  return at;
}

/// An arm whose frame is moved and turned, on a pin in ground.
std::string posed_arm(const std::string& rotation, const std::string& joint = R"("type": "revolute", "axis": "y")") {
  return fmt::format(R"({{ "mbgen": 1,
    "hardpoints": {{ "pin": [0.41, -0.2, 0.3], "tip": [1.4, 0.25, 0.3], "middle": [0.9, 0, 0.3] }},
    "bodies": {{ "ground": {{ "points": {{ "origin": [0, 0, 0] }} }},
      "arm": {{ "pose": {{ "origin": [0.4, -0.2, 0.1], "rotation": {} }}, "mass": 2, "com": "middle",
                "inertia": [1, 1, 1], "points": {{ "end": "tip" }} }} }},
    "joints": {{ "pin": {{ "from": "ground.pin", "to": "arm.pin", {} }} }},
    "springs": {{ "rope": {{ "from": "ground.origin", "to": "arm.end", "stiffness": 5 }} }},
    "outputs": {{ "tip": {{ "point": "arm.tip", "axis": "x" }} }} }})",
                     rotation, joint);
}

TEST(Hardpoints, AreOnePlaceForEveryBody) {
  for (const char* rotation : {"[]", R"({ "axis": "z", "angle": { "deg": 90 } })",
                               R"([{ "axis": "z", "angle": 0.3 }, { "axis": "x", "angle": -1.1 }])"}) {
    const Model model = read(posed_arm(rotation));
    const Joint& pin = model.joints.at(0);
    EXPECT_EQ(reference_position(model, pin.from), (Vector3{0.41, -0.2, 0.3}));
    expect_near(reference_position(model, pin.to), {0.41, -0.2, 0.3}, rotation);
    expect_near(reference_position(model, model.springs.at(0).to), {1.4, 0.25, 0.3}, rotation);
    expect_near(centre_of(model, "arm"), {0.9, 0, 0.3}, rotation);
    EXPECT_EQ(model.bodies[0].points.size(), 2u) << "a body has points where something asks for them";
    EXPECT_EQ(model.bodies[1].points.size(), 3u);
  }
}

// 0.41 - 0.4 is 0.01, and what is no difference is no number: zeros of the equations stay zeros.
TEST(Hardpoints, KeepTheDigitsThatWereTyped) {
  const Model straight = read(posed_arm("[]"));
  EXPECT_EQ(point_of(straight, "arm", "pin"), (Vector3{0.01, 0, 0.2}));
  EXPECT_EQ(values(straight.bodies[1].com), (Vector3{0.5, 0.2, 0.2}));
  const Model quarter = read(posed_arm(R"({ "axis": "z", "angle": { "deg": 90 } })"));
  EXPECT_EQ(point_of(quarter, "arm", "pin"), (Vector3{0, -0.01, 0.2}));
  EXPECT_EQ(point_of(quarter, "arm", "end"), (Vector3{0.45, -1, 0.2}));
}

TEST(Hardpoints, OfParametersMoveWithThem) {
  const Model model = read(R"({ "mbgen": 1,
    "parameters": { "track": { "value": 1.6, "tunable": true }, "rise": 0.25 },
    "hardpoints": { "ball": [0.1, "track/2", "2*rise"] },
    "bodies": { "ground": {}, "arm": { "pose": { "origin": [0.1, 0.3, 0] }, "mass": 1, "inertia": [1, 1, 1] } },
    "joints": { "ball": { "type": "spherical", "from": "ground.ball", "to": "arm.ball" } } })");
  struct Wide {
    double parameter(int) const { return 2; }
    double input(int) const { return 0; }
    double time() const { return 0; }
    double position(const CoordinateReference&) const { return 0; }
    double velocity(const CoordinateReference&) const { return 0; }
    double local(int) const { return 0; }
  };
  const Vector3Quantity& on_ground = model.bodies[0].points.at(0).position;
  const Vector3Quantity& on_arm = model.bodies[1].points.at(0).position;
  EXPECT_DOUBLE_EQ(on_arm[1].value, 0.5);
  EXPECT_DOUBLE_EQ(evaluate<double>(on_ground[1], model.expressions, Wide{}), 1);
  EXPECT_DOUBLE_EQ(evaluate<double>(on_arm[1], model.expressions, Wide{}), 0.7);
  EXPECT_EQ(on_arm[2].value, 0.5);
  EXPECT_LT(on_arm[2].expression, 0) << "what is constant stays a number";
}

using PlacedHardpoints = ModelFiles;

/// An arm of a suspension, in hardpoints or in numbers; its hinge is skew, its frame turned.
std::string arm(bool in_hardpoints) {
  const auto one = [&](const char* words, const char* numbers) { return std::string(in_hardpoints ? words : numbers); };
  return one(R"({ "hardpoints": { "rear": [-0.15, 0.35, 0.2], "front": [0.15, 0.35, 0.6], "ball": [0, 0.7, 0.2] },)",
             "{") +
         R"("bodies": { "chassis": { "points": {)" + one("", R"("rear": [-0.15, 0.35, 0.2], "ball": [0, 0.7, 0.2])") +
         R"(} }, "arm": { "pose": { "origin": [0.1, 0.3, 0.2], "rotation": { "axis": "y", "angle": { "deg": 90 } } },
               "mass": 1, "inertia": [1, 1, 1], "com": )" +
         one(R"("ball")", "[0, 0.4, -0.1]") +
         one("", R"(, "points": { "rear": [0, 0.05, -0.25], "ball": [0, 0.4, -0.1] })") + R"( } },
    "joints": { "arm": { "type": "cylindrical", "from": "chassis.rear", "to": "arm.rear", "axis": )" +
         one(R"({ "from": "rear", "to": "front" })", "[0.6, 0, 0.8]") + R"(, "axis_to": )" +
         one(R"({ "from": "chassis.rear", "to": [0.15, 0.35, 0.6] })", "[-0.8, 0, 0.6]") + R"( } },
    "rods": { "stop": { "from": "arm.ball", "to": "chassis.rear", "length": 1 } } })";
}

// Whatever an instance does to points in numbers it does to hardpoints.
TEST_F(PlacedHardpoints, AreWhereTheNumbersOfTheInstanceAre) {
  write("words.json", arm(true));
  write("numbers.json", arm(false));
  for (const char* placing :
       {"", R"(, "mirror": "xz")", R"(, "mirror": "xz", "coordinates": "parallel")",
        R"(, "offset": [1, 2, 3], "mirror": "yz", "rotation": { "axis": [1, 2, 3], "angle": 0.7 })"}) {
    const auto read_as = [&](const std::string& file) {
      return read_file(
          write("car.json", fmt::format(R"({{ "mbgen": 1, "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0] }} }},
        "car": {{ "points": {{ "O": [0, 0, -0.5] }},
                  "pose": {{ "origin": [0, 0, 0.5], "rotation": {{ "axis": "z", "angle": 0.4 }} }} }} }},
      "joints": {{ "car": {{ "type": "free", "from": "ground.O", "to": "car.O" }} }},
      "instances": {{ "left": {{ "file": "{}", "connect": {{ "chassis": "car" }} {} }} }},
      "outputs": {{ "ball": {{ "point": "left_arm.ball", "axis": "x" }},
                     "on_car": {{ "point": "car.left_ball", "axis": "x" }} }} }})",
                                        file, placing)));
    };
    const Model words = read_as("words.json"), numbers = read_as("numbers.json");
    ASSERT_EQ(words.joints.size(), 2u);
    const Joint &a = words.joints[1], &b = numbers.joints[1];
    ASSERT_EQ(a.freedoms.size(), b.freedoms.size());
    for (std::size_t i = 0; i < a.freedoms.size(); ++i) {
      EXPECT_EQ(a.freedoms[i].name, b.freedoms[i].name);
      expect_near(a.freedoms[i].axis, b.freedoms[i].axis, placing);
    }
    expect_near(reference_position(words, a.from), reference_position(numbers, b.from), placing);
    expect_near(reference_position(words, a.to), reference_position(numbers, b.to), placing);
    expect_near(reference_position(words, words.rods[0].to), reference_position(numbers, numbers.rods[0].to), placing);
    expect_near(centre_of(words, "left_arm"), centre_of(numbers, "left_arm"), placing);
    expect_near(point_of(words, "left_arm", "ball"), point_of(numbers, "left_arm", "ball"), placing);
    expect_near(point_of(words, "car", "left_ball"), point_of(numbers, "car", "left_ball"), placing);
  }
}

// A hardpoint of the vehicle is one place, whoever names it; a name of the subsystem's own comes before it.
TEST_F(PlacedHardpoints, OfTheModelAreSeenInside) {
  write("leg.json", R"({ "hardpoints": { "knee": [0, 1, 2] },
    "bodies": { "ground": {}, "leg": { "mass": 1, "inertia": [1, 1, 1] } },
    "joints": { "leg": { "type": "spherical", "from": "ground.hip", "to": "leg.hip" } },
    "outputs": { "knee": { "point": "leg.knee", "axis": "x" } } })");
  const Model model = read_file(write("robot.json", R"({ "mbgen": 1,
    "hardpoints": { "hip": [0.5, 0.25, 1], "knee": [9, 9, 9], "mount": [0, 0, 3] },
    "instances": { "left": { "file": "leg.json", "mirror": "xz", "offset": "mount",
                             "rotation": { "axis": { "from": "mount", "to": [0, 5, 3] }, "angle": { "deg": 90 } } } },
    "outputs": { "inner": { "point": "left_leg.knee", "axis": "y" } } })"));
  ASSERT_EQ(model.joints.size(), 1u);
  expect_near(reference_position(model, model.joints[0].from), {0.5, 0.25, 1}, "on ground");
  expect_near(reference_position(model, model.joints[0].to), {0.5, 0.25, 1}, "on the leg");
  const Body& leg = body_of(model, "left_leg");
  ASSERT_EQ(leg.points.size(), 2u) << "both outputs are of one point";
  // The mirror makes (0, -1, 2) of the knee, the quarter turn about y (2, -1, 0), the offset (2, -1, 3).
  expect_near(reference_position(model, {0, 1}), {2, -1, 3}, "knee");
  ASSERT_EQ(model.hardpoints.size(), 4u);
  EXPECT_EQ(model.hardpoints[3].name, "left_knee");
  expect_near(values(model.hardpoints[3].position), {2, -1, 3}, "left_knee");
}

// One mechanism, and a table of hardpoints for each axle, which includes it.
TEST_F(PlacedHardpoints, OfAnIncludingFileServeTheIncludedOne) {
  write("corner.json", R"({ "bodies": { "ground": {}, "arm": { "mass": 1, "inertia": [1, 1, 1], "com": "ball" } },
    "joints": { "arm": { "type": "revolute", "from": "ground.rear", "to": "arm.rear",
                         "axis": { "from": "rear", "to": "front" } } } })");
  write("front.json", R"({ "include": ["corner.json"],
    "hardpoints": { "rear": [1, 0.3, 0.2], "front": [1.5, 0.3, 0.2], "ball": [1.2, 0.7, 0.2] } })");
  write("back.json", R"({ "include": ["corner.json"],
    "hardpoints": { "rear": [-2, 0.3, 0.2], "front": [-2, 0.3, 1.2], "ball": [-2, 0.8, 0.2] } })");
  const Model model = read_file(write("car.json", R"({ "mbgen": 1, "instances": {
    "fl": { "file": "front.json" }, "fr": { "file": "front.json", "mirror": "xz" },
    "bl": { "file": "back.json" } } })"));
  ASSERT_EQ(model.joints.size(), 3u);
  EXPECT_EQ(centre_of(model, "fl_arm"), (Vector3{1.2, 0.7, 0.2}));
  EXPECT_EQ(centre_of(model, "fr_arm"), (Vector3{1.2, -0.7, 0.2}));
  EXPECT_EQ(centre_of(model, "bl_arm"), (Vector3{-2, 0.8, 0.2}));
  EXPECT_EQ(model.joints[0].axis, (Vector3{1, 0, 0}));
  EXPECT_EQ(model.joints[1].axis, (Vector3{-1, 0, 0}));  // equal coordinates are mirrored motions
  EXPECT_EQ(model.joints[2].axis, (Vector3{0, 0, 1}));
}

TEST(AxesByPoints, AreUnitVectorsInTheFrameOfTheBody) {
  const auto freedoms = [](const std::string& rotation, const std::string& joint) {
    return read(posed_arm(rotation, joint)).joints.at(0).freedoms;
  };
  const auto along = freedoms("[]", R"("type": "revolute", "axis": { "from": "pin", "to": [0.41, -0.2, 7] })");
  EXPECT_EQ(along.at(0).axis, (Vector3{0, 0, 1}));
  const auto skew = freedoms("[]", R"("type": "prismatic", "axis": { "from": [1, 1, 1], "to": [1, 4, 5] })");
  expect_near(skew.at(0).axis, {0, 0.6, 0.8}, "3, 4, 5");
  const auto short_one =
      freedoms("[]", R"("type": "prismatic", "axis": { "from": [0.4, 0, 0.1], "to": [0.41, 0, 0.11] })");
  EXPECT_EQ(short_one.at(0).axis[0], short_one.at(0).axis[2]) << "as 0.01 and 0.01";
}

// An axis along an axis of a turned frame gets its letter, though turning there and back leaves a rest.
TEST(AxesByPoints, AlongAnAxisOfATurnedFrameHaveItsLetter) {
  for (int i = 1; i <= 20; ++i) {
    const double about_z = 0.3 * i, about_x = -1.1 * i;
    const Model model = read(fmt::format(R"({{ "mbgen": 1, "hardpoints": {{ "hub": [0.3, 0.2, 0.1] }},
    "bodies": {{ "ground": {{}}, "arm": {{ "mass": 1, "inertia": [1, 1, 1] }},
      "base": {{ "points": {{ "out": [0, 0.7, 0] }},
        "pose": {{ "rotation": [{{ "axis": "z", "angle": {} }}, {{ "axis": "x", "angle": {} }}] }} }} }},
    "joints": {{ "base": {{ "type": "fixed", "from": "ground.hub", "to": "base.hub" }},
      "arm": {{ "type": "cylindrical", "from": "base.hub", "to": "arm.hub",
               "axis": {{ "from": [0, 0, 0], "to": "base.out" }} }} }} }})",
                                         about_z, about_x));
    ASSERT_EQ(model.joints.size(), 2u);
    EXPECT_EQ(model.joints[1].freedoms[0].name, "arm_ty") << i;
    expect_near(model.joints[1].freedoms[0].axis,
                {-std::sin(about_z) * std::cos(about_x), std::cos(about_z) * std::cos(about_x), std::sin(about_x)},
                "y of the turned base");
  }
}

TEST(AxesByPoints, TurnAboutTheLineWhereverItStandsInTheList) {
  const Model model = read(R"({ "mbgen": 1, "hardpoints": { "a": [1, 1, 0], "b": [1, 1, 9] },
    "bodies": { "ground": { "points": { "O": "a" } }, "one": { "mass": 1, "inertia": [1, 1, 1],
      "pose": { "rotation": [{ "axis": "x", "angle": 0.4 }, { "axis": { "from": "a", "to": "b" }, "angle": 0.5 }] } } },
    "joints": { "one": { "type": "fixed", "from": "ground.a", "to": "one.a" } } })");
  // First about x, then about the line, which stays upright.
  const double c = std::cos(0.5), s = std::sin(0.5), d = std::cos(0.4), e = std::sin(0.4);
  const Matrix3 expected = {c, -s * d, s * e, s, c * d, -c * e, 0, e, d};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(model.bodies.at(1).pose.rotation[i], expected[i], kRounding) << i;
}

TEST(AxesByPoints, TurnTyresAndWheelsAlike) {
  const Model model = read(R"({ "mbgen": 1, "hardpoints": { "hub": [0, 0.75, 0.31], "cap": [0, 0.95, 0.31] },
    "bodies": { "ground": {}, "wheel": { "mass": 18, "com": "hub", "inertia": [0.6, 0.6, 0.6],
      "pose": { "origin": "hub", "rotation": { "axis": "x", "angle": 0.3 } } } },
    "joints": { "wheel": { "type": "revolute", "from": "ground.hub", "to": "wheel.hub",
                           "axis": { "from": "hub", "to": "wheel.cap" }, "axis_to": { "from": "hub", "to": "cap" } } },
    "tyre_data": { "d": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.31, "FNOMIN": 4e3,
      "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5,
      "RBX1": 12, "RCX1": 1.1, "RBY1": 8, "RCY1": 1.1 } } },
    "tyres": { "t": { "centre": "wheel.hub", "axis": { "from": "hub", "to": "cap" }, "data": "d",
                     "stiffness": 2e5 } } })");
  ASSERT_EQ(model.tyres.size(), 1u);
  expect_near(model.joints.at(0).axis, {0, 1, 0}, "joint");
  expect_near(model.tyres[0].axis, {0, 1, 0}, "tyre");
  EXPECT_TRUE(model.notes.empty()) << to_text(model.notes);
  EXPECT_EQ(values(model.bodies[1].com), (Vector3{0, 0, 0}));
}

/// A direction of the table in the frame of `from`, which is the global one.
Vector3 direction_of(const std::string& word, const Joint& joint) {
  if (word == "axis") return joint.axis;
  if (word == "axis2") return joint.second_axis;
  if (word == "x" || word == "y" || word == "z")
    return {word == "x" ? 1.0 : 0.0, word == "y" ? 1.0 : 0.0, word == "z" ? 1.0 : 0.0};
  const Vector3& n = joint.axis;
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < 3; ++i) farthest = std::abs(n[i]) < std::abs(n[farthest]) ? i : farthest;
  Vector3 e{};
  e[farthest] = 1;
  const double length = std::sqrt(1 - n[farthest] * n[farthest]), along = n[farthest];
  for (std::size_t i = 0; i < 3; ++i) e[i] = (e[i] - along * n[i]) / length;
  if (word == "e") return e;
  EXPECT_EQ(word, "axis x e");
  return {n[1] * e[2] - n[2] * e[1], n[2] * e[0] - n[0] * e[2], n[0] * e[1] - n[1] * e[0]};
}

std::vector<std::string> parts(std::string_view text) {
  std::vector<std::string> list;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(", ", start), text.size());
    list.emplace_back(text.substr(start, end - start));
    start = end + 2;
  }
  return list;
}

// The table of the model reference says of every type of joint what the reader makes of it.
TEST(JointCoordinates, AreThoseOfTheModelReference) {
  std::set<std::string> types;
  for (const JointCoordinates& row : joint_coordinates()) {
    types.insert(name_of(row.type));
    const bool one_axis = row.type == JointType::revolute || row.type == JointType::prismatic;
    const std::string written = one_axis ? R"("axis": [0.6, 0, 0.8])" : std::string(row.written);
    const Model model =
        read(joint_model(fmt::format("\"type\": \"{}\"{}{}", name_of(row.type), written.empty() ? "" : ", ", written)));
    ASSERT_EQ(model.joints.size(), 1u) << name_of(row.type);
    const Joint& joint = model.joints[0];
    const std::vector<std::string> names = parts(row.names), directions = parts(row.directions);
    ASSERT_EQ(joint.freedoms.size(), names.size()) << name_of(row.type);
    ASSERT_EQ(names.size(), directions.size()) << name_of(row.type);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Freedom& freedom = joint.freedoms[i];
      EXPECT_EQ("NAME" + freedom.name.substr(1), names[i]) << name_of(row.type);
      const std::size_t space = directions[i].find(' ');
      EXPECT_EQ(directions[i].substr(0, space), freedom.kind == FreedomKind::revolute ? "about" : "along");
      expect_near(freedom.axis, direction_of(directions[i].substr(space + 1), joint), names[i]);
    }
  }
  const auto schema = nlohmann::json::parse(model_schema());
  const std::size_t all = schema["$defs"]["joint"]["properties"]["type"]["enum"].size();
  std::size_t without_coordinates = 0;
  for (std::size_t t = 0; t < all; ++t) without_coordinates += closes_only(static_cast<JointType>(t)) ? 1 : 0;
  EXPECT_EQ(types.size() + without_coordinates, all);
}

// The parser knows the functions of the table and no others, and the schema and the message for an unknown one name
// all.
TEST(Functions, OfTheTableAreThoseOfTheParserTheSchemaAndTheMessage) {
  const auto with_mass = [](const std::string& mass) {
    return arm_model(R"("forces": { "f": { "at": "arm.B", "force": [0, 0, ")" + mass + R"("] } })");
  };
  const std::string unknown = messages(with_mass("sinus(t)"));
  const auto schema = nlohmann::json::parse(model_schema());
  const std::string described = schema["$defs"]["expression"]["description"];
  for (const reading::NamedFunction& function : reading::named_functions()) {
    const std::string signature = fmt::format("{}({})", function.name, function.arguments);
    EXPECT_NE(unknown.find(signature), std::string::npos) << unknown;
    EXPECT_NE(described.find(signature), std::string::npos) << described;
    EXPECT_EQ(parts(function.arguments).size(), static_cast<std::size_t>(function.arity)) << function.name;
    std::string call = fmt::format("{}(t", function.name);
    for (int i = 1; i < function.arity; ++i) call += ", 2";
    EXPECT_EQ(messages(with_mass(call + ")")), "");
    EXPECT_NE(messages(with_mass(call + ", 3)")).find("takes"), std::string::npos) << function.name;
  }
  // Every function that can be evaluated has a name, but the four operations and the sign.
  EXPECT_EQ(reading::named_functions().size(), static_cast<std::size_t>(Function::floor) + 1 - 5);
}

}  // namespace
}  // namespace mbgen::hardpoints_test
