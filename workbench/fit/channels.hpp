#pragma once
// Channels of a fit: outputs of the model with the columns that measure them, and their nuisance values.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/search/measure.hpp"
#include "workbench/search/unknowns.hpp"

namespace mbgen::fit {

/// A measured quantity.
struct Channel {
  std::string name;                      ///< as typed: an output of the model, or "kc:AXLE:COLUMN"
  std::string column = {};               ///< of the data, by default its name
  std::string unit = {};                 ///< of the model; of a rig's column unknown before the rig has run
  int output = -1;                       ///< index into Model::outputs; -1 of a rig
  std::string axle = {}, quantity = {};  ///< of a rig
  std::optional<Measure> measure = {};   ///< a single number, of --target
  double sigma = 1;                      ///< standard deviation of its noise, in the unit
  bool has_sigma = false;                ///< it was given; else it is estimated
  int gain = -1, bias = -1, delay = -1;  ///< index of the unknown, -1: one, zero, zero

  bool is_of_rig() const { return !axle.empty(); }
  bool is_of_point() const { return measure.has_value(); }
};

/// Channels of --match: OUTPUT[=COLUMN][:SIGMA] or kc:AXLE:COLUMN[=COLUMN][:SIGMA], separated by commas. Fails:
/// UserError for an output that the model lacks (with the nearest), one that stands twice, a sigma that is no positive
/// number.
std::vector<Channel> matched_channels(const Model& model, const std::vector<std::string>& texts);

/// Nuisance values of --nuisance: OUTPUT:gain[:bias][:delay], separated by commas; `*` for all channels. Adds their
/// unknowns. Fails: UserError for an unknown channel or word.
void add_nuisances(const std::vector<std::string>& texts, std::vector<Channel>& channels,
                   std::vector<Unknown>& unknowns);

/// Limits of a gain and of a delay, s; of a bias, in standard deviations of its channel's data around their mean
/// (set_bias_bounds).
constexpr double kLeastGain = 0.1, kMostGain = 10, kMostDelay = 0.5, kMostBias = 100;

}  // namespace mbgen::fit
