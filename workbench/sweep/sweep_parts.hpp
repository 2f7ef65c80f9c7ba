#pragma once
// A study on several processes: ranks of a parallel job, or parts of an array job.

#include <optional>
#include <string>
#include <vector>

#include "workbench/sweep/sweep_journal.hpp"

namespace mbgen {

/// The part that "K/N" names, K from 1. Fails: UserError.
SweepPart part_from(const std::string& text);

/// The part of this process as a rank of a parallel job of more than one, from what OpenMPI (OMPI_COMM_WORLD_RANK,
/// _SIZE), MPICH and its kin (PMI_RANK, PMI_SIZE) or srun (SLURM_PROCID, SLURM_STEP_NUM_TASKS) put into the
/// environment; nothing when it is none.
std::optional<SweepPart> part_of_rank();

/// Processors that this process may use.
int processors();

/// A shell script that submits an array job of `parts` parts and a job behind it that gathers them. words: the command
/// line of the study without the name of the program.
std::string slurm_script(const std::string& model, const std::vector<std::string>& words, long parts, int jobs);

}  // namespace mbgen
