// Air springs.
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

struct AirSpringFields : AirSpring {
  Law written_volume;
};

template <>
std::span<const Field<AirSpringFields>> fields<AirSpringFields>();
namespace {

void read_air_springs(Reader& reader, const Entries& entries) {
  std::vector<AirSpringFields> springs;
  read_list(reader, entries, springs, [](Reader& r, const Value& value, const AirSpringFields& spring) {
    const double distance = check_ends(r, value, spring.from, spring.to);
    if (distance == 0 && !spring.length)
      report(r, *find(value, "to"), "air spring needs a length, its ends coincide at the reference");
  });
  for (AirSpringFields& spring : springs) {
    if (const Table* table = std::get_if<Table>(&spring.written_volume)) {
      spring.volume = *table;
    } else {
      spring.volume0 = std::get<Quantity>(spring.written_volume);
    }
    reader.model.air_springs.push_back(spring);
  }
}

std::string trouble_of_air_spring(const Model&, std::size_t) { return "a gas law, which is not integrated"; }

}  // namespace

template <>
std::span<const Field<AirSpringFields>> fields<AirSpringFields>() {
  using S = AirSpringFields;
  static const std::array table = {
      field<S, &S::from>(element_end("from", "one end")),
      field<S, &S::to>(element_end("to", "other end, on another body")),
      field<S, &S::pressure>({.name = "pressure",
                              .doc = "absolute pressure at the reference length",
                              .unit = "Pa",
                              .need = Need::required,
                              .bound = Bound::positive}),
      field<S, &S::ambient>({.name = "ambient",
                             .doc = "absolute pressure around it",
                             .unit = "Pa",
                             .fallback = 101325,
                             .bound = Bound::not_negative}),
      field<S, &S::exponent>(
          {.name = "exponent", .doc = "polytropic exponent", .unit = "1", .fallback = 1.38, .bound = Bound::positive}),
      field<S, &S::length>({.name = "length",
                            .doc = "reference length; default: the distance at the reference",
                            .unit = "m",
                            .bound = Bound::positive}),
      field<S, &S::area>({.name = "area",
                          .shape = Shape::law,
                          .doc = "effective area, or a table over length (m)",
                          .unit = "m^2",
                          .need = Need::required,
                          .bound = Bound::positive}),
      field<S, &S::written_volume>({.name = "volume",
                                    .shape = Shape::law,
                                    .doc = "volume at the reference length, or a table over length (m)",
                                    .unit = "m^3",
                                    .need = Need::required,
                                    .bound = Bound::positive}),
  };
  return table;
}

ElementSection section_of(Leader<AirSpring>) {
  return {"polytropic air springs between two points",
          [] {
            return std::vector<ObjectKind>{
                kind_of<AirSpringFields>("air_spring", "polytropic air spring between two points")};
          },
          read_air_springs, trouble_of_air_spring};
}

}  // namespace mbgen::reading
