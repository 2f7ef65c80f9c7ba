#pragma once
// The work of one process on a study: its cases, alone or beside other processes.

#include <optional>
#include <string>
#include <vector>

#include "workbench/sweep/sweep_claims.hpp"
#include "workbench/sweep/sweep_journal.hpp"

namespace mbgen {

/// The share of this process.
struct SweepWork {
  const Study& study;
  std::string table;         ///< file of the study
  std::string description;   ///< of the study
  SweepPart part;            ///< its number among the processes; without claims its cases
  Claims* claims = nullptr;  ///< null: the cases of the part are computed
  int jobs = 1;              ///< cases at a time
  bool gathers = false;      ///< it waits for the results of all cases
  bool tells_notes = false;  ///< it counts the notes on the model, on standard error
};

/// Computes the missing cases of this process; a result is in the journal before it counts. With claims it takes case
/// by case the next one that no process has; a process that gathers takes those too that another one has lost. results:
/// those known, and then all of this process; where it gathers, all. Result: number of cases that it computed. Fails:
/// as run_case and Journal::add, with the first failure after all threads have ended; Interrupted; UserError where
/// other parts leave cases undone.
long work_on(const SweepWork& work, Journal& journal, CaseResults& results);

}  // namespace mbgen
