#pragma once
// The comparison of one mechanism: who answers what, in what time, by what code.

#include <optional>
#include <string>
#include <vector>

#include "bench/compare/code_facts.hpp"
#include "bench/compare/rounds.hpp"
#include "bench/compare/targets.hpp"

namespace mbgen::compare {

struct Settings {
  int rounds = 100;
  double seconds = 0.003;          ///< of one contestant in one round
  std::string states_directory;    ///< holds <mechanism>_states.json; "" for random states everywhere
  bool rods_are_massless = false;  ///< takes the mass of all rods away
  bool counts_code = true;         ///< fills CodeFacts
};

/// One contestant with its figures.
struct Row {
  std::string key, name, remark, absent;
  bool exact = true;
  double deviation = 0;                     ///< from the reference, relative
  std::optional<double> deviation_at_rest;  ///< the same with all velocities zero; of inexact contestants only
  Timing timing;
};

struct Comparison {
  std::string model;   ///< its name
  std::string states;  ///< where they are from
  bool rods_are_massless = false;
  int coordinates = 0, closure_equations = 0, degrees_of_freedom = 0;
  std::vector<Row> rows;
  std::optional<CodeFacts> code;
  /// Exact contestants that are farther than kAgreement from the reference: then nobody was timed.
  std::vector<std::string> disagreeing;
};

/// Compares all contestants on the model of a file. Fails: UserError.
Comparison compare_on(const std::string& model_path, const Settings& settings);

/// A target and what was measured for it; no value when the row is missing.
struct Verdict {
  Target target;
  std::optional<double> value;
  bool is_met() const {
    return value && (is_lower_limit(target.figure) ? *value >= target.value : *value <= target.value);
  }
};

/// Targets of the comparison's model, in order; ratios are those of the least times.
std::vector<Verdict> verdicts(const Comparison& comparison);

}  // namespace mbgen::compare
