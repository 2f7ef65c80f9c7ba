#pragma once
// A straight-line program as functions in C, none of which is large.

#include <functional>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Places of a program's numbers in C.
struct CPlaces {
  std::string name;                               ///< of the function that runs the whole program
  std::string point;                              ///< type of its first argument
  std::function<std::string(const Slot&)> input;  ///< expression over `at`, the first argument
  std::function<int(const Slot&)> output;         ///< index in `r`, its last argument
  std::string sample;                             ///< function that gives a number of the table
};

/// One function: definition, and the values that it computes.
struct CFunction {
  std::string name, text;
  std::size_t values = 0;
};

/// `parts` in the order in which `name(at, w, r)` calls them. w: numbers of `work` doubles that cross from part to
/// part.
struct CFunctions {
  std::string name;
  std::vector<CFunction> parts = {};
  int work = 0;
};

CFunctions c_functions(const Program& program, const CPlaces& places);

/// Declaration of a part of these names, without its end.
std::string c_signature(const std::string& name, const std::string& point);

}  // namespace mbgen
