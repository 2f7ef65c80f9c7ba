#pragma once
// Operations of the forms and of the treatments of the recursive form: the accelerations are traced without each.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Operations that a decision about the accelerations saves.
struct Saving {
  std::string name;
  long without = 0, with = 0;
};

/// Operations of the accelerations in a form; 0 for a form that grows so far beyond the other one that it is not
/// traced.
long count_operations_of(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// Operations that each treatment of the recursive form saves. with: of the accelerations as they are written.
std::vector<Saving> count_savings(const Model& model, const Topology& topology, const Analysis& analysis, long with);

}  // namespace mbgen
