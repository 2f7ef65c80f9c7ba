#pragma once
// The search of one design: the programme of its goals and constraints, solved until the conditions of first order
// hold.

#include <optional>
#include <string>
#include <vector>

#include "workbench/optimise/design_problem.hpp"
#include "workbench/optimise/optimality.hpp"

namespace mbgen::optimise {

/// The share of a problem's goals in a search: all in one sum, or one, while another is bounded.
struct DesignTask {
  std::optional<std::size_t> goal = {};     ///< the only one that is minimised
  std::optional<std::size_t> bounded = {};  ///< a goal that is held at most ...
  double most = 0;                          ///< ... at this cost
  std::vector<double> start = {};
  double size = 0;          ///< of the goal and its gradient, by size_of; 0: as at the start of the task
  double bounded_size = 1;  ///< likewise of the bounded goal
};

/// Where a search ended.
struct SearchedDesign {
  Design design;
  ProgrammePoint point;
  Optimality optimality;
  std::string ended;               ///< words of the method
  std::string status;              ///< "ok", else the reason for doubt
  bool keeps_constraints = false;  ///< all of them
};

/// Size of a goal and its gradient at a design, above 0; of the sum without a goal. Requires: design has derivatives.
double size_of(const DesignProblem& problem, std::optional<std::size_t> goal, const Design& design);

/// The programme of a task. Rows of constraints are in the order of the problem's; the bounded goal comes last.
ProgrammePoint point_of(const DesignProblem& problem, const DesignTask& task, const Design& design);

/// Searches from the start of the task. Result: nothing where the model has no result there, or where
/// problem.is_stopped ends the search.
std::optional<SearchedDesign> search_design(const DesignProblem& problem, const DesignTask& task, Designs& designs);

/// Searches from several starts, the first of which is the task's, the others evenly spread over the bounds.
std::vector<std::optional<SearchedDesign>> search_from_starts(const DesignProblem& problem, const DesignTask& task,
                                                              int starts, Designs& designs);

/// Whether one is better than another: a design that keeps its constraints, then one that is ok, then the lower cost.
bool is_better(const SearchedDesign& one, const SearchedDesign& other);

}  // namespace mbgen::optimise
