// Files: large, deep, empty, missing, byte order marks, includes and how they merge.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

using Files = ModelFiles;

TEST_F(Files, MissingFileAndDirectoryAreNamed) {
  EXPECT_EQ(to_text(read_model_file("no/such.json").problems()), "no/such.json: cannot read file, it does not exist\n");
  EXPECT_EQ(to_text(read_model_file("/").problems()), "/: cannot read file, it is a directory\n");
}

TEST_F(Files, LargerThan64MegabytesIsRefused) {
  const std::string blanks((std::size_t{64} << 20) + 1, ' ');
  const std::string path = write("large.json", blanks);
  EXPECT_EQ(to_text(read_model_file(path).problems()), path + ": file is larger than 64 MB\n");
  EXPECT_EQ(messages(blanks), "test.json:1:1: file is larger than 64 MB, it has 67108865 bytes\n");
}

TEST_F(Files, BlanksUpToTheLimitAreAnEmptyFile) {
  EXPECT_EQ(messages(std::string(std::size_t{64} << 20, ' ')).substr(0, 31), "test.json:1:1: file is empty\n  ");
}

TEST_F(Files, MoreValuesThanMemoryIsMeantForIsRefused) {
  std::string text = "{ \"mbgen\": 1, \"gravity\": [0";
  for (int i = 0; i < 2'100'000; ++i) text += ",0";
  EXPECT_EQ(messages(text + "] }"), "test.json:1:4000021: file has more than 2000000 values\n");
}

TEST_F(Files, AnyDepthIsADiagnosticAndNoOverflow) {
  const std::string arrays(5'000'000, '[');
  EXPECT_EQ(messages(arrays), "test.json:1:65: nested deeper than 64 levels\n");
  std::string objects;
  for (int i = 0; i < 1'000'000; ++i) objects += "{\"a\":";
  EXPECT_EQ(messages(objects), "test.json:1:321: nested deeper than 64 levels\n");
}

TEST_F(Files, DepthAtTheLimitIsRead) {
  const std::string text =
      "{ \"mbgen\": 1, \"bodies\": {}, \"x\": " + std::string(63, '[') + std::string(63, ']') + " }";
  EXPECT_NE(messages(text).find("unknown key \"x\""), std::string::npos);
  EXPECT_EQ(messages(text).find("nested"), std::string::npos);
}

TEST_F(Files, ByteOrderMarkIsSkippedAndDoesNotCount) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + arm_model("")).bodies.size(), 2u);
  EXPECT_EQ(messages("\xEF\xBB\xBF{ \"x\": 1 }").substr(0, 37), "test.json:1:1: key \"mbgen\" is missing");
}

TEST_F(Files, CommentsAndWindowsLinesAreRead) {
  EXPECT_EQ(read("// one\r\n/* two\r\n * , : { */ " + arm_model("")).bodies.size(), 2u);
  const std::string text = "{\r\n  \"mbgen\": 1, // , \"x\": 1\r\n  /* \" */ \"bodys\": {}\r\n}";
  EXPECT_EQ(messages(text).substr(0, 42), "test.json:1:1: model has no bodies\n  {\n  ^");
  EXPECT_NE(messages(text).find(
                "test.json:3:11: /bodys: unknown key \"bodys\"\n    /* \" */ \"bodys\": {}\n            ^~~~~~~\n"),
            std::string::npos);
}

TEST_F(Files, EscapedKeysGiveAPointer) {
  const std::string text = messages("{ \"mbgen\": 1, \"bodies\": {}, \"a/b~c\": 1 }");
  EXPECT_EQ(text.substr(0, text.find('\n')), "test.json:1:29: /a~1b~0c: unknown key \"a/b~c\"");
}

TEST_F(Files, FilesThatWereReadAreListedOnce) {
  fs::create_directories(directory_ / "parts");
  write("parts/deep.json", R"({ "mbgen": 1, "gravity": [0, 0, -1] })");
  write("parts/first.json", R"({ "mbgen": 1, "include": ["deep.json"] })");
  write("second.json", R"({ "mbgen": 1, "include": ["parts/../parts/deep.json"] })");
  std::string text = arm_model("");
  text.insert(text.find('{') + 1, R"("include": ["parts/first.json", "second.json"],)");
  const std::string path = write("arm.json", text);
  const auto in_directory = [&](const char* name) { return (directory_ / name).string(); };
  EXPECT_EQ(read_file(path).files,
            (std::vector<std::string>{path, in_directory("parts/first.json"), in_directory("parts/deep.json"),
                                      in_directory("second.json")}));
  EXPECT_EQ(read(arm_model("")).files, std::vector<std::string>{"test.json"});
}

TEST_F(Files, IncludesMergeInOrderAndTheIncludingFileWins) {
  write("first.json", R"({ "mbgen": 1, "name": "other", "gravity": [0, 0, -1], "parameters": { "k": 2 },
    "bodies": { "ground": { "points": { "G": [1, 2, 3] } },
                "arm": { "mass": "k", "inertia": [1, 1, 1], "points": { "A": [1, 2, 3] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.G", "to": "arm.A", "axis": "z" } },
    "initial": { "equilibrium": true, "positions": { "pin": 1 }, "velocities": { "pin": 5 } },
    "solver": { "step": 0.25, "duration": 4 } })");
  const std::string path = write("second.json", R"({ "mbgen": 1, "include": ["first.json"],
    "gravity": [0, 0, -2], "parameters": { "k2": "10*k" },
    "bodies": { "ground": { "points": { "H": [0, 0, 0] } }, "arm": { "points": { "B": ["k2", 0, 0] } } },
    "forces": { "push": { "at": "arm.B", "force": [1, 0, 0] } },
    "initial": { "positions": { "pin": 3 } }, "solver": { "step": 0.5 } })");
  const Model model = read_file(path);
  EXPECT_EQ(model.name, "second");
  EXPECT_EQ(model.gravity[2].value, -2);
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.bodies[1].name, "arm");
  EXPECT_EQ(model.bodies[1].mass.value, 2);
  ASSERT_EQ(model.bodies[1].points.size(), 2u);
  EXPECT_EQ(model.bodies[1].points[1].name, "B");
  EXPECT_EQ(model.bodies[1].points[1].position[0].value, 20);
  EXPECT_EQ(model.bodies[0].points.size(), 2u);
  EXPECT_TRUE(model.initial.equilibrium);
  ASSERT_EQ(model.initial.positions.size(), 1u);
  EXPECT_EQ(model.initial.positions[0].value, 3);
  EXPECT_EQ(model.initial.velocities[0].value, 5);
  EXPECT_EQ(model.solver.step, 0.5);
  EXPECT_EQ(model.solver.duration, 4);
  EXPECT_EQ(model.bodies[1].where.file, (directory_ / "first.json").string());
  EXPECT_EQ(model.bodies[1].where.pointer, "/bodies/arm");
}

TEST_F(Files, AFileIncludedTwiceCountsOnce) {
  write("base.json", R"({ "bodies": { "arm": { "points": { "A": [0, 0, 0] } } } })");
  write("left.json", R"({ "include": ["base.json"] })");
  write("right.json", R"({ "include": ["base.json"] })");
  EXPECT_EQ(read_file(write("top.json", R"({ "mbgen": 1, "include": ["left.json", "right.json"] })")).bodies.size(),
            1u);
}

/// A body with two springs to the ground, and a file that includes it.
const char* const kSprung = R"({ "mbgen": 1, "gravity": [0, 0, 0],
  "bodies": { "ground": { "points": { "a": [0, 0, 0], "b": [1, 0, 1], "c": [0, 0, 1] } },
              "block": { "mass": 2, "inertia": [1, 1, 1], "points": { "p": [0, 0, 0], "q": [1, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.a", "to": "block.p", "axis": "z" } },
  "springs": { "front": { "from": "ground.c", "to": "block.p", "stiffness": 50,
                          "damping": { "table": [[-2, -1], [-1, -1], [0, 0], [1, 3], [2, 3]] } },
               "back": { "from": "ground.b", "to": "block.q", "stiffness": 100, "damping": 7 } },
  "outputs": { "z": { "unit": "m", "expression": "z.slide" } } })";

TEST_F(Files, AnIncludeRemovesItemsAndSections) {
  write("base.json", kSprung);
  const Model model = read_file(write("top.json", R"({ "mbgen": 1, "include": [
    { "file": "base.json", "remove": ["/springs/front", "/outputs", "/springs/back/damping"] }] })"));
  ASSERT_EQ(model.springs.size(), 1u);
  EXPECT_EQ(model.springs[0].name, "back");
  EXPECT_TRUE(model.outputs.empty());
  EXPECT_EQ(model.files.size(), 2u);
  // Items of one array are counted as the file has them.
  const Model thinned = read_file(write("thinned.json", R"({ "mbgen": 1, "include": [{ "file": "base.json",
    "remove": ["/springs/front/damping/table/1", "/springs/front/damping/table/3"] }] })"));
  const Table& table = std::get<Table>(*thinned.springs[0].damping);
  EXPECT_EQ(table.x, (std::vector<double>{-2, 0, 2}));
  EXPECT_EQ(table.y, (std::vector<double>{-1, 0, 3}));
}

TEST_F(Files, AnIncludeReplacesItemsAndSections) {
  write("base.json", kSprung);
  const std::string path = write("top.json", R"({ "mbgen": 1, "include": [{ "file": "base.json", "replace": {
    "/springs/back": { "from": "ground.b", "to": "block.q", "stiffness": 300 },
    "/bodies/block/mass": 5, "/outputs": { "v": { "unit": "m/s", "expression": "zd.slide" } } } }] })");
  const Model model = read_file(path);
  ASSERT_EQ(model.springs.size(), 2u);
  EXPECT_EQ(model.springs[1].name, "back");
  EXPECT_EQ(model.bodies[1].mass.value, 5);
  ASSERT_EQ(model.outputs.size(), 1u);
  EXPECT_EQ(model.outputs[0].name, "v");
  EXPECT_EQ(model.outputs[0].where.file, path);
  EXPECT_EQ(model.bodies[1].where.file, (directory_ / "base.json").string());
}

TEST_F(Files, ChangesReachTheFilesThatAFileIncludes) {
  write("base.json", kSprung);
  write("middle.json",
        R"({ "mbgen": 1, "include": [{ "file": "base.json", "replace": { "/bodies/block/mass": 5 } }] })");
  const Model model = read_file(write("top.json", R"({ "mbgen": 1, "include": [
    { "file": "middle.json", "remove": ["/springs/front"], "replace": { "/bodies/block/mass": 9 } }] })"));
  EXPECT_EQ(model.springs.size(), 1u);
  EXPECT_EQ(model.bodies[1].mass.value, 9);  // the outer file wins
  // "/include" names the list of files itself.
  const Result<Model> alone = read_model_file(
      write("alone.json", R"({ "mbgen": 1, "include": [{ "file": "middle.json", "remove": ["/include"] }] })"));
  EXPECT_EQ(alone.problems()[0].message, "model has no bodies");
}

TEST_F(Files, ChangesAreThoseOfOneInclude) {
  write("base.json", kSprung);
  const Model model = read_file(write("top.json", R"({ "mbgen": 1,
    "include": [{ "file": "base.json", "remove": ["/springs/front", "/outputs"] }],
    "instances": { "other": { "file": "base.json" } } })"));
  ASSERT_EQ(model.springs.size(), 3u);  // one here, two in the instance
  EXPECT_EQ(model.outputs.size(), 1u);
}

TEST_F(Files, ALongChainOfIncludesIsADiagnostic) {
  for (int i = 0; i < 100; ++i) {
    write(fmt::format("f{}.json", i), fmt::format(R"({{ "mbgen": 1, "include": ["f{}.json"] }})", i + 1));
  }
  const std::string text = to_text(read_model_file((directory_ / "f0.json").string()).problems());
  EXPECT_NE(text.find("includes are nested deeper than 32 files"), std::string::npos) << text;
}

TEST_F(Files, HashIsFnv1aOfAllTexts) {
  // FNV-1a, 64 bits, of the two texts below: computed with an independent implementation.
  const std::string included = R"({"bodies":{"a":{}}})";
  write("inner.json", included);
  const std::string outer = R"({"mbgen":1,"include":["inner.json"]})";
  const Model model = read_file(write("outer.json", outer));
  EXPECT_EQ(model.hash, "2d403a6bcfbfea84");
  EXPECT_NE(read(arm_model("")).hash, read(arm_model("") + " ").hash);
}

TEST_F(Files, NameComesFromTheFileWhenAbsent) {
  EXPECT_EQ(read_file(write("my model-2.json", arm_model(""))).name, "my_model_2");
  EXPECT_EQ(read_file(write("2.json", arm_model(""))).name, "model");
  EXPECT_EQ(read(arm_model("\"name\": \"four_bar\"")).name, "four_bar");
}

TEST_F(Files, InstancesThatMultiplyAreBounded) {
  constexpr int kDepth = 20;  // a million bodies
  write("d0.json", R"({ "bodies": { "b": {} } })");
  for (int i = 1; i <= kDepth; ++i) {
    write(fmt::format("d{}.json", i),
          fmt::format(R"({{ "mbgen": 1, "instances": {{ "a": {{ "file": "d{0}.json", "prefix": "a" }},
                            "b": {{ "file": "d{0}.json", "prefix": "b" }} }} }})",
                      i - 1));
  }
  const Result<Model> result = read_model_file((directory_ / "d20.json").string());
  ASSERT_FALSE(result);
  EXPECT_NE(to_text(result.problems()).find("model has more than 10000 instances"), std::string::npos);
}

TEST_F(Files, InstancesOfLargeFilesAreBounded) {
  write("large.json", R"({ "bodies": { "b": {} } } //)" + std::string(std::size_t{1} << 20, ' '));
  std::string instances;
  for (int i = 0; i < 80; ++i) instances += fmt::format("{}\"i{}\": {{ \"file\": \"large.json\" }}", i ? ", " : "", i);
  const std::string path = write("all.json", "{ \"mbgen\": 1, \"instances\": { " + instances + " } }");
  const Result<Model> result = read_model_file(path);
  ASSERT_FALSE(result);
  EXPECT_NE(to_text(result.problems()).find("files of the model have more than 64 MB, each instance counted"),
            std::string::npos);
}

TEST_F(Files, InstancesNestAndAreFilesOfTheModel) {
  const std::string leg = write("leg.json", R"({ "parameters": { "mass": 1, "length": "2*mass" },
    "bodies": { "ground": { "points": { "pin": [0, 1, 0] } },
                "leg": { "mass": "mass", "inertia": [9, 9, "length"], "points": { "pin": [0, 1, 0] } } },
    "joints": { "leg": { "type": "revolute", "from": "ground.pin", "to": "leg.pin", "axis": "x" } },
    "outputs": { "angle": { "joint": "leg" } } })");
  const std::string pair = write("pair.json", R"({ "parameters": { "mass": 5 }, "instances": {
    "left": { "file": "leg.json", "suffix": "_left", "parameters": { "mass": "mass + 1" } },
    "right": { "file": "leg.json", "suffix": "_right", "mirror": "xz" } } })");
  const std::string path = write("walker.json", R"({ "mbgen": 1, "instances": {
    "front": { "file": "pair.json", "offset": [1, 0, 0] },
    "rear": { "file": "pair.json", "parameters": { "mass": 7 }, "rotation": { "axis": "z", "angle": { "deg": 180 } } } } })");
  const Model model = read_file(path);
  EXPECT_EQ(model.files, (std::vector<std::string>{path, pair, leg}));
  ASSERT_EQ(model.joints.size(), 4u);
  EXPECT_EQ(model.joints[0].name, "front_leg_left");
  EXPECT_EQ(model.joints[3].freedoms[0].name, "rear_leg_right");
  EXPECT_EQ(model.joints[1].freedoms[0].axis, (Vector3{-1, 0, 0}));
  EXPECT_EQ(model.joints[2].freedoms[0].axis, (Vector3{-1, 0, 0}));
  EXPECT_EQ(model.joints[3].freedoms[0].axis, (Vector3{1, 0, 0}));
  ASSERT_EQ(model.bodies.size(), 5u);
  const Body& front_left = model.bodies[0];
  EXPECT_EQ(front_left.name, "front_leg_left");
  EXPECT_EQ(front_left.mass.value, 6);
  EXPECT_EQ(front_left.inertia[2].value, 12);
  EXPECT_EQ(front_left.pose.origin, (Vector3{1, 0, 0}));
  EXPECT_EQ(model.bodies[1].mass.value, 1);
  EXPECT_EQ(model.bodies[1].points[0].position[1].value, -1);
  EXPECT_EQ(model.bodies[2].mass.value, 8);
  const Body& ground = model.bodies[static_cast<std::size_t>(model.ground)];
  ASSERT_EQ(ground.points.size(), 4u);
  EXPECT_EQ(ground.points[2].name, "rear_pin_left");
  EXPECT_EQ(ground.points[2].position[1].value, -1);
  EXPECT_EQ(model.outputs[1].name, "front_angle_right");
}

// An instance may say of the bodies of those that it places what a model may say: where more of their points are.
TEST_F(Files, AnInstanceAddsPointsToBodiesOfThoseInside) {
  write("leg.json", R"({ "bodies": { "ground": { "points": { "pin": [0, 1, 0] } },
                                     "leg": { "mass": 1, "inertia": [1, 1, 1], "points": { "pin": [0, 1, 0] } } },
    "joints": { "leg": { "type": "revolute", "from": "ground.pin", "to": "leg.pin", "axis": "x" } } })");
  write("pair.json", R"({ "bodies": { "leg_left": { "points": { "toe": [0.2, 1, -1] } } }, "instances": {
    "left": { "file": "leg.json", "suffix": "_left" },
    "right": { "file": "leg.json", "suffix": "_right", "mirror": "xz" } } })");
  const Model model = read_file(write("walker.json", R"({ "mbgen": 1, "instances": {
    "pair": { "file": "pair.json", "prefix": "", "offset": [3, 0, 0], "mirror": "xz" } } })"));
  ASSERT_EQ(model.bodies.size(), 3u);
  const Body &left = model.bodies[0], &right = model.bodies[1];
  EXPECT_EQ(left.name, "leg_left");
  EXPECT_EQ(left.mass.value, 1);
  ASSERT_EQ(left.points.size(), 2u);
  EXPECT_EQ(left.points[1].name, "toe");
  EXPECT_DOUBLE_EQ(left.points[1].position[0].value, 0.2);  // the frame of the leg moves along
  EXPECT_EQ(left.points[1].position[1].value, -1);
  EXPECT_EQ(right.points.size(), 1u);
}

// The names of a wheel and its brake do not depend on the number of their instances.
TEST_F(Files, InstancesOfTheSameSuffixHaveOneSetOfNames) {
  write("wheel.json", R"({ "parameters": { "mass": 3 },
    "bodies": { "ground": { "points": { "hub": [0, 1, 0] } },
                "wheel": { "mass": "mass", "inertia": [1, 1, 1], "points": { "hub": [0, 1, 0] } } },
    "joints": { "wheel": { "type": "cylindrical", "from": "ground.hub", "to": "wheel.hub", "axis": "y" } } })");
  write("brake.json", R"({ "joint_forces": { "brake": { "joint": "wheel_ry", "force": "-mass*zd.wheel_ty" } },
    "outputs": { "turn": { "joint": "wheel_ry" } } })");
  const Model model = read_file(write("car.json", R"({ "mbgen": 1, "instances": {
    "left": { "file": "wheel.json", "suffix": "_left" },
    "right": { "file": "wheel.json", "suffix": "_right", "mirror": "xz", "parameters": { "mass": 4 } },
    "brake_right": { "file": "brake.json", "suffix": "_right" },
    "brake_left": { "file": "brake.json", "suffix": "_left" } } })"));
  ASSERT_EQ(model.joint_forces.size(), 2u);
  EXPECT_EQ(model.joint_forces[0].name, "brake_right");
  EXPECT_EQ(model.joint_forces[0].joint.joint, 1);
  EXPECT_EQ(model.joint_forces[1].joint.joint, 0);
  ASSERT_EQ(model.outputs.size(), 2u);
  EXPECT_EQ(model.outputs[1].name, "turn_left");
}

TEST_F(Files, TablesOfCsvFilesAreThoseTypedIn) {
  const std::string csv = write(
      "damper.csv", "\xEF\xBB\xBF# rig\r\n\"v [m/s]\", spare ,force [N]\r\n-1,0,+9.5e3\r\n\r\n 0.5 ,1, \"2\" \r\n");
  const auto with_table = [](const std::string& table) {
    return arm_model("\"springs\": { \"s\": { \"from\": \"ground.T\", \"to\": \"arm.B\", \"damping\": " + table +
                     " } }");
  };
  const std::string path = write("model.json", with_table(R"({ "csv": "damper.csv", "x": "v", "y": "force [N]" })"));
  const Model from_file = read_file(path), typed = read(with_table(R"({ "table": [[-1, 9500], [0.5, 2]] })"));
  ASSERT_EQ(from_file.springs.size(), 1u);
  EXPECT_EQ(from_file.files, (std::vector<std::string>{path, csv}));
  const Table &one = std::get<Table>(*from_file.springs[0].damping),
              &other = std::get<Table>(*typed.springs[0].damping);
  EXPECT_EQ(one.x, other.x);
  EXPECT_EQ(one.y, other.y);
  write("damper.csv", "v,force [N]\n0,0\n1,1\n");
  EXPECT_NE(read_file(path).hash, from_file.hash);
}

}  // namespace
}  // namespace mbgen
