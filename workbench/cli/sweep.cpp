// mbgen sweep: simulations over all combinations of values, with a few metrics of each.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <utility>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/sweep/sweep_journal.hpp"
#include "workbench/sweep/sweep_parts.hpp"
#include "workbench/sweep/sweep_table.hpp"

namespace mbgen::cli {
namespace {

using std::chrono::steady_clock;

constexpr int kMostJobs = 1024;
constexpr long kSlurmParts = 8;
/// Polling interval of a rank that waits for the others, at first and at last.
constexpr std::chrono::milliseconds kFirstLook{10}, kLastLook{1000};
/// Timeout without another rank at work.
constexpr std::chrono::minutes kPatience{5};
/// Silent part of this timeout.
constexpr std::chrono::seconds kSilence{5};

struct SweepOptions {
  StudyArguments study;
  std::string file, part, slurm;
  int jobs = 0;  ///< 0: one per processor
  long parts = kSlurmParts;
  bool restart = false, json = false;
};

/// Adds the cases of the journals beside the table. Fails: as read_journal.
void add_journals(const std::string& table, const std::string& words, CaseResults& results) {
  for (const std::filesystem::path& path : journals_of(table)) results.merge(read_journal(path, words));
}

/// Computes cases in `jobs` threads; a result is written to the journal before it counts. Fails: as run_case and
/// Journal::add, with the first failure after all threads have ended.
void compute(const Study& study, const std::vector<long>& cases, int jobs, bool tells_notes, Journal& journal,
             CaseResults& results) {
  const StudySolver solver = prepare(study);
  if (study.is_tuned && tells_notes) count_notes(solver.compilation);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_stopped{false};
  std::exception_ptr failure;
  std::mutex guard;
  BlockedSignals signals;
  Progress progress("sweep");
  long done = 0;
  const auto is_interrupted = [&] { return signals.taken() != 0; };
  const auto compute_one = [&](long index) {
    std::optional<CaseResult> result = run_case(study, solver, index, is_interrupted);
    if (!result) return;
    const std::lock_guard<std::mutex> lock(guard);
    journal.add(index, *result);
    results[index] = std::move(*result);
    progress.show(++done, static_cast<long>(cases.size()));
  };
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size() && !is_stopped && !is_interrupted(); i = next++) {
      try {
        compute_one(cases[i]);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!failure) failure = std::current_exception();
        is_stopped = true;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int j = 1; j < std::min<long>(jobs, static_cast<long>(cases.size())); ++j) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  progress.clear();
  if (failure) std::rethrow_exception(failure);
  if (is_interrupted() && done < static_cast<long>(cases.size())) throw Interrupted{signals.taken()};
}

/// Waits until the other ranks have written all cases. Fails: UserError after the timeout without another rank at work.
void gather(const SweepOptions& options, const std::string& words, const SweepPart& part, long size,
            CaseResults& results) {
  BlockedSignals signals;
  auto look = kFirstLook;
  auto last_seen = steady_clock::now();
  bool is_told = false;
  while (static_cast<long>(results.size()) < size) {
    if (const int signal = signals.wait(look); signal != 0) throw Interrupted{signal};
    look = std::min(2 * look, kLastLook);
    const std::size_t before = results.size();
    bool is_at_work = false;
    for (long k = 0; k < part.count; ++k) {
      const std::filesystem::path path = journal_path(options.file, {k, part.count});
      is_at_work = is_at_work || (k != part.index && is_held(path));
      try {
        results.merge(read_journal(path, words));
      } catch (const UserError&) {
        // With --restart: the old journal of a rank that has not started yet.
      }
    }
    if (results.size() > before || is_at_work) last_seen = steady_clock::now();
    const auto alone = steady_clock::now() - last_seen;
    if (alone > kSilence && !std::exchange(is_told, true)) {
      print_message("sweep: {} of {} cases are missing and no other rank is at work; waits {} min for one\n",
                    size - static_cast<long>(results.size()), size, kPatience.count());
    }
    if (alone > kPatience) {
      throw UserError(
          fmt::format("sweep: {} of {} cases are missing and no other rank is at work; run again to go on\n",
                      size - static_cast<long>(results.size()), size));
    }
  }
}

/// With --restart: removes journals of other partitions, which no process would restart.
void remove_other_journals(const SweepOptions& options, const SweepPart& part) {
  std::vector<std::filesystem::path> own;
  for (long k = 0; k < part.count; ++k) own.push_back(journal_path(options.file, {k, part.count}));
  for (const std::filesystem::path& path : journals_of(options.file)) {
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
  files.push_back(options.study.simulation.input_table);
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

int run(const SweepOptions& options) {
  check(options);
  const Study study = read_study(options.study);
  require_other_file(options.file, files_read(options, study));
  if (!options.slurm.empty()) return write_slurm_script(options, study);
  const std::string words = description(study);
  const std::optional<SweepPart> rank = options.part.empty() ? part_of_rank() : std::nullopt;
  const SweepPart part = rank ? *rank : options.part.empty() ? SweepPart{} : part_from(options.part);
  const bool is_first = part.index == 0 && options.part.empty();
  for (const std::string& warning : study.warnings) {
    if (is_first) print_message("{}", warning);
  }
  CaseResults results;
  if (!options.restart) {
    add_journals(options.file, words, results);
  } else if (is_first) {
    remove_other_journals(options, part);
  }
  std::vector<long> cases;
  long of_part = 0;
  for (long index = 0; index < study.grid.size(); ++index) {
    if (!part.has(index)) continue;
    ++of_part;
    if (!results.contains(index)) cases.push_back(index);
  }
  Journal journal(journal_path(options.file, part), words, options.restart);
  const long before = of_part - static_cast<long>(cases.size());
  if (is_first && !study.is_tuned) print_message("sweep: each case is analysed anew: {}\n", study.why_not_tuned);
  if (is_first && before > 0) print_message("sweep: {} of {} cases were done before\n", before, of_part);
  const int jobs = options.jobs > 0 ? options.jobs : rank ? 1 : processors();
  try {
    if (!cases.empty()) compute(study, cases, jobs, is_first, journal, results);
    if (is_first) gather(options, words, part, study.grid.size(), results);
  } catch (const Interrupted&) {
    print_message("sweep: interrupted: {} of {} cases are done, {} keeps them; run the same command again to go on\n",
                  std::erase_if(results, [&](const auto& one) { return part.has(one.first); }), of_part,
                  journal_path(options.file, part).string());
    throw;
  }
  if (!options.part.empty()) {
    print(options.json ? json_text({{"part", options.part}, {"cases", of_part}})
                       : fmt::format("part {}: {} cases\n", options.part, of_part));
  } else if (is_first) {
    finish(options, study, results);
  }
  return kDone;
}

}  // namespace

void add_sweep(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<SweepOptions>();
  NamedCommand command =
      application.add_command("sweep", "a parameter study: metrics of a motion over a grid of values");
  command.footer(
      "Example: mbgen sweep models/coach.json --vary speed=15:5:25 --vary bar_front=6e3,8e3,10e3 \\\n"
      "             --metric \"max(abs(roll)) * 57.3\" --metric \"rms(yaw_rate)\" --out sweep.csv\n"
      "Metrics are expressions over outputs, z.NAME, zd.NAME, t, inputs and parameters; functions of a whole motion:\n"
      "  max(x) min(x) mean(x) rms(x) range(x) initial(x) final(x) at(1.5, x)\n"
      "A name may stand in front: --metric \"lean=max(abs(roll))\".\n"
      "FILE.journal lists the finished cases: a study that was killed goes on from there when it is run again with\n"
      "the same words.\n"
      "Under mpirun or srun the ranks share the cases. See docs/use/sweep.md.");
  StudyArguments& study = options->study;
  add_model_argument(command, study.model);
  command.add_option("--vary", study.vary, "name=first:step:last or name=value,value of a parameter or input; repeat")
      .required()
      .one_value_at_a_time();
  command.add_option("--metric", study.metrics, "a number of each motion, or name=number; may be repeated")
      .required()
      .one_value_at_a_time();
  command.add_option("-o,--out", options->file, "table of the results (CSV)").required();
  add_set_option(command, study.set);
  add_simulation_options(command, study.simulation);
  command.add_option("--jobs", options->jobs, "cases at a time (default: one a processor; one a rank under mpirun)");
  const Option restart = command.add_flag("--restart", options->restart, "forget the finished cases and begin anew");
  const Option part = command.add_option("--part", options->part, "K/N: only the K-th of N parts, without the table");
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
