// Tables of fields: tables by points, couplings.
#include <array>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array<std::string_view, 3> kInterpolations = {"linear", "monotone_cubic", "spline"};

}  // namespace

template <>
std::span<const Field<TableFields>> fields<TableFields>() {
  using F = TableFields;
  static const std::array table = {
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
                                   .doc = "between the points; outside them straight lines continue the ends",
                                   .fallback_word = "linear",
                                   .words = kInterpolations}),
      field<F, &F::periodic>({.name = "periodic",
                              .shape = Shape::boolean,
                              .doc = "true: the points are one period; outside them the curve goes on as it came, each "
                                     "period higher by the last y less the first",
                              .fallback = 0}),
  };
  return table;
}

template <>
std::span<const Field<Coupling>> fields<Coupling>() {
  static const std::array table = {
      field<Coupling, &Coupling::relation>(
          {.name = "relation",
           .doc = "expression over positions of coordinates, z.NAME, and parameters; it stays zero",
           .depends = Depends::positions}),
      field<Coupling, &Coupling::joint>(
          {.name = "joint", .shape = Shape::coordinate, .doc = "coordinate that a curve gives the position of"}),
      field<Coupling, &Coupling::follows>(
          {.name = "follows", .shape = Shape::coordinate, .doc = "coordinate whose position the curve is over"}),
      field<Coupling, &Coupling::curve>(
          {.name = "curve",
           .shape = Shape::table,
           .doc = "table of the position of joint over that of follows (rad or m), spline or monotone_cubic"}),
  };
  return table;
}

}  // namespace mbgen::reading
