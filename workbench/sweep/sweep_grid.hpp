#pragma once
// The grid of a parameter study: all combinations of values of some parameters and inputs.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// One varied parameter or input.
struct SweepAxis {
  std::string name, unit;
  bool is_input = false;
  int index = -1;  ///< into Model::parameters or Model::inputs
  std::vector<double> values;
};

/// The cases are numbered from 0; the last axis changes fastest.
struct SweepGrid {
  std::vector<SweepAxis> axes;

  long size() const;
  /// Of all axes, in a case.
  std::vector<double> values_of(long index) const;
};

/// Reads "name=first:step:last", "name=value,value" or any of both separated by commas. A range ends at the last value
/// that is not beyond `last`; its values are rounded to the decimals that its numbers have digits for, so that
/// 0:0.1:0.3 holds 0.3.
/// Fails: UserError for a name that the model does not have (with the nearest one) or that comes twice, a number that
/// is none, an empty or an endless range, more cases than a study can have.
SweepGrid read_grid(const std::vector<std::string>& texts, const Model& model);

}  // namespace mbgen
