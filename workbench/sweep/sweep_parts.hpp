#pragma once
// A study on several processes: ranks of a parallel job, or tasks of an array job.

#include <optional>
#include <string>
#include <vector>

#include "workbench/sweep/sweep_journal.hpp"

namespace mbgen {

/// Part of "K/N", K from 1. Fails: UserError.
SweepPart part_from(const std::string& text);

/// Part of this process as a rank of a parallel job of more than one process, from the environment of OpenMPI
/// (OMPI_COMM_WORLD_RANK, _SIZE), MPICH and relatives (PMI_RANK, PMI_SIZE) or srun (SLURM_PROCID,
/// SLURM_STEP_NUM_TASKS); nothing outside such a job.
std::optional<SweepPart> part_of_rank();

/// Name of the parallel job of this rank, the same for all of its ranks and no other job; "" where the launcher says
/// none.
std::string job_of_rank();

/// Number of cases of a part.
long cases_of(const SweepPart& part, long cases);

/// Number of processors available to this process.
int processors();

/// Shell script that submits an array job of `parts` tasks and a dependent job that gathers the results. words: the
/// command line of the study without the name of the program.
std::string slurm_script(const std::string& model, const std::vector<std::string>& words, long parts, int jobs);

}  // namespace mbgen
