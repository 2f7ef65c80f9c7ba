#pragma once
// Names in the text of a call for many arguments.

#include <set>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Arrays of one call for many arguments.
struct CallNames {
  std::string function, arguments, exponents;  ///< exponents: of powers, else empty
  std::vector<std::string> results;
  std::string declaration;     ///< of the results, empty when they are members of `work`
  std::set<std::string> work;  ///< arguments whose members they are
};

/// Names before they are made unique, for the function of an ArrayCall; no declaration.
CallNames names_of_call(Op op);

}  // namespace mbgen
