#include "workbench/optimise/trade_off.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen::optimise {
namespace {

double cost_at(const DesignProblem& problem, std::size_t goal, const SearchedDesign& found) {
  return cost_of(problem, problem.wishes.goals[goal], {found.design.values, found.design.numbers, {}}).cost;
}

/// Costs at equal distances of the goal as people see it: a target's cost is the square of its distance.
double between(const Goal& goal, double first, double last, double part) {
  if (goal.kind != Goal::Kind::target) return first + part * (last - first);
  const double distance = std::sqrt(first) + part * (std::sqrt(last) - std::sqrt(first));
  return distance * distance;
}

/// Marks points that another one beats in both goals.
void mark_beaten(const DesignProblem& problem, std::size_t one, std::size_t other, std::vector<SearchedDesign>& list) {
  constexpr double kSame = 1e-7;
  for (SearchedDesign& point : list)
    for (const SearchedDesign& rival : list) {
      const double first = cost_at(problem, one, point) - cost_at(problem, one, rival);
      const double second = cost_at(problem, other, point) - cost_at(problem, other, rival);
      const bool is_beaten = first >= -kSame && second >= -kSame && std::max(first, second) > 100 * kSame;
      if (is_beaten && rival.status == "ok" && point.status == "ok") point.status = "beaten by another point";
    }
}

}  // namespace

std::vector<SearchedDesign> trade_off(const DesignProblem& problem, std::size_t one, std::size_t other, int points,
                                      const std::vector<double>& start, Designs& designs) {
  std::vector<SearchedDesign> list;
  Design at_start;
  if (!designs.evaluate(start, true, at_start)) return list;
  const double size = size_of(problem, one, at_start), other_size = size_of(problem, other, at_start);
  const auto first = search_design(problem, {.goal = one, .start = start, .size = size}, designs);
  if (!first) return list;
  auto last = search_design(problem, {.goal = other, .start = start, .size = other_size}, designs);
  const auto from_first =
      search_design(problem, {.goal = other, .start = first->design.values, .size = other_size}, designs);
  if (!last || (from_first && is_better(*from_first, *last))) last = from_first;
  list.push_back(*first);
  if (!last) return list;
  const double most = cost_at(problem, other, *first), least = cost_at(problem, other, *last);
  for (int p = 1; p + 1 < points; ++p) {
    const double part = static_cast<double>(p) / (points - 1);
    const DesignTask task{.goal = one,
                          .bounded = other,
                          .most = between(problem.wishes.goals[other], most, least, part),
                          .start = list.back().design.values,
                          .size = size,
                          .bounded_size = other_size};
    std::optional<SearchedDesign> found = search_design(problem, task, designs);
    if (problem.is_stopped && problem.is_stopped()) return list;
    if (found) list.push_back(std::move(*found));
  }
  list.push_back(*last);
  mark_beaten(problem, one, other, list);
  return list;
}

}  // namespace mbgen::optimise
