// Tables of fields: couplings.
#include <array>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
template <>
std::span<const Field<Coupling>> fields<Coupling>() {
  static const std::array table = {
      field<Coupling, &Coupling::relation>(
          {.name = "relation",
           .doc = "expression over positions of coordinates, z.NAME, and parameters; it is constrained to zero",
           .depends = Depends::positions}),
      field<Coupling, &Coupling::joint>(
          {.name = "joint", .shape = Shape::coordinate, .doc = "dependent coordinate of a curve"}),
      field<Coupling, &Coupling::follows>(
          {.name = "follows", .shape = Shape::coordinate, .doc = "independent coordinate of the curve"}),
      field<Coupling, &Coupling::curve>(
          {.name = "curve",
           .shape = Shape::table,
           .doc = "table of the position of joint over the position of follows (rad or m), spline or monotone_cubic"}),
  };
  return table;
}

}  // namespace mbgen::reading
