#pragma once
// Unknowns of a search: parameters of the model, and of a fit values at the start of a run and gain, bias and delay of
// channels.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// One unknown; SI units.
struct Unknown {
  enum class Kind { parameter, start, gain, bias, delay };
  Kind kind = Kind::parameter;
  std::string name = {}, unit = {};  ///< of the model, "gain of ay"
  double start = 0, lower = 0, upper = 0;
  double scale = 1;          ///< size of its changes: its value at the start, or a part of its range
  int run = -1;              ///< of a value at the start, -1: of all runs
  int channel = -1;          ///< of gain, bias or delay
  std::string coordinate{};  ///< of a value at the start: "z.NAME" or "zd.NAME"
  bool is_physical = false;  ///< an entry of an inertia that stays one of a body; without bounds

  /// Whether the motion depends on it.
  bool moves_model() const { return kind == Kind::parameter || kind == Kind::start; }
};

/// Parameters of --free: NAME, NAME=LOW:HIGH, NAME=LOW:START:HIGH or NAME=physical, separated by commas. Without bounds
/// from a tenth to ten times the value. Fails: UserError for a name that is no parameter (with the nearest), one that
/// stands twice, bounds that are no numbers, in the wrong order or around another range than the value; a value 0
/// without bounds.
std::vector<Unknown> free_parameters(const Model& model, const std::vector<std::string>& texts);

/// Values of --free-start in every run: z.NAME=LOW:HIGH or zd.NAME=LOW:HIGH of a coordinate. runs: numbers of their
/// files. Fails: UserError for an unknown coordinate, a position where the model starts in equilibrium, and as
/// free_parameters.
std::vector<Unknown> free_starts(const Model& model, const std::vector<std::string>& texts,
                                 const std::vector<int>& runs);

}  // namespace mbgen
