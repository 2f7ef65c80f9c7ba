#pragma once
// Operation counts of the accelerations, and the savings of decisions about them.

#include <string>
#include <vector>

#include "compiler/compile.hpp"

namespace mbgen {

/// Operations that a decision about the accelerations saves.
struct Saving {
  std::string name;
  long without = 0, with = 0;
};

/// Operation counts of the accelerations: in each form, and savings of decisions.
struct Counts {
  long operations_of_form[2] = {0, 0};  ///< by Form, 0 for none
  std::vector<Saving> savings;
};

/// Operation count of the accelerations in a form; 0 for a form that is not traced because it is far larger than the
/// other.
long count_operations_of(const Compilation& compilation, Form form);

/// Operations saved by each treatment of the recursive form; traces the accelerations again without it.
std::vector<Saving> count_savings(const Compilation& compilation);

}  // namespace mbgen
