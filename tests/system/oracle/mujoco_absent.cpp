// Stub where MuJoCo is not installed.

#include <stdexcept>

#include "tests/system/oracle/mujoco_mechanism.hpp"

namespace mbgen::foreign {

struct MujocoMechanism::Content {};

bool MujocoMechanism::is_available() { return false; }
std::string MujocoMechanism::version() { return ""; }
MujocoMechanism::MujocoMechanism(const ReferenceMechanism&) { throw std::logic_error("MuJoCo is not installed"); }
MujocoMechanism::~MujocoMechanism() = default;
MujocoMechanism::MujocoMechanism(MujocoMechanism&&) noexcept = default;
std::vector<double> MujocoMechanism::accelerations(const ForeignState&) { return {}; }
std::vector<double> MujocoMechanism::inverse_forces(const ForeignState&, const std::vector<double>&) { return {}; }
void MujocoMechanism::load(const std::vector<ForeignState>&) {}
void MujocoMechanism::run(int) {}

}  // namespace mbgen::foreign
