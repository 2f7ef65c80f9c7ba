// MJCF: defaults of actuators and joints. All formats: ranges without width.

#include <fmt/format.h>

#include "tests/import/import_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A hinge about y of 1 kg m^2 without gravity.
ImportedModel imported_hinge(const std::string& defaults, const std::string& actuators,
                             const std::string& joint = "<joint name='h' axis='0 1 0'/>") {
  return imported_text(request_of(
      "hinge.xml", fmt::format("<mujoco><compiler angle='radian'/><option gravity='0 0 0'/><default>{}</default>"
                               "<worldbody><body name='b'>{}<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body>"
                               "</worldbody><actuator>{}</actuator></mujoco>",
                               defaults, joint, actuators)));
}

std::string force_of(const std::string& defaults, const std::string& actuator) {
  const ImportedModel model = imported_hinge(defaults, actuator);
  const std::string key = "\"force\": \"";
  const std::size_t start = model.json.find(key);
  return start == std::string::npos
             ? ""
             : model.json.substr(start + key.size(), model.json.find('"', start + key.size()) - start - key.size());
}

TEST(ImportMjcfDefaults, AllKindsOfActuatorsWriteOne) {
  const std::string position = "<position name='p' joint='h'/>", general = "<general name='p' joint='h'/>";
  EXPECT_EQ(force_of("<general gainprm='50' biastype='affine' biasprm='0 -50 -3'/>", position), "50*p - 50*z.h");
  EXPECT_EQ(force_of("<position kp='50'/>", general), "50*p - 50*z.h");
  EXPECT_EQ(force_of("<position kp='50'/>", "<velocity name='p' joint='h'/>"), "50*p - 50*zd.h");
  EXPECT_EQ(force_of("<velocity kv='5'/>", position), "5*p - 5*z.h");
  EXPECT_EQ(force_of("<motor gear='7' ctrllimited='true' ctrlrange='-1 1'/><position kp='50'/>", position),
            "350*min(max(p, -1), 1) - 2450*z.h");
  EXPECT_EQ(force_of("<position kp='50'/><default class='s'><general gear='3'/></default>",
                     "<position class='s' name='p' joint='h'/>"),
            "150*p - 450*z.h");
}

/// MuJoCo 2.2 has no damping of <position>; from MuJoCo 3.2 on it is a default like kp.
TEST(ImportMjcfDefaults, APositionServoKeepsItsOwnDamping) {
  const std::string position = "<position name='p' joint='h'/>";
  EXPECT_EQ(force_of("<position kp='50' kv='4'/>", position), "50*p - 50*z.h - 4*zd.h");
  EXPECT_EQ(force_of("<position kp='50' kv='4'/>", "<position name='p' joint='h' kv='6'/>"), "50*p - 50*z.h - 6*zd.h");
  EXPECT_EQ(force_of("<position kp='4' dampratio='0.5'/>", position), "4*p - 4*z.h - 2*zd.h");
  EXPECT_EQ(force_of("<position kp='50' timeconst='0.1'/>", position), "50*p_filtered - 50*z.h");
  EXPECT_EQ(force_of("<position kp='50' timeconst='0.1'/>", "<motor name='p' joint='h' gear='2'/>"), "");
}

TEST(ImportMjcfDefaults, TellsWhereVersionsOfMujocoDiffer) {
  const std::string note = "MuJoCo 3 keeps them";
  EXPECT_TRUE(has_note(imported_hinge("<velocity kv='5'/>", "<position name='p' joint='h'/>"), note));
  EXPECT_TRUE(
      has_note(imported_hinge("<general dyntype='filter' dynprm='0.1'/>", "<position name='p' joint='h'/>"), note));
  EXPECT_FALSE(has_note(imported_hinge("<velocity kv='5'/>", "<position name='p' joint='h' kv='1'/>"), note));
  EXPECT_FALSE(has_note(imported_hinge("<velocity kv='5'/>", "<motor name='p' joint='h'/>"), note));
}

TEST(ImportMjcf, TellsRangesThatAServoTakesFromItsJoint) {
  EXPECT_TRUE(has_note(imported_hinge("", "<position name='p' joint='h' inheritrange='1'/>"),
                       "inheritrange of <position> is not carried over: the input is not bounded"));
}

TEST(ImportMjcfDefaults, LawsWithoutCounterpartAreToldWhereTheyReachAnActuator) {
  const std::string note = "actuator <general>: it is not carried over";
  EXPECT_TRUE(has_note(imported_hinge("<damper kv='3' ctrlrange='0 1'/>", "<general name='p' joint='h'/>"), note));
  EXPECT_TRUE(has_note(imported_hinge("<muscle force='3'/>",
                                      "<general gaintype='fixed' dyntype='none' biastype='none' "
                                      "name='p' joint='h'/>"),
                       note));
  EXPECT_EQ(force_of("<muscle force='3' gear='2'/>", "<velocity kv='3' name='p' joint='h'/>"), "6*p - 12*zd.h");
  EXPECT_EQ(force_of("<intvelocity kp='3'/>", "<velocity name='p' joint='h'/>"), "3*p - 3*zd.h");
  EXPECT_EQ(force_of("<cylinder area='3' bias='1 2 4' timeconst='0.1'/>", "<general name='p' joint='h'/>"),
            "3*p_filtered + 1 + 2*z.h + 4*zd.h");
}

/// Sections with defaults are one after the other; a class has what stood before it.
TEST(ImportMjcfDefaults, SectionsAddToEachOther) {
  const ImportedModel model = imported_text(
      request_of("sections.xml",
                 "<mujoco><default><joint damping='2'/><default class='s'/></default><default><joint stiffness='3'/>"
                 "</default><worldbody><body><joint name='h'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>"
                 "</body><body><joint name='g' class='s'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body>"
                 "</worldbody></mujoco>"));
  EXPECT_NE(model.json.find("\"joint\": \"h\", \"stiffness\": 3, \"damping\": 2 }"), std::string::npos) << model.json;
  EXPECT_NE(model.json.find("\"joint\": \"g\", \"damping\": 2 }"), std::string::npos) << model.json;
}

/// Without loops the note speaks of no gaps.
TEST(ImportClosing, RelationsOffZeroAreTold) {
  const std::string hinge =
      "<body><joint name='{}' axis='0 1 0'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body>";
  const ImportedModel model = imported_text(request_of(
      "m.xml", "<mujoco><worldbody>" + fmt::format(fmt::runtime(hinge), "a") + fmt::format(fmt::runtime(hinge), "b") +
                   "</worldbody><equality><joint joint1='a' joint2='b' polycoef='0.3 1'/></equality></mujoco>"));
  EXPECT_TRUE(has_note(model, "relations between joints do not hold as written: joints are moved, \"a\" by 0.3 rad"));
  EXPECT_FALSE(has_note(model, "loops are open"));
}

/// Ranges without width lock a joint, ranges the wrong way round mean nothing: both are told in each format.
TEST(ImportLimits, NarrowRangesAreTold) {
  const auto imported_with = [](const std::string& name, const std::string& text, const std::string& ends) {
    ImportRequest request = request_of(name, fmt::format(fmt::runtime(text), ends));
    request.stop_stiffness = 1000;
    return imported_text(request);
  };
  const std::string mjcf =
      "<mujoco><compiler angle='radian'/><worldbody><body><joint name='j' range='{}'/><inertial pos='0 0 0' mass='1' "
      "diaginertia='1 1 1'/></body></worldbody></mujoco>";
  const std::string sdf =
      "<sdf version='1.9'><model name='m'><link name='l'/><joint name='j' type='revolute'><parent>world</parent>"
      "<child>l</child><axis><limit>{}</limit></axis></joint></model></sdf>";
  const std::string urdf =
      "<robot name='r'><link name='world'/><link name='l'/><joint name='j' type='revolute'><parent link='world'/>"
      "<child link='l'/><limit {}/></joint></robot>";
  const std::string locked = "joint \"j\" is locked by its limits, both 0.5 rad: it is imported free to move",
                    turned = "joint \"j\": its lower limit, 0.5 rad, is above its upper one, 0.2 rad";
  const auto sdf_limits = [](double lower, double upper) {
    return fmt::format("<lower>{}</lower><upper>{}</upper>", lower, upper);
  };
  for (const ImportedModel& model :
       {imported_with("m.xml", mjcf, "0.5 0.5"), imported_with("m.sdf", sdf, sdf_limits(0.5, 0.5)),
        imported_with("m.urdf", urdf, "lower='0.5' upper='0.5'")}) {
    EXPECT_TRUE(has_note(model, locked)) << to_text(model.notes);
    EXPECT_EQ(model.json.find("bump_stops"), std::string::npos);
  }
  for (const ImportedModel& model :
       {imported_with("m.xml", mjcf, "0.5 0.2"), imported_with("m.sdf", sdf, sdf_limits(0.5, 0.2)),
        imported_with("m.urdf", urdf, "lower='0.5' upper='0.2'")})
    EXPECT_TRUE(has_note(model, turned)) << to_text(model.notes);
  EXPECT_FALSE(has_note(imported_with("m.xml", mjcf, "0 0"), "locked"));
  EXPECT_FALSE(has_note(imported_with("m.urdf", urdf, "effort='3' velocity='1'"), "locked"));
}

}  // namespace
}  // namespace mbgen
