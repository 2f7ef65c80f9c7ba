#pragma once
// The coordinates that a start holds when parameters of the model change.

#include <optional>
#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// A flag per tree coordinate: 1 for the given ones, or for the locked ones alone where they are more than a loop block
/// leaves free, and for independent coordinates beside them, from which a start closes its loops. None where the start
/// does not follow from held coordinates alone, but is the nearest pose to given values.
std::optional<std::vector<unsigned char>> held_at_start(const Topology& topology, const Analysis& analysis,
                                                        const std::vector<InitialValue>& given);

/// Whether a start has derivatives by held coordinates alone: it is no static equilibrium, and held_at_start gives
/// them.
bool has_start_with_derivatives(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
