#pragma once
// What a solver is written with.

#include <optional>
#include <string>

#include "compiler/emit/files.hpp"
#include "compiler/passes/roll.hpp"

namespace mbgen {

struct EmitOptions {
  bool runtime_headers = true;          ///< add the runtime's headers under mbgen/, so that the directory stands alone
  std::size_t roll_above = kRollAbove;  ///< operations of a program above which equal subsystems become loops
  std::size_t file_part_values = kFilePartValues;  ///< least number of values in a part of the file that runs rarely
  int lanes = 0;                  ///< instances that a call of the batch interface solves, 0 for no such interface
  std::string scalar = "double";  ///< of the solver: double, or float without the two interfaces
  std::optional<InitialState> initial = {};  ///< add initial_state() to the interfaces
  bool c_interface = false;                  ///< add <model>_c.h, <model>_c.cpp and <model>.py; needs `initial`
  bool calibration = false;                  ///< and <model>.a2l with <model>_a2l.h, which stand on them
};

}  // namespace mbgen
