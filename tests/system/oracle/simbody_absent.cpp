// Stub where Simbody is not installed.

#include <stdexcept>

#include "tests/system/oracle/simbody_mechanism.hpp"

namespace mbgen::foreign {

struct SimbodySystem {};

bool SimbodyMechanism::is_available() { return false; }
std::string SimbodyMechanism::version() { return ""; }
SimbodyMechanism::SimbodyMechanism(const ReferenceMechanism&, const ForceElements&) {
  throw std::logic_error("Simbody is not installed");
}
SimbodyMechanism::~SimbodyMechanism() = default;
SimbodyMechanism::SimbodyMechanism(SimbodyMechanism&&) noexcept = default;
std::vector<double> SimbodyMechanism::accelerations(const ForeignState&) { return {}; }
ForeignReactions SimbodyMechanism::reactions(const ForeignState&) { return {}; }
std::vector<ForeignState> SimbodyMechanism::motion(const ForeignState&, const std::vector<double>&, double) {
  return {};
}
void SimbodyMechanism::load(const std::vector<ForeignState>&) {}
void SimbodyMechanism::run(int) {}

}  // namespace mbgen::foreign
