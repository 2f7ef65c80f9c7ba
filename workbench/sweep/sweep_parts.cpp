#include "workbench/sweep/sweep_parts.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Environment variables of a launcher for rank and number of processes.
struct Launcher {
  const char *rank, *size;
};

// SLURM_PROCID is set in a batch script too, which is no rank: only job steps have a number of tasks.
constexpr Launcher kLaunchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   {"PMI_RANK", "PMI_SIZE"},
                                   {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}};

std::optional<long> whole_number(const std::string& text) {
  long value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<long> number_of(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? std::nullopt : whole_number(text);
}

/// A word quoted for the shell.
std::string shell_quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

}  // namespace

SweepPart part_from(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::optional<long> index = whole_number(text.substr(0, slash));
  const std::optional<long> count = slash == std::string::npos ? std::nullopt : whole_number(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count) {
    throw UserError(fmt::format("--part: must be K/N with K from 1 to N, found {}\n", text));
  }
  return {*index - 1, *count};
}

std::optional<SweepPart> part_of_rank() {
  for (const Launcher& launcher : kLaunchers) {
    const std::optional<long> rank = number_of(launcher.rank), size = number_of(launcher.size);
    if (rank && size && *size > 1 && *rank >= 0 && *rank < *size) return SweepPart{*rank, *size};
  }
  return std::nullopt;
}

std::string job_of_rank() {
  for (const auto& variables :
       {std::vector<const char*>{"PMIX_NAMESPACE"}, {"OMPI_MCA_ess_base_jobid"}, {"SLURM_JOB_ID", "SLURM_STEP_ID"}}) {
    std::string job;
    for (const char* variable : variables) {
      const char* text = std::getenv(variable);
      job = text == nullptr ? "" : fmt::format("{}{}={};", job, variable, text);
    }
    if (!job.empty()) return job;
  }
  return {};
}

long cases_of(const SweepPart& part, long cases) { return (cases - part.index + part.count - 1) / part.count; }

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const bool is_known = ::sched_getaffinity(0, sizeof set, &set) == 0;
  return is_known && CPU_COUNT(&set) > 0 ? CPU_COUNT(&set) : 1;
}

std::string slurm_script(const std::string& model, const std::vector<std::string>& words, long parts, int jobs) {
  std::error_code problem;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", problem);
  std::string command = shell_quoted(problem ? "mbgen" : self.string());
  for (const std::string& word : words) command += " " + shell_quoted(word);
  return fmt::format(
      "#!/bin/sh\n"
      "# Parameter study of {model} in {parts} parts. `sh` with this file submits an array job for the parts and a "
      "job\n"
      "# behind it that gathers them; should parts fail, it computes their missing cases. A part takes the next case\n"
      "# that no other part has.\n"
      "# Further words for sbatch: as #SBATCH lines here, or in the environment (SBATCH_PARTITION, SBATCH_TIMELIMIT).\n"
      "#SBATCH --job-name=sweep-{model}\n"
      "#SBATCH --ntasks=1\n"
      "#SBATCH --cpus-per-task={jobs}\n"
      "set -eu\n"
      "case $0 in\n"
      "  /*) script=$0 ;;\n"
      "  *) script=$PWD/$0 ;;\n"
      "esac\n"
      "cd {directory}\n"
      "\n"
      "sweep() {{\n"
      "  {command} --jobs {jobs} \"$@\"\n"
      "}}\n"
      "\n"
      "case ${{1:-submit}} in\n"
      "  part) sweep --part \"$SLURM_ARRAY_TASK_ID/{parts}\" --claim ;;\n"
      "  gather) sweep ;;\n"
      "  submit)\n"
      "    array=$(sbatch --parsable --array=1-{parts} \"$script\" part)\n"
      "    sbatch --dependency=\"afterany:${{array%%;*}}\" \"$script\" gather\n"
      "    ;;\n"
      "esac\n",
      fmt::arg("model", model), fmt::arg("parts", parts), fmt::arg("jobs", jobs), fmt::arg("command", command),
      fmt::arg("directory", shell_quoted(std::filesystem::current_path().string())));
}

}  // namespace mbgen
