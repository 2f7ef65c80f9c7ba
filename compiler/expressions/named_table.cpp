#include "compiler/expressions/named_table.hpp"

#include <array>
#include <cstddef>

namespace mbgen {
namespace {

/// A grid of numbers, row by row.
struct Grid {
  std::size_t columns = 0;
  std::vector<double> numbers;
  double& at(std::size_t i, std::size_t j) { return numbers[i * columns + j]; }
  double at(std::size_t i, std::size_t j) const { return numbers[i * columns + j]; }
};

std::vector<double> monotone_slopes_of(const std::vector<double>& x, const std::vector<double>& y) {
  Table table{Table::Interpolation::monotone_cubic, x, y};
  return slopes_of(table);
}

/// Slopes by x of every column.
Grid slopes_by_x(const std::vector<double>& x, const Grid& z) {
  Grid slopes{z.columns, std::vector<double>(z.numbers.size())};
  for (std::size_t j = 0; j < z.columns; ++j) {
    std::vector<double> line;
    for (std::size_t i = 0; i < x.size(); ++i) line.push_back(z.at(i, j));
    const std::vector<double> found = monotone_slopes_of(x, line);
    for (std::size_t i = 0; i < x.size(); ++i) slopes.at(i, j) = found[i];
  }
  return slopes;
}

/// Slopes by y of every row.
Grid slopes_by_y(const std::vector<double>& y, const Grid& z) {
  Grid slopes{z.columns, {}};
  for (std::size_t i = 0; i * z.columns < z.numbers.size(); ++i) {
    const auto row = z.numbers.begin() + static_cast<std::ptrdiff_t>(i * z.columns);
    const std::vector<double> found = monotone_slopes_of(y, {row, row + static_cast<std::ptrdiff_t>(z.columns)});
    slopes.numbers.insert(slopes.numbers.end(), found.begin(), found.end());
  }
  return slopes;
}

using Four = std::array<double, 4>;

/// Coefficients of the cubic with these values and slopes at 0 and 1.
Four hermite(double value_0, double value_1, double slope_0, double slope_1) {
  const double rise = value_1 - value_0;
  return {value_0, slope_0, 3 * rise - 2 * slope_0 - slope_1, slope_0 + slope_1 - 2 * rise};
}

void add_straight_cell(const Grid& z, std::size_t i, std::size_t j, std::vector<double>& to) {
  const double here = z.at(i, j), by_x = z.at(i + 1, j) - here, by_y = z.at(i, j + 1) - here;
  to.insert(to.end(), {here, by_y, by_x, z.at(i + 1, j + 1) - z.at(i + 1, j) - by_y});
}

/// The grid with its slopes by both places, and by both one after the other.
struct SmoothGrid {
  Grid value, by_x, by_y, mixed;
};

SmoothGrid smooth_grid(const std::vector<double>& x, const std::vector<double>& y, const Grid& value) {
  SmoothGrid grid{value, slopes_by_x(x, value), slopes_by_y(y, value), {}};
  grid.mixed = slopes_by_y(y, grid.by_x);
  const Grid other = slopes_by_x(x, grid.by_y);
  for (std::size_t k = 0; k < other.numbers.size(); ++k)
    grid.mixed.numbers[k] = (grid.mixed.numbers[k] + other.numbers[k]) / 2;
  return grid;
}

/// width, height: of the cell, units of x and y.
void add_smooth_cell(const SmoothGrid& grid, std::size_t i, std::size_t j, double width, double height,
                     std::vector<double>& to) {
  const auto along_y = [&](std::size_t at, const Grid& of, const Grid& slopes, double scale) {
    return hermite(scale * of.at(at, j), scale * of.at(at, j + 1), scale * height * slopes.at(at, j),
                   scale * height * slopes.at(at, j + 1));
  };
  const Four value_0 = along_y(i, grid.value, grid.by_y, 1), value_1 = along_y(i + 1, grid.value, grid.by_y, 1);
  const Four slope_0 = along_y(i, grid.by_x, grid.mixed, width), slope_1 = along_y(i + 1, grid.by_x, grid.mixed, width);
  std::array<Four, 4> along_x;  // of the coefficient of each power along y
  for (std::size_t k = 0; k < 4; ++k) along_x[k] = hermite(value_0[k], value_1[k], slope_0[k], slope_1[k]);
  for (std::size_t power = 0; power < 4; ++power)
    for (std::size_t k = 0; k < 4; ++k) to.push_back(along_x[k][power]);
}

}  // namespace

Table lines_before(const std::vector<double>& lines) {
  Table table{Table::Interpolation::linear, lines, {}};
  for (std::size_t i = 0; i < lines.size(); ++i) table.y.push_back(static_cast<double>(i));
  return table;
}

std::vector<double> map_coefficients(const std::vector<double>& x, const std::vector<double>& y,
                                     const std::vector<double>& z, int degree) {
  const Grid value{y.size(), z};
  const SmoothGrid smooth = degree == 1 ? SmoothGrid{} : smooth_grid(x, y, value);
  std::vector<double> coefficients;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      if (degree == 1) {
        add_straight_cell(value, i, j, coefficients);
      } else {
        add_smooth_cell(smooth, i, j, x[i + 1] - x[i], y[j + 1] - y[j], coefficients);
      }
    }
  }
  return coefficients;
}

}  // namespace mbgen
