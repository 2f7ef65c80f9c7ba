#pragma once
// The result of an optimisation.

#include <string>
#include <vector>

#include "workbench/optimise/design_problem.hpp"

namespace mbgen::optimise {

/// A variable at the result.
struct FoundVariable {
  Unknown variable;
  double value = 0;
  int at_bound = 0;       ///< -1 lower, 1 upper
  double multiplier = 0;  ///< change of the weighted goal per unit by which the bound moves up
};

struct FoundGoal {
  Goal goal;
  std::string unit;
  double start = 0, value = 0, weighted = 0;  ///< weighted: share of the sum that is minimised
};

struct FoundConstraint {
  Constraint constraint;
  std::string unit;
  double start = 0, value = 0, limit = 0;  ///< at the point nearest to its limit, or furthest beyond
  bool is_active = false, is_broken = false;
  double multiplier = 0;  ///< change of the weighted goal per unit by which the limit is raised
};

/// A curve before and after, beside its target or limits.
struct FoundCurve {
  std::string name, unit;
  Heading abscissa;
  std::vector<double> at, before, after;
  std::vector<double> target = {}, least = {}, most = {};  ///< one for each point, or none
};

/// A point of a trade-off, or the one result of a search.
struct FoundDesign {
  std::string status;  ///< "ok", else the reason for doubt
  std::string ended;   ///< words of the method
  bool keeps_constraints = false;
  double rest = 0;  ///< of the conditions of first order
  double sum = 0;   ///< weighted, that is minimised
  std::vector<FoundVariable> variables = {};
  std::vector<FoundGoal> goals = {};
  std::vector<FoundConstraint> constraints = {};
  bool is_ok() const { return status == "ok"; }
};

/// How a start of a global search ended.
struct FoundStart {
  std::vector<double> values;
  std::string status;
  double sum = 0;
};

struct OptimiseResult {
  std::string model, model_file, engine, method, derivatives;
  std::vector<VariedParameter> set = {};
  FoundDesign best = {};                    ///< of a search without trade-off
  std::vector<FoundDesign> trade_off = {};  ///< in the order of the first goal
  std::string first = {}, second = {};      ///< names of the goals of the trade-off
  std::vector<FoundStart> starts = {};      ///< of a global search
  std::vector<FoundCurve> curves = {};
  std::vector<RefusedDesign> refused = {};
  std::vector<EvaluatedDesign> course = {};
  long evaluations = 0, with_derivatives = 0;
  std::vector<std::string> warnings = {}, files = {};

  bool is_trade_off() const { return !first.empty(); }
};

}  // namespace mbgen::optimise
