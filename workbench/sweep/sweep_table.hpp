#pragma once
// The results of a study as tables.

#include <string>

#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

// results: of all cases.

/// CSV: case (from 1), varied values, metrics (empty where a case failed), status; numbers in the shortest form that
/// reads back the same.
std::string results_csv(const Study& study, const CaseResults& results);

/// For people: the table, in the middle cut out when it is long, then how many cases failed.
std::string results_text(const Study& study, const CaseResults& results, const std::string& file);

/// For machines.
std::string results_json(const Study& study, const CaseResults& results, const std::string& file);

/// Cases without values.
long failures_of(const CaseResults& results);

}  // namespace mbgen
