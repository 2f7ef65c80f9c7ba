// Motors of robots as actuators.

#include "compiler/reader/read_model.hpp"
#include "tests/import/import_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

TEST(ImportUrdf, TransmissionsBecomeActuators) {
  const std::string joint =
      "<joint name='NAME' type='revolute'><parent link='world'/><child link='NAME'/>"
      "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='30' velocity='2'/></joint>"
      "<link name='NAME'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
      "ixz='0' iyz='0'/></inertial></link>";
  std::string links = "<link name='world'/>";
  for (const char* name : {"a", "b", "c"}) {
    std::string one = joint;
    for (std::size_t at; (at = one.find("NAME")) != one.npos;) one.replace(at, 4, name);
    links += one;
  }
  const auto with = [&](const std::string& rest) {
    return imported_text(request_of("arm.urdf", "<robot name='arm'>" + links + rest + "</robot>"));
  };
  const ImportedModel model = with(
      "<transmission name='t'><type>transmission_interface/SimpleTransmission</type><joint "
      "name='a'><hardwareInterface/></joint>"
      "<actuator name='m1'><mechanicalReduction> -50 </mechanicalReduction></actuator></transmission>"
      "<ros2_control name='s' type='system'><hardware><plugin/></hardware><joint name='a'><command_interface "
      "name='effort'/></joint>"
      "<joint name='b'><command_interface name='position'/></joint><joint name='c'/></ros2_control>");
  const Result<Model> read = read_model(model.json, "arm.json");
  ASSERT_TRUE(read) << to_text(read.problems());
  EXPECT_EQ(model.notes.size(), 1u);  // on limits
  ASSERT_EQ(read->actuators.size(), 2u) << model.json;
  EXPECT_EQ(read->actuators[0].name, "m1");
  EXPECT_EQ(read->actuators[0].gear.value, -50);
  EXPECT_DOUBLE_EQ(read->actuators[0].limit.value(), 0.6);
  EXPECT_EQ(read->actuators[1].name, "b_motor");
  EXPECT_DOUBLE_EQ(read->actuators[1].limit.value(), 30);
  const ImportedModel differential = with("<transmission name='t'><joint name='a'/><joint name='b'/></transmission>");
  EXPECT_TRUE(has_note(differential, "transmission \"t\" not carried over: it has not one joint and one actuator"));
}

TEST(ImportMjcf, MotorsBecomeActuators) {
  const ImportedModel model =
      imported_text(request_of("m.xml",
                               "<mujoco><worldbody><body><joint name='j'/><geom size='1'/></body></worldbody><actuator>"
                               "<motor name='m' joint='j' gear='3' forcerange='-2 5'/><position name='p' joint='j' "
                               "kp='9'/></actuator></mujoco>"));
  const Result<Model> read = read_model(model.json, "m.json");
  ASSERT_TRUE(read) << to_text(read.problems());
  ASSERT_EQ(read->actuators.size(), 1u) << model.json;
  EXPECT_EQ(read->actuators[0].gear.value, 3);
  EXPECT_EQ(read->actuators[0].limit, 5);
  EXPECT_EQ(read->joint_forces.size(), 1u);
}

}  // namespace
}  // namespace mbgen
