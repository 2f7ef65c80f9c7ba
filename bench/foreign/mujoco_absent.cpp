// What stands for MuJoCo where it is not installed.

#include <stdexcept>

#include "bench/foreign/mujoco_mechanism.hpp"

namespace mbgen::foreign {

struct MuJoCoMechanism::Content {};

bool MuJoCoMechanism::is_available() { return false; }
std::string MuJoCoMechanism::version() { return ""; }
MuJoCoMechanism::MujocoMechanism(const ReferenceMechanism&) { throw std::logic_error("MuJoCo is not installed"); }
MuJoCoMechanism::~MujocoMechanism() = default;
MuJoCoMechanism::MujocoMechanism(MujocoMechanism&&) noexcept = default;
std::vector<double> MuJoCoMechanism::accelerations(const ForeignState&) { return {}; }
void MuJoCoMechanism::load(const std::vector<ForeignState>&) {}
void MuJoCoMechanism::run(int) {}

}  // namespace mbgen::foreign
