#pragma once
// A fit as typed.

#include <string>
#include <vector>

#include "workbench/search/free_model.hpp"

namespace mbgen::fit {

/// A fit as typed.
struct FitArguments {
  ModelArguments model;
  std::vector<std::string> data, held_out;  ///< files
  std::vector<std::string> match, targets, free, free_start, nuisance;
  std::vector<std::string> manoeuvres;  ///< files, whose numbers are targets
  std::string loss;
  std::string journal;  ///< file, "" for none
  int most_iterations = 100, jobs = 1;
  bool restart = false;
};

}  // namespace mbgen::fit
