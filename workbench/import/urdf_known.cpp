// URDF 1.0 to 1.2 (http://wiki.ros.org/urdf/XML, the readme of urdfdom), with loops of Isaac Sim, Drake and URDF+.
#include <array>

#include "workbench/import/known.hpp"

namespace mbgen::importing {
namespace {

constexpr std::string_view kFrame = "xyz rpy quat_xyzw";

constexpr std::array<KnownElement, 76> kElementsOfUrdf = {{
    {"/robot", "name version"},
    {"robot/link", "name", "type"},
    {"robot/joint", "name type"},
    {"robot/material", "name"},
    {"robot/loop_joint", "name type"},
    {"robot/loop", "name type"},
    {"robot/constraint", "name type"},
    {"robot/transmission", "name type"},
    {"transmission/type", ""},
    {"transmission/plugin", ""},
    {"transmission/joint", "name role"},
    {"transmission/actuator", "name role"},
    {"actuator/mechanicalReduction", ""},
    {"actuator/mechanical_reduction", ""},
    {"actuator/hardwareInterface", ""},
    {"actuator/motorTorqueConstant", ""},
    {"robot/gazebo", "", "", "settings of Gazebo are not read"},
    {"robot/mujoco", "", "", "settings of MuJoCo are not read"},
    {"robot/sensor", "", "", "outputs are chosen in the model"},
    {"robot/ros2_control", "name type rw_rate is_async"},
    {"ros2_control/joint", "name"},
    {"ros2_control/hardware", ""},
    {"hardware/plugin", ""},
    {"hardware/param", "name"},
    {"joint/hardwareInterface", ""},
    {"joint/command_interface", "name"},
    {"joint/state_interface", "name"},
    {"joint/param", "name"},
    {"command_interface/param", "name"},
    {"state_interface/param", "name"},
    {"ros2_control/sensor", "", "", "outputs are chosen in the model"},
    {"ros2_control/gpio", "", "", "it is not part of the mechanism"},
    {"ros2_control/transmission", "name type"},
    {"robot/coupling", "", "", "only <mimic> becomes a coupling, others are typed into \"couplings\" of the model"},
    {"link/inertial", ""},
    {"link/visual", "", "name"},
    {"link/collision", "", "", "there is no contact"},
    {"inertial/origin", kFrame},
    {"inertial/mass", "value"},
    {"inertial/inertia", "ixx iyy izz ixy ixz iyz"},
    {"visual/origin", kFrame},
    {"visual/geometry", ""},
    {"visual/material", "name"},
    {"geometry/box", "size"},
    {"geometry/cylinder", "radius length"},
    {"geometry/sphere", "radius"},
    {"geometry/capsule", "radius length"},
    {"geometry/mesh", "filename scale"},
    {"material/color", "rgba"},
    {"material/texture", "", "filename"},
    {"joint/origin", kFrame},
    {"joint/parent", "link"},
    {"joint/child", "link"},
    {"joint/axis", "xyz"},
    {"joint/dynamics", "damping friction"},
    {"joint/limit", "lower upper effort velocity acceleration deceleration jerk"},
    {"joint/mimic", "joint multiplier offset"},
    {"joint/calibration", "", "", "it is not part of the mechanism"},
    {"joint/safety_controller", "", "", "controllers are not part of the mechanism"},
    {"loop_joint/link1", "link xyz rpy quat_xyzw"},
    {"loop_joint/link2", "link xyz rpy quat_xyzw"},
    {"loop/predecessor", "link xyz rpy quat_xyzw"},
    {"loop/successor", "link xyz rpy quat_xyzw"},
    {"loop/axis", "xyz"},
    {"loop/limit", "", "", "joints that close loops have no coordinate"},
    {"loop/dynamics", "", "", "joints that close loops have no coordinate"},
    {"loop_joint/axis", "xyz"},
    {"end/origin", kFrame},
    {"constraint/parent", "link"},
    {"constraint/child", "link"},
    {"constraint/parent_origin", kFrame},
    {"constraint/child_origin", kFrame},
    {"constraint/parent_axis", "xyz"},
    {"constraint/child_axis", "xyz"},
    {"constraint/limit", "", "", "joints that close loops have no coordinate"},
    {"constraint/dynamics", "", "", "joints that close loops have no coordinate"},
}};

constexpr std::array<SameContext, 6> kContextsOfUrdf = {{{"link1", "end"},
                                                         {"link2", "end"},
                                                         {"predecessor", "end"},
                                                         {"successor", "end"},
                                                         {"loop_joint", "loop"},
                                                         {"loop", "loop_joint"}}};

}  // namespace

const KnownFormat kUrdf = {"URDF", kElementsOfUrdf, {}, kContextsOfUrdf};

}  // namespace mbgen::importing
