#pragma once
// Operations of the accelerations, and what the decisions about them save.

#include <vector>

#include "compiler/choose/counted_treatments.hpp"

namespace mbgen {

/// Operations of the accelerations: of each form, and the savings of decisions.
struct Counts {
  long operations_of_form[2] = {0, 0};  ///< by Form, 0 for none
  std::vector<Saving> savings;
};

}  // namespace mbgen
