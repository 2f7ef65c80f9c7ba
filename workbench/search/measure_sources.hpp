#pragma once
// The work that gives measures at values of the free parameters: states, rigs, motions, each once for all measures.

#include <functional>
#include <string>
#include <vector>

#include "workbench/kc/kc.hpp"
#include "workbench/search/free_model.hpp"
#include "workbench/search/measure.hpp"
#include "workbench/search/rig.hpp"
#include "workbench/sweep/sweep_case.hpp"

namespace mbgen {

/// A source of measures. Its motion moves with exact derivatives where its solver has them.
struct MeasureSource {
  enum class Of { start, rig, motion };
  Of of = Of::start;
  std::string name;                        ///< for messages: "start", "kc:front", a file, or "motion"
  std::vector<std::size_t> measures = {};  ///< places in the list
  std::string axle = {};                   ///< of a rig
  KcSettings rig = {};
  Study study = {};  ///< of a motion
  StudySolver solver = {};
  std::vector<std::size_t> places = {};  ///< of a motion: of each measure among the metrics; of a number none
  std::string why_differences = {};      ///< the reason why it has no exact derivatives, "" where it has them

  bool has_derivatives() const { return of == Of::motion && solver.tangents != nullptr; }
};

/// Motions and rigs as typed, beside the model.
struct SourceArguments {
  std::vector<std::string> manoeuvres;
  KcSettings rig;
};

/// Measures and the work that gives them.
struct MeasureSet {
  std::vector<Measure> measures;
  std::vector<MeasureSource> sources;
};

/// The measures with their sources; analyses and compiles for motions. rigs: outlines that are known, and more
/// afterwards. Requires: prepare(model). Fails: UserError.
MeasureSet with_sources(const FreeModel& model, const std::vector<Unknown>& unknowns, std::vector<Measure> measures,
                        const SourceArguments& arguments, RigReports& rigs);

/// A measure at values of the free parameters.
struct Response {
  std::string unit = {};
  std::vector<double> at = {}, values = {};           ///< of a single number one value, and no `at`
  Heading abscissa = {};                              ///< of a curve
  std::vector<std::vector<double>> derivatives = {};  ///< by each free parameter, in the order of the unknowns; or none
};

/// The measures of a source, in its order, or the reason why there are none.
struct SourceValues {
  std::string failure;
  std::vector<Response> responses = {};
  std::vector<std::string> warnings = {};
};

/// The measures of a source at values of the unknowns. is_stopped: asked while a motion or a rig moves.
SourceValues evaluate(const MeasureSource& source, const FreeModel& model, const std::vector<Unknown>& unknowns,
                      const std::vector<Measure>& measures, const std::vector<double>& values, bool with_derivatives,
                      const std::function<bool()>& is_stopped);

}  // namespace mbgen
