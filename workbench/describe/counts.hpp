#pragma once
// Operations of the accelerations, and what the decisions about them save.

#include <string>
#include <vector>

#include "compiler/compile.hpp"

namespace mbgen {

/// Operations that a decision about the accelerations saves.
struct Saving {
  std::string name;
  long without = 0, with = 0;
};

/// Operations of the accelerations: of each form, and the savings of decisions.
struct Counts {
  long operations_of_form[2] = {0, 0};  ///< by Form, 0 for none
  std::vector<Saving> savings;
};

/// Operations of the accelerations in a form; 0 for a form that grows so far beyond the other one that it is not
/// traced.
long count_operations_of(const Compilation& compilation, Form form);

/// Operations that each treatment of the recursive form saves: traces the accelerations again without it.
std::vector<Saving> count_savings(const Compilation& compilation);

}  // namespace mbgen
