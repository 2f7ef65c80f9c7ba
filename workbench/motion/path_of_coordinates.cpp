#include "workbench/motion/path_of_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/host/files.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

/// Share of the largest rate, or acceleration, by which its mean between rows may differ from the change of the
/// position, or rate.
constexpr double kContradiction = 0.1;

/// Columns of a coordinate: position, rate, acceleration; null where the table has none.
using Curves = std::array<const Column*, 3>;

struct Named {
  std::string_view name;
  std::size_t order = 0;  ///< 0 position, 1 rate, 2 acceleration
};

Named named(std::string_view heading) {
  constexpr std::array<std::string_view, 3> kPrefixes = {"z.", "zd.", "zdd."};
  for (std::size_t order = 0; order < kPrefixes.size(); ++order)
    if (heading.starts_with(kPrefixes[order])) return {heading.substr(kPrefixes[order].size()), order};
  return {heading, 0};
}

/// The coordinate of a column. Fails: unknown, driven, in another unit.
int coordinate_of(const std::string& path, const Heading& heading, const Named& column,
                  const Compilation& compilation) {
  const std::string name(column.name);
  const int coordinate = find_coordinate(compilation.topology, name);
  if (coordinate < 0) {
    const std::vector<std::string> known = coordinate_names(compilation.topology);
    const std::string hint = did_you_mean(name, {known.begin(), known.end()});
    throw UserError(
        fmt::format("{}: the model has no coordinate \"{}\"{}{}\n", path, name, hint.empty() ? "" : "; ", hint));
  }
  if (compilation.analysis.driven[static_cast<std::size_t>(coordinate)])
    throw UserError(
        fmt::format("{}: coordinate \"{}\" has a motion, which moves it\n  hint: leave out the column, or the motion\n",
                    path, name));
  constexpr std::array<const char*, 3> kPer = {"", "/s", "/s^2"};
  const std::string unit =
      unit_of(compilation.topology.bodies[static_cast<std::size_t>(coordinate)].kind) + std::string(kPer[column.order]);
  if (!heading.unit.empty() && heading.unit != unit)
    throw UserError(fmt::format("{}: column \"{}\" is in {}, {} {}\n", path, heading.name, heading.unit,
                                column.order == 0 ? "the coordinate in" : "must be in", unit));
  return coordinate;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Fails: a change between rows that its rates, and their rates, do not lead to.
void check_rates(const std::string& path, const std::vector<double>& t, const Column& value, const Column& rate,
                 const std::vector<double>* second) {
  const double largest = largest_of(rate.values);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double h = t[i] - t[i - 1];
    double change = h / 2 * (rate.values[i - 1] + rate.values[i]);
    if (second) change += h * h / 12 * ((*second)[i - 1] - (*second)[i]);
    if (std::abs(value.values[i] - value.values[i - 1] - change) <= kContradiction * h * largest) continue;
    throw UserError(fmt::format(
        "{}: between t = {:.10g} s and {:.10g} s \"{}\" changes by {:.6g}, by \"{}\" it would be {:.6g}\n", path,
        t[i - 1], t[i], value.heading.name, value.values[i] - value.values[i - 1], rate.heading.name, change));
  }
}

Course course_of(const std::string& path, const std::vector<double>& t, const Curves& curves) {
  const auto& [position, rate, acceleration] = curves;
  const Column* given = position ? position : rate ? rate : acceleration;
  if (!position || !rate != !acceleration)
    throw UserError(
        fmt::format("{}: the path of \"{}\" lacks columns: it has positions alone, or positions, rates (zd.NAME) and "
                    "accelerations (zdd.NAME)\n",
                    path, given->heading.name));
  if (!rate) return cubic_spline(t, position->values);
  check_rates(path, t, *position, *rate, &acceleration->values);
  check_rates(path, t, *rate, *acceleration, nullptr);
  return hermite(t, {position->values, rate->values, acceleration->values});
}

}  // namespace

PathOfCoordinates read_path(const std::string& path, const Compilation& compilation) {
  const Results table = expect(read_results(read_text(path), path, "a path is a table: t [s],coordinate [unit]"));
  if (const std::string& unit = table.columns[0].heading.unit; !unit.empty() && unit != "s")
    throw UserError(fmt::format("{}: column \"t\" is in {}, must be in s\n", path, unit));
  constexpr std::size_t kLeastRows = 3;
  if (table.rows() < kLeastRows)
    throw UserError(fmt::format("{}: a path has at least {} rows, found {}\n", path, kLeastRows, table.rows()));
  PathOfCoordinates result;
  result.file = path;
  const std::vector<double>& t = table.columns[0].values;
  result.start = t.front();
  result.end = t.back();
  std::vector<Curves> curves;
  for (std::size_t c = 1; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    const Named found = named(column.heading.name);
    const int coordinate = coordinate_of(path, column.heading, found, compilation);
    const auto place =
        static_cast<std::size_t>(std::ranges::find(result.coordinates, coordinate) - result.coordinates.begin());
    if (place == result.coordinates.size()) {
      result.coordinates.push_back(coordinate);
      curves.push_back({});
    }
    if (curves[place][found.order])
      throw UserError(fmt::format("{}: columns \"{}\" and \"{}\" are the same\n", path,
                                  curves[place][found.order]->heading.name, column.heading.name));
    curves[place][found.order] = &column;
  }
  if (curves.empty()) throw UserError(fmt::format("{}: a path has columns of coordinates\n", path));
  for (const Curves& of_coordinate : curves) {
    result.positions.push_back(course_of(path, t, of_coordinate));
    result.rates.push_back(derivative(result.positions.back()));
    result.accelerations.push_back(derivative(result.rates.back()));
  }
  return result;
}

}  // namespace mbgen
