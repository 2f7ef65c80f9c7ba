#include "workbench/motion/inverse_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Accelerations that others determine less than by this share are open.
constexpr double kOpen = 1e-9;

[[noreturn]] void tell_open(const Compilation& compilation, const std::vector<int>& free) {
  std::vector<std::string> names;
  for (const int i : free) names.push_back(compilation.topology.bodies[static_cast<std::size_t>(i)].coordinate);
  throw UserError(
      fmt::format("the given accelerations leave others open\n"
                  "  hint: give those of as many coordinates as determine the motion, for example {}\n",
                  fmt::join(names, ", ")));
}

/// Independent accelerations that meet the given ones: all accelerations are linear in them.
Status complete(const Engine& engine, const Compilation& compilation, const LoadedState& at,
                const std::vector<double>& given, const std::vector<int>& free, GenericDerivative& derivative) {
  Status status;
  const auto all_with = [&](int moved) {
    GenericDerivative trial = derivative;
    trial.zdd.assign(given.size(), 0.0);
    if (moved >= 0) trial.zdd[static_cast<std::size_t>(moved)] = 1;
    std::vector<double> force;
    if (status.ok()) status = engine.inverse_dynamics(at, trial, force);
    return trial.zdd;
  };
  const std::vector<double> start = all_with(-1);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!std::isnan(given[i])) rows.push_back(i);
  Eigen::MatrixXd matrix(rows.size(), free.size());
  Eigen::VectorXd right(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) right[static_cast<Eigen::Index>(r)] = given[rows[r]] - start[rows[r]];
  for (std::size_t q = 0; q < free.size(); ++q) {
    const std::vector<double> moved = all_with(free[q]);
    for (std::size_t r = 0; r < rows.size(); ++r)
      matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(q)) = moved[rows[r]] - start[rows[r]];
  }
  if (!status.ok()) return status;
  if (rows.size() < free.size() || leading_columns(matrix, kOpen).size() < free.size()) tell_open(compilation, free);
  const Eigen::VectorXd independent = overdetermined_solution(matrix, right);
  derivative.zdd.assign(given.size(), 0.0);
  for (std::size_t q = 0; q < free.size(); ++q)
    derivative.zdd[static_cast<std::size_t>(free[q])] = independent[static_cast<Eigen::Index>(q)];
  return {};
}

}  // namespace

Status actuator_forces(const Engine& engine, const Compilation& compilation, const LoadedState& at,
                       const std::vector<double>& given, GenericDerivative& derivative, std::vector<double>& force) {
  const std::vector<int> free = free_coordinates(compilation.topology, compilation.analysis);
  bool is_complete = true;
  for (const int i : free) is_complete = is_complete && !std::isnan(given[static_cast<std::size_t>(i)]);
  derivative.zdd = given;
  for (double& value : derivative.zdd) value = std::isnan(value) ? 0 : value;
  Status status;
  if (!is_complete) status = complete(engine, compilation, at, given, free, derivative);
  return status.ok() ? engine.inverse_dynamics(at, derivative, force) : status;
}

}  // namespace mbgen
