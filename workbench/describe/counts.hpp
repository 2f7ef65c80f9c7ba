#pragma once
// Operation counts of the accelerations, and the savings of decisions about them.

#include <vector>

#include "compiler/choose/counted_treatments.hpp"

namespace mbgen {

/// Operation counts of the accelerations: in each form, and savings of decisions.
struct Counts {
  long operations_of_form[2] = {0, 0};  ///< by Form, 0 for none
  std::vector<Saving> savings;
};

}  // namespace mbgen
