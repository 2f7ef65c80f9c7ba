// The work of a fit: runs, and sources of measures that several channels share.

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "compiler/program/in_threads.hpp"
#include "workbench/fit/fit_problem.hpp"
#include "workbench/fit/rig_curve.hpp"
#include "workbench/host/message.hpp"

namespace mbgen::fit {
namespace {

/// Adds the sources of the measures of rig curves and targets; held: of the files that are held out.
void add_sources(const std::vector<std::string>& manoeuvres, bool held, RigReports& rigs, FitProblem& problem) {
  std::vector<Measure> measures;
  std::vector<MeasuredChannel*> channels;
  std::vector<std::string> paths;
  for (MeasuredFile& file : problem.files)
    for (MeasuredChannel& measured : file.channels) {
      if (file.is_run() || file.is_held_out != held) continue;
      measures.push_back(measure_of(file, measured, problem.channels[static_cast<std::size_t>(measured.channel)]));
      channels.push_back(&measured);
      paths.push_back(file.path);
    }
  if (measures.empty()) return;
  MeasureSet set = with_sources(problem.model, problem.unknowns, std::move(measures), {manoeuvres, {}}, rigs);
  const std::size_t before = problem.measures.measures.size();
  for (MeasureSource& source : set.sources) {
    Work work{.name = paths[source.measures.front()],
              .is_held_out = held,
              .source = static_cast<int>(problem.measures.sources.size())};
    for (std::size_t k = 0; k < source.measures.size(); ++k) {
      channels[source.measures[k]]->work = problem.works.size();
      channels[source.measures[k]]->place = k;
      source.measures[k] += before;
    }
    problem.works.push_back(std::move(work));
    problem.measures.sources.push_back(std::move(source));
  }
  for (Measure& measure : set.measures) problem.measures.measures.push_back(std::move(measure));
}

Outcome outcome_of_source(const FitProblem& problem, const MeasureSource& source, const std::vector<double>& values,
                          Care care) {
  const SourceValues found = evaluate(source, problem.model, problem.unknowns, problem.measures.measures, values,
                                      care == Care::exact && source.has_derivatives(), problem.is_stopped);
  if (!found.failure.empty()) return {first_line(found.failure), {}, {}};
  Outcome outcome;
  outcome.warnings = found.warnings;
  const auto series = [](const Response& response, const std::vector<double>& numbers) {
    return Series{response.at.empty() ? std::vector<double>{0} : response.at, numbers};
  };
  const std::size_t parameters = found.responses.front().derivatives.size();
  outcome.derivatives.resize(parameters);
  for (const Response& response : found.responses) {
    outcome.series.push_back(series(response, response.values));
    for (std::size_t p = 0; p < parameters; ++p)
      outcome.derivatives[p].push_back(series(response, response.derivatives[p]));
  }
  return outcome;
}

}  // namespace

void run_tasks(const FitProblem& problem, std::size_t count, const std::function<void(std::size_t)>& task) {
  std::mutex guard;
  long done = 0;
  const auto run = [&](std::size_t k) {
    if (!problem.is_stopped || !problem.is_stopped()) task(k);
    const std::lock_guard<std::mutex> lock(guard);
    if (problem.progress) problem.progress(++done, static_cast<long>(count));
  };
  in_threads(count, run, static_cast<std::size_t>(problem.jobs));
}

void plan_work(const std::vector<std::string>& manoeuvres, RigReports& rigs, FitProblem& problem) {
  for (std::size_t f = 0; f < problem.files.size(); ++f) {
    MeasuredFile& file = problem.files[f];
    if (!file.is_run()) continue;
    for (std::size_t c = 0; c < file.channels.size(); ++c) {
      file.channels[c].work = problem.works.size();
      file.channels[c].place = c;
    }
    problem.works.push_back({.name = file.path, .is_held_out = file.is_held_out, .run = static_cast<int>(f)});
  }
  for (const bool held : {false, true}) add_sources(manoeuvres, held, rigs, problem);
}

Outcome outcome_of(const FitProblem& problem, const Work& work, const std::vector<double>& values, Care care) {
  if (work.source >= 0)
    return outcome_of_source(problem, problem.measures.sources[static_cast<std::size_t>(work.source)], values, care);
  const MeasuredFile& file = problem.files[static_cast<std::size_t>(work.run)];
  return motion_of(problem.model, file, work.run, problem.channels, problem.unknowns, values, care, problem.is_stopped);
}

std::vector<Outcome> outcomes_of(const FitProblem& problem, const std::vector<double>& values, Care care,
                                 const std::function<bool(const Work&)>& is_wanted) {
  std::vector<Outcome> outcomes(problem.works.size());
  run_tasks(problem, outcomes.size(), [&](std::size_t w) {
    if (is_wanted(problem.works[w])) outcomes[w] = outcome_of(problem, problem.works[w], values, care);
  });
  return outcomes;
}

const Series* series_of(const std::vector<Outcome>& outcomes, const MeasuredChannel& measured) {
  const Outcome& outcome = outcomes[measured.work];
  return outcome.failure.empty() && measured.place < outcome.series.size() ? &outcome.series[measured.place] : nullptr;
}

}  // namespace mbgen::fit
