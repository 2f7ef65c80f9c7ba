#pragma once
// Runs of a fit: motions of the model at values of its unknowns.

#include <functional>
#include <string>
#include <vector>

#include "workbench/fit/fit_data.hpp"
#include "workbench/search/free_model.hpp"
#include "workbench/search/series.hpp"

namespace mbgen::fit {

/// Series of the quantities of a source, or the reason why there are none.
struct Outcome {
  std::string failure;
  std::vector<Series> series;         ///< one for each channel of a run, or measure of a source
  std::vector<std::string> warnings;  ///< of a judged motion
  /// Of an exact evaluation: derivatives of the series by each free parameter, in the order of the unknowns.
  std::vector<std::vector<Series>> derivatives = {};
};

/// How a motion is computed.
enum class Care {
  quick,  ///< for the search
  exact,  ///< likewise, with derivatives where the model has `tangents`
  judged  ///< with all watchers, whose doubts are warnings
};

/// The motion of a run at values of the unknowns; run: its number among all files. is_stopped: asked after every step.
Outcome motion_of(const FreeModel& model, const MeasuredFile& file, int run, const std::vector<Channel>& channels,
                  const std::vector<Unknown>& unknowns, const std::vector<double>& values, Care care,
                  const std::function<bool()>& is_stopped);

}  // namespace mbgen::fit
