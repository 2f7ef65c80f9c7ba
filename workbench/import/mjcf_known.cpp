// MJCF of MuJoCo 2.2 to 3.x (https://mujoco.readthedocs.io/en/stable/XMLreference.html); import_test holds the list
// against the schema that libmujoco prints.
#include <array>

#include "workbench/import/known.hpp"

namespace mbgen::importing {
namespace {

constexpr std::array<KnownElement, 65> kElementsOfMjcf = {{
    {"/mujoco", "model"},
    {"mujoco/compiler",
     "autolimits boundmass boundinertia settotalmass balanceinertia coordinate angle "
     "eulerseq inertiafromgeom inertiagrouprange",
     "strippath fitaabb meshdir texturedir assetdir discardvisual convexhull "
     "usethread fusestatic exactmeshinertia saveinertial alignfree conflict"},
    {"compiler/lengthrange", "", "", "ranges of muscles are not read"},
    {"mujoco/option", "timestep gravity density viscosity wind",
     "apirate impratio tolerance ls_tolerance noslip_tolerance mpr_tolerance "
     "ccd_tolerance sleep_tolerance magnetic o_margin o_solref o_solimp o_friction "
     "integrator collision cone jacobian solver iterations ls_iterations "
     "noslip_iterations mpr_iterations ccd_iterations sdf_iterations sdf_initpoints"},
    {"option/flag", "gravity passive spring damper equality frictionloss actuation constraint",
     "limit contact clampctrl warmstart filterparent refsafe sensor override energy "
     "fwdinv sensornoise multiccd invdiscrete midphase eulerdamp autoreset nativeccd "
     "island sleep boxbox boxboxlegacy diagexact ipc"},
    {"mujoco/size", "", "", "", true},
    {"mujoco/visual", "", "", "", true},
    {"mujoco/statistic", "", "", "", true},
    {"mujoco/worldbody", "name childclass pos quat axisangle euler xyaxes zaxis", "user"},
    {"mujoco/default", "class"},
    {"mujoco/equality", ""},
    {"mujoco/actuator", ""},
    {"mujoco/tendon", ""},
    {"mujoco/asset", "", "", "looks and meshes are not read"},
    {"mujoco/contact", "", "", "there is no contact"},
    {"mujoco/sensor", "", "", "outputs are chosen in the model"},
    {"mujoco/keyframe", "", "", "the initial state is chosen in the model"},
    {"mujoco/custom", "", "", "its meaning is not defined"},
    {"mujoco/deformable", "", "", "bodies are rigid"},
    {"mujoco/extension", "", "", "plugins are not read"},
    {"default/default", "class"},
    {"default/mesh", "", "", "", true},
    {"default/material", "", "", "", true},
    {"default/pair", "", "", "", true},
    {"default/equality", "active", "solref solimp"},
    {"default/tendon", "springlength stiffness damping frictionloss limited range",
     "group width material rgba user solreflimit solimplimit solreffriction "
     "solimpfriction margin"},
    {"body/body", "name childclass mocap gravcomp pos quat axisangle euler xyaxes zaxis", "user sleep simple"},
    {"body/frame", "name childclass pos quat axisangle euler xyaxes zaxis"},
    {"body/inertial", "mass diaginertia fullinertia pos quat axisangle euler xyaxes zaxis"},
    {"body/joint",
     "name class type pos axis springdamper limited stiffness range ref springref "
     "armature damping frictionloss",
     "group user actuatorgravcomp solreflimit solimplimit solreffriction "
     "solimpfriction margin"},
    {"body/freejoint", "name", "group align"},
    {"body/geom",
     "name class type size group mass density shellinertia mesh fromto pos quat "
     "axisangle euler xyaxes zaxis",
     "contype conaffinity condim priority material friction solmix solref solimp "
     "margin gap rgba user fluidshape hfield surfacevel adhesion"},
    {"body/site", "name class fromto pos quat axisangle euler xyaxes zaxis", "type size group material rgba user"},
    {"body/camera", "", "", "looks have no part in the dynamics"},
    {"body/light", "", "", "looks have no part in the dynamics"},
    {"body/composite", "", "", "its bodies are missing; let MuJoCo load and save the file, it writes them out"},
    {"body/flexcomp", "", "", "bodies are rigid"},
    {"body/replicate", "count offset euler sep childclass"},
    {"body/attach", "", "", "its bodies are missing; let MuJoCo 3 load and save the file, it writes them out"},
    {"body/plugin", "", "", "plugins are not read"},
    {"geom/plugin", "", "", "plugins are not read"},
    {"equality/connect", "name class body1 body2 anchor site1 site2 active", "solref solimp"},
    {"equality/weld", "name class body1 body2 relpose anchor site1 site2 active", "solref solimp torquescale"},
    {"equality/joint", "name class joint1 joint2 polycoef active", "solref solimp"},
    {"equality/tendon", "name class tendon1 tendon2 polycoef active", "solref solimp"},
    {"equality/distance", "", "", "distances of geoms are not held"},
    {"equality/flex", "", "", "bodies are rigid"},
    {"equality/flexvert", "", "", "bodies are rigid"},
    {"equality/flexstrain", "", "", "bodies are rigid"},
    {"tendon/fixed", "name class springlength stiffness damping frictionloss limited range",
     "group user solreflimit solimplimit solreffriction solimpfriction margin"},
    {"fixed/joint", "joint coef"},
    {"tendon/spatial", "", "",
     "only tendons over coordinates (<fixed>) are read, a spring between two points takes their place"},
    {"actuator/motor",
     "name class gear joint jointinparent tendon ctrllimited forcelimited ctrlrange "
     "forcerange",
     "group user lengthrange cranklength slidersite cranksite site refsite nsample "
     "interp inheritrange"},
    {"actuator/position",
     "name class gear joint jointinparent tendon ctrllimited forcelimited ctrlrange "
     "forcerange kp kv dampratio timeconst",
     "group user lengthrange cranklength slidersite cranksite site refsite nsample "
     "interp"},
    {"actuator/velocity",
     "name class gear joint jointinparent tendon ctrllimited forcelimited ctrlrange "
     "forcerange kv",
     "group user lengthrange cranklength slidersite cranksite site refsite nsample "
     "interp inheritrange"},
    {"actuator/general",
     "name class gear joint jointinparent tendon ctrllimited forcelimited ctrlrange "
     "forcerange dyntype gaintype biastype dynprm gainprm biasprm actlimited "
     "actrange actdim body velrange ffrange input",
     "group user lengthrange cranklength slidersite cranksite site refsite nsample "
     "interp inheritrange actearly"},
    {"actuator/intvelocity", "", "", "-"},
    {"actuator/damper", "", "", "-"},
    {"actuator/cylinder", "", "", "-"},
    {"actuator/muscle", "", "", "-"},
    {"actuator/adhesion", "", "", "-"},
    {"actuator/orientation", "", "", "-"},
    {"actuator/pid", "", "", "-"},
    {"actuator/dcmotor", "", "", "-"},
    {"actuator/plugin", "", "", "-"},
}};

constexpr std::array<LostAttribute, 21> kLost = {{
    {"body/joint", "actuatorfrcrange", "forces of actuators are not bounded"},
    {"body/joint", "actuatorfrclimited", "forces of actuators are not bounded"},
    {"body/geom", "fluidcoef", "there are no forces of a medium"},
    {"body/geom", "fitscale", "no geom is fitted to a mesh"},
    {"mujoco/option", "actuatorgroupdisable", "every actuator has its input"},
    {"tendon/fixed", "armature", "tendons have no inertia"},
    {"tendon/fixed", "actuatorfrcrange", "forces of actuators are not bounded"},
    {"tendon/fixed", "actuatorfrclimited", "forces of actuators are not bounded"},
    {"actuator/motor", "armature", "the inertia of the motor is missing"},
    {"actuator/motor", "damping", "the damping of the motor is missing"},
    {"actuator/motor", "delay", "inputs act at once"},
    {"actuator/position", "armature", "the inertia of the motor is missing"},
    {"actuator/position", "damping", "the damping of the motor is missing"},
    {"actuator/position", "delay", "inputs act at once"},
    {"actuator/position", "inheritrange", "the input is not bounded by the range of its joint"},
    {"actuator/velocity", "armature", "the inertia of the motor is missing"},
    {"actuator/velocity", "damping", "the damping of the motor is missing"},
    {"actuator/velocity", "delay", "inputs act at once"},
    {"actuator/general", "armature", "the inertia of the motor is missing"},
    {"actuator/general", "damping", "the damping of the motor is missing"},
    {"actuator/general", "delay", "inputs act at once"},
}};

constexpr std::array<SameContext, 5> kContextsOfMjcf = {{
    {"worldbody", "body"},
    {"frame", "body"},
    {"replicate", "body"},
    {"default", "body"},
    {"default", "actuator"},
}};

}  // namespace

const KnownFormat kMjcf = {"MJCF", kElementsOfMjcf, kLost, kContextsOfMjcf};

}  // namespace mbgen::importing
