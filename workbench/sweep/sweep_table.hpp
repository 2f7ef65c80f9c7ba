#pragma once
// Results of a study as tables.

#include <string>

#include "workbench/sweep/sweep_study.hpp"

namespace mbgen {

// results: of all cases.

/// CSV: case (from 1), varied values, metrics (empty for a failed case), status; numbers in their shortest exact form.
std::string results_csv(const Study& study, const CaseResults& results);

/// Text: the table, shortened in the middle if long, then the number of failed cases.
std::string results_text(const Study& study, const CaseResults& results, const std::string& file);

/// JSON of all cases.
std::string results_json(const Study& study, const CaseResults& results, const std::string& file);

/// Number of cases without values.
long failures_of(const CaseResults& results);

}  // namespace mbgen
