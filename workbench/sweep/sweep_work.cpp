#include "workbench/sweep/sweep_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "compiler/text/user_error.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/sweep/sweep_case.hpp"

namespace mbgen {
namespace {

using std::chrono::steady_clock;

/// Polling interval of a process that waits for the others, at first and at last.
constexpr std::chrono::milliseconds kFirstLook{10}, kLastLook{1000};
/// Timeout without another process at work.
constexpr std::chrono::minutes kPatience{5};
/// Silent part of this timeout.
constexpr std::chrono::seconds kSilence{5};

/// Hands out cases, each once.
class Cases {
 public:
  Cases(std::vector<long> list, Claims* claims) : list_(std::move(list)), claims_(claims) {}
  long size() const { return static_cast<long>(list_.size()); }
  std::optional<long> next() {
    const std::lock_guard<std::mutex> lock(guard_);
    while (place_ < list_.size()) {
      const long index = list_[place_++];
      if (!claims_ || claims_->take(index)) return index;
    }
    return {};
  }

 private:
  std::vector<long> list_;
  Claims* claims_;
  std::mutex guard_;
  std::size_t place_ = 0;
};

std::vector<long> missing_cases(const SweepWork& work, const CaseResults& results) {
  std::vector<long> list;
  for (long index = 0; index < work.study.grid.size(); ++index)
    if ((work.claims || work.part.has(index)) && !results.contains(index)) list.push_back(index);
  return list;
}

/// Computes cases in threads. Result: their number.
long compute(const SweepWork& work, std::optional<StudySolver>& solver, std::vector<long> list, Journal& journal,
             CaseResults& results) {
  Cases cases(std::move(list), work.claims);
  std::optional<long> first = cases.next();
  if (!first) return 0;
  if (!solver) {
    solver = prepare(work.study);
    if (work.study.is_tuned && work.tells_notes) count_notes(solver->compilation);
  }
  std::atomic<bool> is_stopped{false};
  std::exception_ptr failure;
  std::mutex guard;
  BlockedSignals signals;
  Progress progress("sweep");
  long done = 0;
  const auto is_interrupted = [&] { return signals.taken() != 0; };
  const auto compute_one = [&](long index) {
    std::optional<CaseResult> result = run_case(work.study, *solver, index, is_interrupted);
    if (!result) return;
    const std::lock_guard<std::mutex> lock(guard);
    journal.add(index, *result);
    if (work.claims) work.claims->finish(index);
    results[index] = std::move(*result);
    progress.show(++done, cases.size());
  };
  const auto take_turns = [&](std::optional<long> index) {
    for (; index && !is_stopped && !is_interrupted(); index = cases.next()) {
      try {
        compute_one(*index);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!failure) failure = std::current_exception();
        is_stopped = true;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int j = 1; j < std::min<long>(work.jobs, cases.size()); ++j)
    threads.emplace_back([&] { take_turns(cases.next()); });
  take_turns(first);
  for (std::thread& thread : threads) thread.join();
  progress.clear();
  if (failure) std::rethrow_exception(failure);
  if (is_interrupted() && (done < cases.size() || work.claims)) throw Interrupted{signals.taken()};
  return done;
}

/// Adds the results of all journals. Result: whether another process holds one.
bool look_at_others(const SweepWork& work, CaseResults& results) {
  const std::filesystem::path own = journal_path(work.table, work.part);
  bool is_at_work = false;
  for (const std::filesystem::path& path : journals_of(work.table)) {
    is_at_work = is_at_work || (path != own && is_held(path));
    try {
      results.merge(read_journal(path, work.description));
    } catch (const UserError&) {
      // With --restart: the old journal of a process that has not started yet.
    }
  }
  return is_at_work;
}

/// Waits until a case is done, or may be lost by a process. Fails: UserError after the timeout without another process
/// at work.
class Waiting {
 public:
  explicit Waiting(long size) : size_(size) {}
  void once(const SweepWork& work, CaseResults& results) {
    BlockedSignals signals;
    if (const int signal = signals.wait(look_); signal != 0) throw Interrupted{signal};
    look_ = std::min(2 * look_, kLastLook);
    const std::size_t before = results.size();
    const bool is_at_work = look_at_others(work, results);
    if (results.size() > before || is_at_work) last_seen_ = steady_clock::now();
    const auto alone = steady_clock::now() - last_seen_;
    const long missing = size_ - static_cast<long>(results.size());
    if (missing > 0 && alone > kSilence && !std::exchange(is_told_, true)) {
      print_message("sweep: {} of {} cases are missing and no other rank is at work; waits {} min for one\n", missing,
                    size_, kPatience.count());
    }
    if (missing > 0 && alone > kPatience) {
      throw UserError(fmt::format(
          "sweep: {} of {} cases are missing and no other rank is at work; run again to go on\n", missing, size_));
    }
  }

 private:
  long size_;
  std::chrono::milliseconds look_ = kFirstLook;
  steady_clock::time_point last_seen_ = steady_clock::now();
  bool is_told_ = false;
};

}  // namespace

long work_on(const SweepWork& work, Journal& journal, CaseResults& results) {
  std::optional<StudySolver> solver;
  long done = compute(work, solver, missing_cases(work, results), journal, results);
  if (!work.gathers) return done;
  const long size = work.study.grid.size();
  look_at_others(work, results);
  Waiting waiting(size);
  while (static_cast<long>(results.size()) < size) {
    waiting.once(work, results);
    if (work.claims) done += compute(work, solver, missing_cases(work, results), journal, results);
  }
  return done;
}

}  // namespace mbgen
