#include "compiler/topology/topology.hpp"

namespace mbgen {

Topology::Topology() = default;
Topology::Topology(const Topology& other) = default;
Topology::Topology(Topology&& other) noexcept = default;
Topology& Topology::operator=(const Topology& other) = default;
Topology& Topology::operator=(Topology&& other) noexcept = default;
Topology::~Topology() = default;

}  // namespace mbgen
