#pragma once
// The computation of one case of a study.

#include <functional>
#include <optional>

#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

/// Values at which a study's motion is wanted, beside its grid or on it.
struct CaseAt {
  std::vector<double> values;  ///< of all axes
  std::string kept = {};       ///< file of its motion, "" for none
  bool with_derivatives = false;
};

/// Simulates the motion at these values, keeps it where asked, and computes its metrics; with their exact derivatives
/// by the axes where the solver has `tangents`. Fails: as run_case.
std::optional<CaseResult> run_at(const Study& study, const StudySolver& solver, const CaseAt& at,
                                 const std::function<bool()>& is_stopped = {});

/// Simulates one case, keeps its motion where asked, and computes its metrics. An error of a case is its status.
/// is_stopped: called after every step; a case that it stops has no result. Fails: std::exception where mbgen is at
/// fault, UserError when the model was changed meanwhile.
std::optional<CaseResult> run_case(const Study& study, const StudySolver& solver, long index,
                                   const std::function<bool()>& is_stopped = {});

}  // namespace mbgen
