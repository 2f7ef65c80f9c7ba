#pragma once
// The computation of one case of a study.

#include <functional>
#include <optional>

#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

/// Simulates one case, keeps its motion where asked, and computes its metrics. An error of a case is its status.
/// is_stopped: called after every step; a case that it stops has no result. Fails: std::exception where mbgen is at
/// fault, UserError when the model was changed meanwhile.
std::optional<CaseResult> run_case(const Study& study, const StudySolver& solver, long index,
                                   const std::function<bool()>& is_stopped = {});

}  // namespace mbgen
