#pragma once
// Elements that stand for bodies, joints and others of the model format: their parts, as if written in the file.

#include <array>
#include <string>
#include <string_view>

#include "compiler/model/element_kinds.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Entries of other sections, their values in Reader::composed.
struct ComposedParts {
  Entries bodies, joints, rods, couplings, shapes;
  std::array<Entries, ElementKinds::count> elements;  ///< by the kind that leads its section

  template <class Kind>
  Entries& of() {
    return elements[kKindIndex<Kind>];
  }
};

/// The object of an element, under construction. place: of the element that it is a part of.
struct Composed {
  Place place;
  Value object;

  explicit Composed(Place at);
  void add(std::string_view key, Value value);
  void add_text(std::string_view key, std::string text, Place at);
  void add_text(std::string_view key, std::string text) { add_text(key, std::move(text), place); }
  void add_number(std::string_view key, double number) { add(key, number_at(place, number)); }
  template <std::size_t count>
  void add_numbers(std::string_view key, const std::array<double, count>& numbers) {
    Value list;
    list.kind = Value::Kind::array;
    list.place = place;
    for (const double number : numbers) list.items.push_back(number_at(place, number));
    add(key, std::move(list));
  }
  static Value number_at(Place place, double number);
};

/// Adds a part of an element to a section. suffix: of its name. Reports a name that is none.
void add_composed(Reader& reader, Entries& section, const Entry& element, std::string_view suffix, Composed part);

/// Makes a position of the current scope known as a hardpoint. Reports a name that is taken.
void add_composed_hardpoint(Reader& reader, const Entry& element, const std::string& name,
                            const Vector3Quantity& position);

/// The entries of a section and the parts made for it; reports names that both have.
Entries with_composed(Reader& reader, Entries entries, const Entries& made);

}  // namespace mbgen::reading
