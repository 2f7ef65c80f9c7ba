#pragma once
// Goals and constraints of a design, as typed and as numbers.
//
//   GOAL        [NAME=]min:MEASURE[:SCALE], max:MEASURE[:SCALE] or min:MEASURE~TARGET[:SCALE]
//   CONSTRAINT  MEASURE<=LIMIT, MEASURE>=LIMIT, MEASURE==VALUE or LOW<=MEASURE<=HIGH
// TARGET and LIMIT: a number with or without a unit, or for curves of a rig a table of points. SCALE is in the unit of
// the measure. Measures: workbench/search/measure.hpp.

#include <string>
#include <vector>

#include "workbench/search/measure_sources.hpp"

namespace mbgen::optimise {

struct Goal {
  enum class Kind { least, largest, target };
  Kind kind = Kind::least;
  std::string name;
  std::size_t measure = 0;
  std::string target_text = {};     ///< as typed
  std::vector<double> target = {};  ///< one number, or one for each point of the curve
  double scale = 1;                 ///< of the measure
  bool has_scale = false;           ///< it was given; else it follows from the start
};

/// A constraint is broken beyond this part of its largest limit, or of the measure at the start where the limit is 0.
constexpr double kPartBroken = 1e-6;

struct Constraint {
  enum class Kind { at_most, at_least, equal };
  Kind kind = Kind::at_most;
  std::string name;  ///< as typed
  std::size_t measure = 0;
  std::string limit_text = {};
  std::vector<double> limit = {};  ///< as Goal::target
  double scale = 1;                ///< size of the measure, for the search
  double tolerance = 0;            ///< of the measure: it is broken beyond
};

/// Goals and constraints with their measures.
struct Wishes {
  std::vector<Goal> goals;
  std::vector<Constraint> constraints;
  std::vector<Measure> measures;
  std::vector<std::string> files = {};  ///< tables that were read
};

/// Reads the texts, with the tables of curves. Limits with a unit are numbers after set_numbers. rigs: outlines for
/// their names, afterwards. Fails: UserError.
Wishes read_wishes(const FreeModel& model, const std::vector<std::string>& goals,
                   const std::vector<std::string>& constraints, const std::vector<std::string>& manoeuvres,
                   RigReports& rigs);

/// Turns targets and limits into numbers of the measures' units, and sets scales that were not given by the responses
/// at the start, one for each measure. Fails: UserError for a unit of another dimension.
void set_numbers(const std::vector<Response>& start, Wishes& wishes);

}  // namespace mbgen::optimise
