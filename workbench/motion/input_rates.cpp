#include "workbench/motion/input_rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// Gap between two rows, in parts of the largest rate: at four rows per period of a sine the trapezoidal rule has an
/// error of 0.19.
constexpr double kLocalGap = 0.2;
/// Largest sum of the deviations of rows, as part of the range of the values.
constexpr double kAddsUp = 0.1;

/// Change of the values over a segment, and the same by the rates.
struct Change {
  double of_values = 0, of_rates = 0, width = 0;
  double gap() const { return std::abs(of_values - of_rates); }
};

Change change_of(const std::vector<double>& t, const std::vector<double>& y, const std::vector<double>& rates,
                 std::size_t i) {
  const double width = t[i + 1] - t[i];
  return {y[i + 1] - y[i], width * (rates[i] + rates[i + 1]) / 2, width};
}

double largest_rate(const InputTable& table, const std::vector<double>& values, const std::vector<double>& rates) {
  double largest = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    largest = std::max(largest, std::abs(rates[i]));
    if (i > 0) largest = std::max(largest, std::abs((values[i] - values[i - 1]) / (table.t[i] - table.t[i - 1])));
  }
  return largest;
}

}  // namespace

void check_rates(const Model& model, const InputTable& table, const InputColumn& column) {
  const Input& input = model.inputs[column.input];
  const InputColumn* of_rate = input.derivative < 0 ? nullptr : column_of(table, input.derivative);
  if (of_rate == nullptr) return;
  const Input& rate = model.inputs[input.derivative];
  const double allowed = kLocalGap * largest_rate(table, column.values, of_rate->values);
  const auto [smallest, largest] = std::minmax_element(column.values.begin(), column.values.end());
  double sum = 0, moved = *largest - *smallest;
  std::size_t worst = 0;
  Change of_worst;
  for (std::size_t i = 0; i + 1 < table.t.size(); ++i) {
    const Change change = change_of(table.t, column.values, of_rate->values, i);
    moved = std::max(moved, std::abs(change.of_rates));
    if (!(change.gap() > allowed * change.width)) continue;
    sum += change.gap();
    if (change.gap() > of_worst.gap()) worst = i, of_worst = change;
  }
  if (!(sum > kAddsUp * moved)) return;
  throw UserError(
      fmt::format("{}:{}: {} contradicts {}: from t = {} to {} s {} changes by {:.6g} {}, {} makes {:.6g} {} of it\n"
                  "  hint: leave out the column {}, it then follows from {}\n",
                  table.path, table.lines[worst + 1], rate.name, input.name, table.t[worst], table.t[worst + 1],
                  input.name, of_worst.of_values, unit_or_one(input.unit), rate.name, of_worst.of_rates,
                  unit_or_one(input.unit), rate.name, input.name));
}

}  // namespace mbgen
