// mbgen sweep: simulations over all combinations of values, with a few metrics of each.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/sweep/sweep_parts.hpp"
#include "workbench/sweep/sweep_table.hpp"
#include "workbench/sweep/sweep_work.hpp"

namespace mbgen::cli {
namespace {

constexpr int kMostJobs = 1024;
constexpr long kSlurmParts = 8;
struct SweepOptions {
  StudyArguments study;
  std::string file, part, slurm;
  int jobs = 0;  ///< 0: one per processor
  long parts = kSlurmParts;
  bool restart = false, claims = false, json = false;
};

/// Adds the cases of the journals beside the table. Fails: as read_journal.
void add_journals(const std::string& table, const std::string& words, CaseResults& results) {
  for (const std::filesystem::path& path : journals_of(table)) results.merge(read_journal(path, words));
}

/// With --restart: removes journals that no process would restart. kept: number of journals of one partition that its
/// processes restart themselves.
void remove_journals(const std::string& table, long kept) {
  std::vector<std::filesystem::path> own;
  for (long k = 0; k < kept; ++k) own.push_back(journal_path(table, {k, kept}));
  for (const std::filesystem::path& path : journals_of(table)) {
    std::error_code ignored;
    if (std::find(own.begin(), own.end(), path) == own.end() && !is_held(path)) std::filesystem::remove(path, ignored);
  }
}

/// Command line of a study, for a script.
std::vector<std::string> words_of(const SweepOptions& options) {
  const StudyArguments& study = options.study;
  std::vector<std::string> words{"sweep", study.model};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  for (const std::string& text : study.vary) add("--vary", text);
  for (const std::string& text : study.metrics) add("--metric", text);
  add("--manoeuvre", study.manoeuvre);
  add("--keep", study.keep);
  if (study.every != 1) add("--every", fmt::format("{}", study.every));
  for (const std::string& text : study.set) add("--set", text);
  for (const std::string& text : study.engine.inputs) add("--input", text);
  if (study.simulation.duration) add("--duration", fmt::format("{}", *study.simulation.duration));
  if (study.simulation.step) add("--step", fmt::format("{}", *study.simulation.step));
  add("--integrator", study.simulation.integrator);
  add("--input-table", study.simulation.input_table);
  add("--interpolation", study.simulation.interpolation);
  if (study.has_engine) add("--engine", study.engine.choice.name);
  add("--linear-algebra", study.engine.linear_algebra);
  add("--factorisation", study.engine.factorisation);
  add("--stabilisation", study.engine.stabilisation);
  if (!study.engine.choice.use_cache) words.push_back("--no-cache");
  if (options.json) words.push_back("--json");
  add("--out", options.file);
  return words;
}

std::vector<std::string> files_read(const SweepOptions& options, const Study& study) {
  std::vector<std::string> files = study.model.files;
  files.insert(files.end(), {options.study.simulation.input_table, options.study.manoeuvre});
  return files;
}

int write_slurm_script(const SweepOptions& options, const Study& study) {
  if (options.parts < 1) throw UserError(fmt::format("--parts: must be positive, found {}\n", options.parts));
  const long parts = std::min(options.parts, study.grid.size());
  write_file(options.slurm, slurm_script(study.model.name, words_of(options), parts, std::max(options.jobs, 1)),
             files_read(options, study));
  print_beside(options.slurm, fmt::format("{}: {} cases in {} parts; submit with: sh {}\n", options.slurm,
                                          study.grid.size(), parts, options.slurm));
  return kDone;
}

void check(const SweepOptions& options) {
  if (options.jobs < 0 || options.jobs > kMostJobs) {
    throw UserError(fmt::format("--jobs: must be from 1 to {}, found {}\n", kMostJobs, options.jobs));
  }
  if (options.study.metrics.empty() && options.study.manoeuvre.empty()) {
    throw UserError("--metric: give a number of each motion, or a manoeuvre, which has those of its standard\n");
  }
  if (options.study.every < 1)
    throw UserError(fmt::format("--every: must be positive, found {}\n", options.study.every));
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(options.file, problem);
  if (is_standard_output(options.file) ||
      (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))) {
    throw UserError(
        fmt::format("{}: cannot write: a study keeps a journal beside its table, name a file\n", options.file));
  }
}

void finish(const SweepOptions& options, const Study& study, const CaseResults& results) {
  write_file(options.file, results_csv(study, results), files_read(options, study));
  print(options.json ? results_json(study, results, options.file) : results_text(study, results, options.file));
}

/// Fails: UserError where the table, its journal, the script or a motion of --keep are one file.
void require_study_apart(const SweepOptions& options, const Study& study) {
  std::vector<WrittenFile> files{{"--out", options.file},
                                 {"the journal beside --out", journal_path(options.file, {}).string()},
                                 {"--slurm", options.slurm}};
  require_written_apart(files);
  for (const WrittenFile& file : files)
    if (is_kept_motion(study, file.path))
      throw UserError(fmt::format("{}: {} and a motion of --keep must be two files\n", file.path, file.option));
}

/// The place of this process among those of the study.
struct Crew {
  std::optional<SweepPart> rank;
  SweepPart part;
  bool claims = false;    ///< it takes the next case that nobody has
  bool is_first = false;  ///< it gathers and speaks
};

Crew crew_of(const SweepOptions& options) {
  Crew crew;
  if (options.part.empty()) crew.rank = part_of_rank();
  crew.part = crew.rank ? *crew.rank : options.part.empty() ? SweepPart{} : part_from(options.part);
  crew.claims = crew.rank.has_value() || options.claims;
  crew.is_first = crew.part.index == 0 && options.part.empty();
  return crew;
}

void tell_first(const Study& study) {
  for (const std::string& warning : study.warnings) print_message("{}", warning);
  print_notes(study.notes);
  if (!study.is_tuned) print_message("sweep: each case is analysed anew: {}\n", study.why_not_tuned);
}

int run(const SweepOptions& options) {
  check(options);
  const Study study = read_study(options.study);
  require_other_file(options.file, files_read(options, study));
  require_study_apart(options, study);
  if (!options.slurm.empty()) return write_slurm_script(options, study);
  const std::string words = description(study);
  const Crew crew = crew_of(options);
  std::optional<Claims> claims;
  if (crew.claims) {
    claims.emplace(options.file, crew.rank ? job_of_rank() : "", [&] {
      if (options.restart) remove_journals(options.file, 0);
    });
    if (!claims->has_locks()) claims.reset();
  }
  const bool restarts = options.restart && !claims;
  CaseResults results;
  if (!restarts) {
    add_journals(options.file, words, results);
  } else if (crew.is_first) {
    remove_journals(options.file, crew.part.count);
  }
  if (!options.study.keep.empty()) std::filesystem::create_directories(options.study.keep);
  SweepWork work{.study = study,
                 .table = options.file,
                 .description = words,
                 .part = crew.part,
                 .claims = claims ? &*claims : nullptr,
                 .jobs = options.jobs > 0 ? options.jobs
                         : crew.rank      ? 1
                                          : processors(),
                 .gathers = crew.is_first,
                 .tells_notes = crew.is_first};
  const auto is_own = [&](const auto& one) { return claims || crew.part.has(one.first); };
  const long own = claims || crew.part.count == 1 ? study.grid.size() : cases_of(crew.part, study.grid.size());
  const auto known = [&] { return static_cast<long>(std::count_if(results.begin(), results.end(), is_own)); };
  Journal journal(journal_path(options.file, crew.part), words, restarts);
  if (crew.is_first) tell_first(study);
  if (crew.is_first && known() > 0) print_message("sweep: {} of {} cases were done before\n", known(), own);
  long done = 0;
  try {
    done = work_on(work, journal, results);
  } catch (const Interrupted&) {
    print_message("sweep: interrupted: {} of {} cases are done, {} keeps them; run the same command again to go on\n",
                  known(), own, journal_path(options.file, crew.part).string());
    throw;
  }
  if (!options.part.empty()) {
    const long cases = claims ? done : own;
    print(options.json ? json_text({{"part", options.part}, {"cases", cases}})
                       : fmt::format("part {}: {} cases\n", options.part, cases));
  } else if (crew.is_first) {
    finish(options, study, results);
  }
  return kDone;
}

}  // namespace

void add_sweep(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<SweepOptions>();
  NamedCommand command =
      application.add_command("sweep", "run a parameter study: metrics of a motion over a grid of values");
  command.footer(
      "Example: mbgen sweep models/coach.json --vary speed=15:5:25 --vary bar_front=6e3,8e3,10e3 \\\n"
      "             --metric \"max(abs(roll)) * 57.3\" --metric \"rms(yaw_rate)\" --out sweep.csv\n"
      "Metrics are expressions over outputs, z.NAME, zd.NAME, t, inputs and parameters; functions of a whole motion:\n"
      "  max(x) min(x) mean(x) rms(x) range(x) initial(x) final(x) at(1.5, x)\n"
      "A name may stand in front: --metric \"lean=max(abs(roll))\".\n"
      "FILE.journal lists the finished cases: a study that was killed goes on from there when it is run again with\n"
      "the same words.\n"
      "With --manoeuvre each case is driven as simulate drives it; --vary takes numbers of its file too:\n"
      "  mbgen sweep models/coach_driver.json --manoeuvre models/manoeuvres/step_steer.json \\\n"
      "      --vary manoeuvre.speed=15,20,25 --vary bar_front=6e3,8e3 --out study.csv\n"
      "Under mpirun or srun each rank takes the next case that none has. See docs/use/sweep.md.");
  StudyArguments& study = options->study;
  add_model_argument(command, study.model);
  command
      .add_option("--vary", study.vary,
                  "name=first:step:last or name=value,value of a parameter or input, or of a number of the manoeuvre "
                  "(manoeuvre.speed); repeat")
      .required()
      .one_value_at_a_time();
  command
      .add_option("--metric", study.metrics,
                  "an expression for a number of each motion, or name=expression; may be repeated")
      .one_value_at_a_time();
  command.add_option("--manoeuvre", study.manoeuvre,
                     "file of a manoeuvre that each case drives; its metrics are columns of the table");
  command.add_option("-o,--out", options->file, "table of the results (CSV)").required();
  const Option keep = command.add_option("--keep", study.keep, "directory for the motions of all cases (case_1.csv)");
  command.add_option("--every", study.every, "write every n-th step of a kept motion, and the last (default 1)")
      .needs(keep);
  add_set_option(command, study.set);
  add_simulation_options(command, study.simulation);
  command.add_option("--jobs", options->jobs, "cases at a time (default: one a processor; one a rank under mpirun)");
  const Option restart = command.add_flag("--restart", options->restart, "forget the finished cases and begin anew");
  const Option part = command.add_option("--part", options->part, "K/N: only the K-th of N parts, without the table");
  command
      .add_flag("--claim", options->claims, "with --part: take the next case that no other process has, not every N-th")
      .needs(part);
  command.add_option("--slurm", options->slurm, "write a script for Slurm to this file instead: an array job of parts")
      .excludes(restart)
      .excludes(part);
  command.add_option("--parts", options->parts, fmt::format("of the script for Slurm (default {})", kSlurmParts));
  add_engine_options(command, study.engine);
  add_json_option(command, options->json);
  command.callback([options, command, &exit_code] {
    options->study.has_engine = command.is_given("--engine");
    exit_code = run(*options);
  });
}

}  // namespace mbgen::cli
