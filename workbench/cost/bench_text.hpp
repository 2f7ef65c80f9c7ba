#pragma once
// Results of bench, for people and for machines.

#include <string>
#include <vector>

#include "workbench/cost/bench_measure.hpp"

namespace mbgen {

struct BenchRecord {
  std::string model;
  long long evaluations = 0;  ///< asked for
  std::vector<Measurement> measurements;
};

/// Name of this machine's processor, as it reports it.
std::string processor_name();

/// The tables of the paper with our columns, seconds for `evaluations`; then every engine on a line.
std::string bench_text(const BenchRecord& record);

/// One JSON object: model, machine, compiler, every engine with microseconds per evaluation, the paper's columns.
std::string bench_json(const BenchRecord& record);

}  // namespace mbgen
