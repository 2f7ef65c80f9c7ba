#pragma once
// The door of the optimise room: designs of a model that are best by goals and keep constraints.

#include <string>
#include <vector>

#include "workbench/optimise/optimise_result.hpp"

namespace mbgen::optimise {

/// A search as typed.
struct OptimiseArguments {
  ModelArguments model;
  std::vector<std::string> free, goals, constraints, manoeuvres;
  KcSettings rig;
  std::string method = "slsqp";
  std::string trade_off;  ///< "GOAL,GOAL", "" for none
  int points = 9;         ///< of the trade-off
  int starts = 1;         ///< of a global search
  std::string journal;    ///< file, "" for none
  int most_evaluations = 500, jobs = 1;
  bool restart = false;
};

/// Reads the model, and searches. Notes go to standard error. Fails: UserError, also where mbgen is built without
/// NLopt, and where the model has no result at the start; Interrupted.
OptimiseResult optimise_model(const OptimiseArguments& arguments);

/// Tables for people, for programs, as CSV of a trade-off, and a page with pictures.
std::string optimise_text(const OptimiseResult& result);
std::string optimise_json(const OptimiseResult& result);
std::string trade_off_csv(const OptimiseResult& result);
std::string optimise_page(const OptimiseResult& result);

/// A model that includes the optimised one and has the found values. Fails: UserError, as require_places.
std::string optimised_model(const OptimiseResult& result, const std::string& path);

}  // namespace mbgen::optimise
