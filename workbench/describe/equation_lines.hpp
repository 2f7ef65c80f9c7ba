#pragma once
// Quantities in the reading copy of a solver: the line of each, with its program, its step and its part of the model.

#include <set>
#include <string>
#include <vector>

namespace mbgen {

/// A statement that defines a quantity.
struct EquationLine {
  std::string name;       ///< "Ic_carrier_left_zz"; of a result "zdd_crank_pin"
  std::string program;    ///< "compute_accelerations"; "" for a number of the file
  std::string step;       ///< "step 8: elimination from the leaves to the root (63)"; "" before the first one
  std::string part;       ///< "carrier_left: pin_left, revolute, axle"; "" for none
  int line = 0;           ///< in the file, from 1 on
  std::string statement;  ///< in one line
};

/// Every quantity that the text of a reading copy defines, in its order.
std::vector<EquationLine> equations_in(const std::string& text);

/// The names among them of parts of long sums: "Fz_tyre_part_2" beside "Fz_tyre".
std::set<std::string> names_of_parts(const std::vector<EquationLine>& all);

}  // namespace mbgen
