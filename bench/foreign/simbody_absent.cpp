// What stands for Simbody where it is not installed.

#include <stdexcept>

#include "bench/foreign/simbody_mechanism.hpp"

namespace mbgen::foreign {

struct SimbodyMechanism::Content {};

bool SimbodyMechanism::is_available() { return false; }
std::string SimbodyMechanism::version() { return ""; }
SimbodyMechanism::SimbodyMechanism(const ReferenceMechanism&) { throw std::logic_error("Simbody is not installed"); }
SimbodyMechanism::~SimbodyMechanism() = default;
SimbodyMechanism::SimbodyMechanism(SimbodyMechanism&&) noexcept = default;
std::vector<double> SimbodyMechanism::accelerations(const ForeignState&) { return {}; }
void SimbodyMechanism::load(const std::vector<ForeignState>&) {}
void SimbodyMechanism::run(int) {}

}  // namespace mbgen::foreign
