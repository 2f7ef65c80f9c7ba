#pragma once
// The door of the fit room: unknowns of a model from measurements, by bounded weighted least squares.

#include <string>
#include <vector>

#include "workbench/fit/certainty.hpp"
#include "workbench/fit/fit_arguments.hpp"
#include "workbench/fit/fit_problem.hpp"
#include "workbench/fit/reduction.hpp"

namespace mbgen::fit {

/// Data and model of one channel in one file, at the result.
struct ChannelFit {
  std::string file = {}, channel = {}, unit = {};
  bool is_held_out = false, is_of_rig = false;
  double sigma = 0;
  bool is_sigma_estimated = false;
  std::vector<double> at = {}, data = {}, model = {};
  double rms = 0;        ///< of model - data, in the unit
  double explained = 0;  ///< 1 - (variance of model - data) / (variance of the data)
  Whiteness whiteness = {};
};

struct FitResult {
  std::string model, model_file, engine;
  std::string derivatives = {};           ///< kind of them: "exact", "central differences", or which are which
  std::vector<VariedParameter> set = {};  ///< values that were given
  std::vector<Unknown> unknowns = {};
  std::vector<double> values = {};
  Certainty certainty = {};
  std::vector<ChannelFit> channels = {};
  double squares = 0;  ///< weighted sum of squares
  double squares_at_start = 0;
  int residuals = 0, iterations = 0;
  bool converged = false;
  std::string message = {};                ///< of the method
  std::string loss = {};                   ///< "" for squares
  std::vector<std::string> warnings = {};  ///< for people, a line each
  std::vector<std::string> files = {};     ///< read by the fit
};

/// Reads model and data, and finds the unknowns. Notes go to standard error. Fails: UserError, also where mbgen is
/// built without Ceres, and where the model has no result at the start; Interrupted.
FitResult fit_model_to_data(const FitArguments& arguments);

/// Table of the unknowns, combinations that the data do not tell, channels, doubts.
std::string fit_text(const FitResult& result);

/// The same for programs.
std::string fit_json(const FitResult& result);

/// A page with the same, and pictures of data and model.
std::string fit_page(const FitResult& result);

/// A model that includes the fitted one and has the found values, and those of --set; path: its own file.
/// Fails: UserError, as require_places.
std::string fitted_model(const FitResult& result, const std::string& path);

}  // namespace mbgen::fit
