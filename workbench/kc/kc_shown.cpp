#include "workbench/kc/kc_shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbgen::kc {
namespace {

/// The value of a series at x, on the line between its points; NaN outside. x of the series: increasing.
double value_between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (const auto same = std::find(x.begin(), x.end(), at); same != x.end())
    return y[static_cast<std::size_t>(same - x.begin())];
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (at < x[i - 1] || at > x[i]) continue;
    return y[i - 1] + (at - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Points of measured columns in the order of their abscissa.
struct Measured {
  std::vector<double> x, y;
};

Measured in_order(const Column& x, const Column& y) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < x.values.size(); ++i)
    if (std::isfinite(x.values[i]) && std::isfinite(y.values[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x.values[a] < x.values[b]; });
  Measured points;
  for (const std::size_t i : order) {
    points.x.push_back(x.values[i]);
    points.y.push_back(y.values[i]);
  }
  return points;
}

/// Differences of measured columns of one curve.
void add_measured(const KcTable& computed, const KcTable& measured, std::vector<KcDifference>& list) {
  const std::vector<double>& over = computed.columns.front().values;
  for (std::size_t c = 1; c < measured.columns.size(); ++c) {
    const Column& column = measured.columns[c];
    const auto same = std::find_if(computed.columns.begin(), computed.columns.end(),
                                   [&](const Column& other) { return other.heading.name == column.heading.name; });
    if (same == computed.columns.end()) continue;
    const Measured points = in_order(measured.columns.front(), column);
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const double difference = points.y[i] - value_between(over, same->values, points.x[i]);
      if (!std::isfinite(difference)) continue;
      sum += difference * difference;
      ++count;
    }
    const double at_start = value_between(points.x, points.y, 0);
    list.push_back({computed.name + " " + column.heading.name,
                    column.heading.unit,
                    {at_start},
                    {at_start - value_between(over, same->values, 0)},
                    count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN()});
  }
}

}  // namespace

Shown shown(const std::string& unit) {
  constexpr double kDegrees = 57.295779513082320877, kMillimetres = 1e3;
  const struct {
    const char* si;
    Shown as;
  } table[] = {{"rad", {"deg", kDegrees}},
               {"m", {"mm", kMillimetres}},
               {"rad/m", {"deg/m", kDegrees}},
               {"N/m", {"N/mm", 1 / kMillimetres}},
               {"m/rad", {"mm/deg", kMillimetres / kDegrees}},
               {"N m/rad", {"N m/deg", 1 / kDegrees}},
               {"rad/N", {"deg/kN", kDegrees * 1e3}},
               {"m/N", {"mm/kN", kMillimetres * 1e3}},
               {"m/(N m)", {"mm/(kN m)", kMillimetres * 1e3}},
               {"rad/(N m)", {"deg/(kN m)", kDegrees * 1e3}},
               {"1", {"", 1}}};
  for (const auto& row : table) {
    if (unit == row.si) return row.as;
  }
  return {unit, 1};
}

std::string shown_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value == 0 ? 0 : value) : "-";
}

Column drawn(const Column& column) {
  const Shown as = shown(column.heading.unit);
  Column result{{column.heading.name, as.unit}, column.values};
  for (double& value : result.values) value *= as.factor;
  return result;
}

std::string unit_of(const KcMatrix& matrix, std::size_t row, std::size_t column) {
  const std::string& load = matrix.columns[column].unit;
  return matrix.rows[row].unit + (load == "N" ? "/N" : "/(" + load + ")");
}

std::string plain_name(const Heading& heading) { return heading.name.substr(0, heading.name.rfind('_')); }

std::vector<MatrixBlock> blocks_of(const KcMatrix& matrix) {
  std::vector<MatrixBlock> blocks;
  const auto ending = [](const Heading& heading) { return heading.name.substr(heading.name.rfind('_') + 1); };
  for (const std::string wheel : {"left", "right"}) {
    for (const std::string loads : {"left", "right", "both", "opposite"}) {
      MatrixBlock block{wheel, loads, {}, {}};
      for (std::size_t i = 0; i < matrix.rows.size(); ++i)
        if (ending(matrix.rows[i]) == wheel) block.rows.push_back(i);
      for (std::size_t i = 0; i < matrix.columns.size(); ++i)
        if (ending(matrix.columns[i]) == loads) block.columns.push_back(i);
      if (!block.rows.empty() && !block.columns.empty()) blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

std::vector<KcDifference> differences_of(const KcReport& report, const KcOverlay& overlay) {
  std::vector<KcDifference> list;
  if (overlay.is_measured) {
    for (const KcTable& measured : overlay.tables)
      if (const KcTable* computed = table_named(report, measured.name)) add_measured(*computed, measured, list);
    return list;
  }
  for (const KcFigure& figure : report.figures) {
    const auto same = std::find_if(overlay.figures.begin(), overlay.figures.end(), [&](const KcFigure& other) {
      return other.name == figure.name && other.values.size() == figure.values.size() && other.unit == figure.unit;
    });
    if (same == overlay.figures.end()) continue;
    KcDifference difference{figure.name, figure.unit, same->values, same->values};
    for (std::size_t i = 0; i < figure.values.size(); ++i) difference.differences[i] -= figure.values[i];
    list.push_back(std::move(difference));
  }
  return list;
}

}  // namespace mbgen::kc
