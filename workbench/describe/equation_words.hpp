#pragma once
// Quantities of a reading copy by the words of people: "front roll bar torque", "tyre force front left".

#include <map>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"
#include "workbench/describe/equation_lines.hpp"

namespace mbgen {

/// Further words for the parts of a model by their names: kinds of elements and of loops, and the words of vehicle
/// engineers for bars and for the coordinates of a free body.
using PartWords = std::map<std::string, std::string>;
PartWords part_words(const Model& model, const Topology& topology);

/// A quantity that fits, at its first line.
struct FittingLine {
  const EquationLine* line = nullptr;
  int matched = 0;  ///< words of the query that it fits
};

/// The quantities that fit most of the words of a query, best first. Empty if no word names a part of the model or a
/// kind of quantity. words: number of words in the query.
std::vector<FittingLine> fitting_lines(const std::vector<EquationLine>& all, const std::string& query,
                                       const PartWords& parts, int& words);

}  // namespace mbgen
