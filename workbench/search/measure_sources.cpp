#include "workbench/search/measure_sources.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/search/rig.hpp"
#include "workbench/search/series.hpp"
#include "workbench/search/start_values.hpp"

namespace mbgen {
namespace {

bool is_of_start(const Measure& measure) { return measure.of == Measure::Of::start || measure.of == Measure::Of::mode; }
bool is_of_rig(const Measure& measure) { return measure.of == Measure::Of::figure || measure.of == Measure::Of::curve; }

/// The source that gives a measure, added where there is none.
MeasureSource& source_for(const Measure& measure, const SourceArguments& arguments,
                          std::vector<MeasureSource>& sources) {
  const MeasureSource::Of of = is_of_start(measure) ? MeasureSource::Of::start
                               : is_of_rig(measure) ? MeasureSource::Of::rig
                                                    : MeasureSource::Of::motion;
  std::string name = "start";
  if (of == MeasureSource::Of::rig) name = "kc:" + measure.axle;
  if (of == MeasureSource::Of::motion)
    name = arguments.manoeuvres.empty() ? "motion" : arguments.manoeuvres[static_cast<std::size_t>(measure.motion)];
  for (MeasureSource& source : sources)
    if (source.of == of && source.name == name) return source;
  sources.push_back({.of = of, .name = std::move(name), .axle = measure.axle, .rig = arguments.rig});
  return sources.back();
}

/// Whether a measure takes derivatives along a curve, or its curve an amplitude that they give.
bool needs_rates(const Measure& measure, const KcReport& outline) {
  const bool has_amplitude = std::ranges::any_of(measure.at, [](double at) { return at != 0; });
  if (measure.of == Measure::Of::figure || !has_amplitude) return true;
  const KcTable* curve = table_named(outline, measure.curve);
  const Column* column = curve == nullptr ? nullptr : column_of(*curve, measure.part);
  return column == nullptr || std::ranges::count(curve->rates, column->heading.name) > 0;
}

/// The curves that a rig has to give, as far and in as many points as they are wanted.
void prepare_rig(const FreeModel& model, const std::vector<Measure>& measures, RigReports& rigs,
                 MeasureSource& source) {
  const KcReport& outline = outline_of_rig(model, source.axle, rigs);
  KcSettings& rig = source.rig;
  rig.has_rates = false;
  for (const std::size_t q : source.measures) {
    rig.has_rates = rig.has_rates || needs_rates(measures[q], outline);
    if (measures[q].of != Measure::Of::curve) continue;
    rig.curves.push_back(measures[q].curve);
    for (const double at : measures[q].at) reach_out_to(measures[q].curve, std::abs(at), rig);
  }
  rig.points = 1;
  std::vector<double> parts;  // of the amplitudes
  for (const std::size_t q : source.measures) {
    if (measures[q].of == Measure::Of::curve && measures[q].at.empty()) rig.points = kPointsOfCurve;
    for (const double at : measures[q].at)
      if (at != 0) parts.push_back(at / *reach_of(measures[q].curve, rig));
  }
  if (!parts.empty()) rig.points = std::max(rig.points, points_among(parts));
  rig.decisions = decisions_of_rig(model, source.axle);
}

/// The study of a motion at the start values, with its solver.
void prepare_motion(const FreeModel& model, const std::vector<Unknown>& unknowns, const std::vector<Measure>& measures,
                    const SourceArguments& arguments, MeasureSource& source) {
  StudyArguments study;
  study.model = model.arguments.path;
  study.set = model.arguments.set;
  study.vary_option = "--free";
  study.simulation = model.arguments.simulation;
  study.engine = model.arguments.engine;
  study.has_engine = model.arguments.has_engine;
  if (!arguments.manoeuvres.empty()) study.manoeuvre = source.name;
  for (const Unknown& unknown : unknowns)
    if (unknown.kind == Unknown::Kind::parameter)
      study.vary.push_back(fmt::format("{}={}", unknown.name, unknown.start));
  for (const std::size_t q : source.measures) {
    const auto found = std::ranges::find(study.metrics, measures[q].part);
    const auto place = static_cast<std::size_t>(found - study.metrics.begin());
    const bool is_metric = measures[q].of == Measure::Of::metric;
    if (is_metric && found == study.metrics.end()) study.metrics.push_back(measures[q].part);
    source.places.push_back(is_metric ? place : 0);
  }
  study.metric_option = fmt::format("metric \"{}\"", fmt::join(study.metrics, "\", \""));
  source.study = read_study(study);
  source.solver = prepare(source.study);
  source.why_differences = add_derivatives(source.study, source.solver);
}

/// Values of a column at wanted abscissas.
Response response_of(const Measure& measure, const KcTable& curve, const Column& column) {
  Response response{column.heading.unit, curve.columns.front().values, column.values, curve.columns.front().heading};
  if (measure.at.empty()) return response;
  const Series series{response.at, response.values};
  response.at = measure.at;
  response.values.clear();
  for (const double wanted : measure.at) response.values.push_back(at(series, wanted).value);
  return response;
}

Response figure_of(const Measure& measure, const KcReport& report) {
  std::vector<std::string> names;
  for (const KcFigure& figure : report.figures) {
    for (const auto& [end, place] : {std::pair{"", 0}, {"_left", 0}, {"_right", 1}})
      if (measure.part == figure.name + end && place < static_cast<int>(figure.values.size()))
        return {figure.unit, {}, {figure.values[static_cast<std::size_t>(place)]}};
    names.push_back(figure.name);
  }
  throw UserError(fmt::format("{}: the rig gives no figure \"{}\"\n{}", measure.name, measure.part,
                              nearest_hint(measure.part, names)));
}

Response curve_of(const Measure& measure, const KcReport& report, int points) {
  std::vector<std::string> names;
  const KcTable* curve = table_named(report, measure.curve);
  for (const KcTable& table : report.tables) names.push_back(table.name);
  if (curve == nullptr)
    throw UserError(fmt::format("{}: the rig has no curve \"{}\"\n{}", measure.name, measure.curve,
                                nearest_hint(measure.curve, names)));
  if (static_cast<int>(curve->columns.front().values.size()) < points)
    throw UserError(fmt::format("{}: the curve {} ends early\n", measure.name, measure.curve));
  if (const Column* column = column_of(*curve, measure.part)) return response_of(measure, *curve, *column);
  names.clear();
  for (const Column& column : curve->columns) names.push_back(column.heading.name);
  throw UserError(fmt::format("{}: the curve {} has no column \"{}\"\n{}", measure.name, measure.curve, measure.part,
                              nearest_hint(measure.part, names)));
}

void evaluate_rig(const MeasureSource& source, const FreeModel& model, const std::vector<Measure>& measures,
                  const Compilation& compilation, const std::function<bool()>& is_stopped, SourceValues& result) {
  const KcWatch watch = [&](long, long) { return !(is_stopped && is_stopped()); };
  const KcReport report = rig_report(compilation, model.arguments, source.axle, source.rig, watch);
  for (const std::size_t q : source.measures)
    result.responses.push_back(measures[q].of == Measure::Of::curve ? curve_of(measures[q], report, source.rig.points)
                                                                    : figure_of(measures[q], report));
}

Response number_of(const Measure& measure, const CaseResult& found) {
  std::vector<std::string> names;
  for (const ManoeuvreResult& one : found.of_manoeuvre) {
    if (one.name == measure.part) return {one.unit, {}, {one.value}};
    names.push_back(one.name);
  }
  const std::string hint = nearest_hint(measure.part, names);
  throw UserError(fmt::format("{}: the manoeuvre gives no number \"{}\"\n{}", measure.name, measure.part,
                              hint.empty() ? fmt::format("  hint: it gives {}\n", fmt::join(names, ", ")) : hint));
}

void evaluate_motion(const MeasureSource& source, const std::vector<Measure>& measures,
                     const std::vector<double>& values, bool with_derivatives, const std::function<bool()>& is_stopped,
                     SourceValues& result) {
  const std::optional<CaseResult> found =
      run_at(source.study, source.solver, {values, "", with_derivatives}, is_stopped);
  if (!found) throw UserError("interrupted\n");
  if (!found->has_values()) throw UserError(found->status + "\n");
  if (found->is_warned()) result.warnings.push_back(found->status.substr(std::string("warning: ").size()));
  for (std::size_t k = 0; k < source.measures.size(); ++k) {
    const Measure& measure = measures[source.measures[k]];
    if (measure.of == Measure::Of::manoeuvre) {
      result.responses.push_back(number_of(measure, *found));
      continue;
    }
    Response response{measure.unit, {}, {found->metrics[source.places[k]]}};
    for (const std::vector<double>& by : found->derivatives) response.derivatives.push_back({by[source.places[k]]});
    result.responses.push_back(std::move(response));
  }
}

}  // namespace

MeasureSet with_sources(const FreeModel& model, const std::vector<Unknown>& unknowns, std::vector<Measure> measures,
                        const SourceArguments& arguments, RigReports& rigs) {
  MeasureSet set{std::move(measures), {}};
  for (std::size_t q = 0; q < set.measures.size(); ++q)
    source_for(set.measures[q], arguments, set.sources).measures.push_back(q);
  for (MeasureSource& source : set.sources) {
    if (source.of == MeasureSource::Of::rig) prepare_rig(model, set.measures, rigs, source);
    if (source.of == MeasureSource::Of::motion) prepare_motion(model, unknowns, set.measures, arguments, source);
  }
  return set;
}

SourceValues evaluate(const MeasureSource& source, const FreeModel& model, const std::vector<Unknown>& unknowns,
                      const std::vector<Measure>& measures, const std::vector<double>& values, bool with_derivatives,
                      const std::function<bool()>& is_stopped) {
  SourceValues result;
  try {
    if (source.of == MeasureSource::Of::motion) {
      std::vector<double> parameters;
      for (std::size_t u = 0; u < unknowns.size(); ++u)
        if (unknowns[u].kind == Unknown::Kind::parameter) parameters.push_back(values[u]);
      evaluate_motion(source, measures, parameters, with_derivatives, is_stopped, result);
    } else if (source.of == MeasureSource::Of::rig) {
      evaluate_rig(source, model, measures, compilation_at(model, unknowns, values), is_stopped, result);
    } else {
      std::vector<Measure> own;
      for (const std::size_t q : source.measures) own.push_back(measures[q]);
      const std::vector<double> numbers = start_values(model, own, unknowns, values);
      for (std::size_t k = 0; k < own.size(); ++k) result.responses.push_back({own[k].unit, {}, {numbers[k]}});
    }
  } catch (const UserError& error) {
    result.failure = error.what();
    while (result.failure.ends_with('\n')) result.failure.pop_back();
    return result;
  }
  for (std::size_t k = 0; k < result.responses.size(); ++k)
    for (const double value : result.responses[k].values)
      if (!std::isfinite(value))
        result.failure =
            fmt::format("{} is {}", measures[source.measures[k]].name, std::isnan(value) ? "nan" : "infinite");
  return result;
}

}  // namespace mbgen
