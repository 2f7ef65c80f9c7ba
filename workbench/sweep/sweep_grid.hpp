#pragma once
// The grid of a parameter study: all combinations of values of some parameters, inputs and numbers of a manoeuvre.

#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// One varied parameter, input or number of a manoeuvre.
struct SweepAxis {
  enum class Of { parameter, input, manoeuvre };
  std::string name, unit;  ///< as typed: "manoeuvre.speed" of a manoeuvre
  Of of = Of::parameter;
  int index = -1;  ///< into Model::parameters or Model::inputs
  std::vector<double> values;
};

/// The cases are numbered from 0; the last axis changes fastest.
struct SweepGrid {
  std::vector<SweepAxis> axes;

  long size() const;
  /// Values of all axes in a case.
  std::vector<double> values_of(long index) const;
};

/// Beginning of the names of a manoeuvre's numbers.
constexpr std::string_view kOfManoeuvre = "manoeuvre.";

/// Reads "name=first:step:last", "name=value,value" or a mixture separated by commas. manoeuvre: text of its file, ""
/// for none. A range ends at the last value not beyond `last`; its values are rounded to the decimals of its numbers,
/// so that 0:0.1:0.3 contains 0.3. Fails: UserError for an unknown name (with the nearest one) or a repeated one, text
/// that is no number, an empty or infinite range, too many cases.
SweepGrid read_grid(const std::vector<std::string>& texts, const Model& model, const std::string& manoeuvre = {});

}  // namespace mbgen
