#include "compiler/expressions/table_pieces.hpp"

#include <algorithm>

namespace mbgen {

std::vector<double> pieces_of(const Table& table) {
  const bool is_straight = table.slopes.empty();
  const std::size_t last = table.x.size() - 1;
  const auto width = [&](std::size_t i) { return table.x[i + 1] - table.x[i]; };
  const auto secant = [&](std::size_t i) { return (table.y[i + 1] - table.y[i]) / width(i); };
  const auto slope = [&](std::size_t i) { return is_straight ? secant(std::min(i, last - 1)) : table.slopes[i]; };
  std::vector<double> numbers;
  numbers.reserve((last + 2) * numbers_of_piece(table));
  double integral = 0, first_square = 0, first_cube = 0;
  const auto add = [&](std::size_t i, double at_start, double square, double cube) {
    numbers.insert(numbers.end(), {table.x[i], table.y[i], at_start, integral});
    if (!is_straight) numbers.insert(numbers.end(), {square, cube});
  };
  add(0, slope(0), 0, 0);
  for (std::size_t i = 0; i < last; ++i) {
    const double w = width(i), left = slope(i), right = slope(i + 1);
    const double square = is_straight ? 0 : (3 * secant(i) - 2 * left - right) / w;
    const double cube = is_straight ? 0 : (left + right - 2 * secant(i)) / (w * w);
    if (i == 0) first_square = square, first_cube = cube;
    add(i, left, square, cube);
    integral += w * (table.y[i] + w * (left / 2 + w * (square / 3 + w * cube / 4)));
  }
  // Rounding may lead to the end of a period: the next one begins there.
  if (table.periodic) {
    add(last, slope(0), first_square, first_cube);
  } else {
    add(last, slope(last), 0, 0);
  }
  return numbers;
}

double spacing_of(const Table& table) {
  const double spacing = (table.x.back() - table.x.front()) / static_cast<double>(table.x.size() - 1);
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (std::abs(table.x[i] - table.x.front() - static_cast<double>(i) * spacing) > spacing / 4) return 0;
  return spacing;
}

}  // namespace mbgen
