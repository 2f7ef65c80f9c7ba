// Tables of fields: curves by points and maps.
#include "compiler/reader/tables/table_fields.hpp"

#include <array>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 3> kInterpolations = {"linear", "monotone_cubic", "spline"};
constexpr std::span<const std::string_view> kMapInterpolations(kInterpolations.data(), 2);

/// Rows of a table by points, and after them others.
template <class F, class... Others>
auto rows_of_table(Others... others) {
  return std::array<Field<F>, 6 + sizeof...(Others)>{
      field<F, &F::points>({.name = "table",
                            .shape = Shape::table_points,
                            .doc = "at least two points [x, y], x increasing",
                            .depends = Depends::nothing}),
      field<F, &F::csv>({.name = "csv",
                         .shape = Shape::text,
                         .doc = "file with the points, relative to this file: a line with the names of the columns, "
                                "then numbers separated by commas"}),
      field<F, &F::x>({.name = "x", .shape = Shape::text, .doc = "column of x in the CSV file; default: the first"}),
      field<F, &F::y>({.name = "y", .shape = Shape::text, .doc = "column of y in the CSV file; default: the second"}),
      field<F, &F::interpolation>({.name = "interpolation",
                                   .shape = Shape::word,
                                   .doc = "between the points; extrapolation is linear",
                                   .fallback_word = "linear",
                                   .words = kInterpolations}),
      field<F, &F::periodic>({.name = "periodic",
                              .shape = Shape::boolean,
                              .doc = "true: the points are one period; the curve is continued periodically, each "
                                     "period shifted by the last y minus the first",
                              .fallback = 0}),
      others...};
}

}  // namespace

template <>
std::span<const Field<TableFields>> fields<TableFields>() {
  static const std::array table = rows_of_table<TableFields>();
  return table;
}

template <>
std::span<const Field<NamedTableFields>> fields<NamedTableFields>() {
  using F = NamedTableFields;
  static const std::array table =
      rows_of_table<F>(field<F, &F::outside>({.name = "outside",
                                              .shape = Shape::word,
                                              .doc = "beyond the points: straight on, or the value at the edge",
                                              .fallback_word = "straight",
                                              .words = kOutsides}));
  return table;
}

template <>
std::span<const Field<MapFields>> fields<MapFields>() {
  using F = MapFields;
  static const std::array table = {
      field<F, &F::x>(
          {.name = "x", .shape = Shape::numbers, .doc = "lines of the grid, increasing", .depends = Depends::nothing}),
      field<F, &F::y>(
          {.name = "y", .shape = Shape::numbers, .doc = "lines of the grid, increasing", .depends = Depends::nothing}),
      field<F, &F::z>({.name = "z",
                       .shape = Shape::rows,
                       .doc = "a row for each x with a value for each y",
                       .depends = Depends::nothing}),
      field<F, &F::csv>(
          {.name = "csv",
           .shape = Shape::text,
           .doc = "file with the grid, relative to this file: a line with a heading and y, then lines of x and z"}),
      field<F, &F::interpolation>({.name = "interpolation",
                                   .shape = Shape::word,
                                   .doc = "between the points; monotone_cubic is smooth, and along every line of the "
                                          "grid rises and falls only where the points do",
                                   .fallback_word = "linear",
                                   .words = kMapInterpolations}),
      field<F, &F::outside>({.name = "outside",
                             .shape = Shape::word,
                             .doc = "beyond the points: straight on, or the value at the edge",
                             .fallback_word = "straight",
                             .words = kOutsides}),
  };
  return table;
}

}  // namespace mbgen::reading
