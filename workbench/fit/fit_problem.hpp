#pragma once
// Residuals of a fit and their derivatives by its unknowns: the narrow interface between the model and the method.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "workbench/fit/fit_motion.hpp"
#include "workbench/fit/physical_inertias.hpp"
#include "workbench/search/measure_sources.hpp"

namespace mbgen::fit {

/// A run, or a source of measures: computed once for all the channels that it gives.
struct Work {
  std::string name;  ///< for messages: the first file that it serves
  bool is_held_out = false;
  int run = -1;     ///< its file, -1 of a source
  int source = -1;  ///< among those of the measures, -1 of a run
};

/// A fit that was read and checked.
struct FitProblem {
  const FreeModel& model;
  std::vector<Channel> channels;
  std::vector<Unknown> unknowns;
  std::vector<FreeInertia> inertias;  ///< among the unknowns
  std::vector<MeasuredFile> files;
  MeasureSet measures = {};  ///< of rig curves and targets
  std::vector<Work> works = {};
  int jobs = 1;                                   ///< evaluations of the model at a time
  std::function<bool()> is_stopped = {};          ///< thread-safe
  std::function<void(long, long)> progress = {};  ///< evaluations done and to be done, from one thread at a time
};

/// Residuals (model - data) / sigma, file by file, channel by channel, row by row; or the reason why there are none.
struct Residuals {
  Eigen::VectorXd values;
  std::string failure;
};

/// Their derivatives, a row a residual, a column an unknown, beside the residuals themselves.
struct Jacobian {
  Eigen::MatrixXd values;
  Eigen::VectorXd residuals;
  std::string failure;
};

/// Number of residuals of the fitted files (held: of the held-out ones).
int residual_count(const FitProblem& problem, bool held = false);

/// Residuals of the fitted files at values of the unknowns.
Residuals residuals(const FitProblem& problem, const std::vector<double>& values);

/// Derivatives of the residuals of the fitted files: of motions by parameters exactly, where the model has `tangents`,
/// of metrics likewise, and by gain, bias and delay; by the other unknowns that move the model by central differences,
/// at a bound, or where the model has no result on one side, by differences to the other, all of second order, with
/// steps of 1e-4 of the unknown's scale: errors near 1e-8.
Jacobian jacobian(const FitProblem& problem, const std::vector<double>& values);

/// Kind of the derivatives by the unknowns that move the model, in words.
std::string kind_of_derivatives(const FitProblem& problem);

/// The work that the channels of the files ask for. Sets the problem's measures and works, and the places of the
/// channels in them. rigs: outlines that are known. Requires: prepare(model). Fails: UserError.
void plan_work(const std::vector<std::string>& manoeuvres, RigReports& rigs, FitProblem& problem);

/// A work at values of the unknowns.
Outcome outcome_of(const FitProblem& problem, const Work& work, const std::vector<double>& values, Care care);

/// Runs tasks on the problem's threads; those behind a stop are left out.
void run_tasks(const FitProblem& problem, std::size_t count, const std::function<void(std::size_t)>& task);

/// Outcomes of works at values of the unknowns, in their order. is_wanted: the others stay empty.
std::vector<Outcome> outcomes_of(const FitProblem& problem, const std::vector<double>& values, Care care,
                                 const std::function<bool(const Work&)>& is_wanted);

/// The series of a channel, null where its work has none.
const Series* series_of(const std::vector<Outcome>& outcomes, const MeasuredChannel& measured);

/// Predictions of a channel of a file at its data, with gain, bias and delay.
std::vector<double> predictions(const FitProblem& problem, const MeasuredChannel& measured, const Series& series,
                                const std::vector<double>& values);

}  // namespace mbgen::fit
