// Outputs of elements, and laws without a known potential energy.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/element_access.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/output_sources.hpp"

namespace mbgen::reading {
namespace {

/// Reports a force of an element that is not integrated. Result: whether it did.
template <class Element>
bool tells_trouble(Reader& reader, const Value& value, const Element& element, const std::string& hint) {
  const std::string trouble =
      section_of(Leader<Element>())
          .trouble(reader.model, static_cast<std::size_t>(&element - KindOf<Element>::list(reader.model).data()));
  if (trouble.empty()) return false;
  report(reader, value, fmt::format("{} {} has {}", KindOf<Element>::words, in_quotes(element.name), trouble), hint);
  return true;
}

/// Quantities of all kinds of a source, each once.
std::vector<Quantities> quantities_of(std::string_view source) {
  std::vector<Quantities> all;
  each_kind([&](auto kind) {
    if (source_key(kind) != source) return;
    for (const ElementQuantity& quantity : kind.quantities) {
      const auto word = std::find(kQuantityWords.begin(), kQuantityWords.end(), quantity.name);
      const auto known = static_cast<Quantities>(word - kQuantityWords.begin());
      if (std::find(all.begin(), all.end(), known) == all.end()) all.push_back(known);
    }
  });
  return all;
}

/// Whether a quantity of a source has components; any quantity if `name` is empty.
bool has_components(std::string_view source, std::string_view name) {
  bool has = false;
  each_kind([&](auto kind) {
    for (const ElementQuantity& quantity : kind.quantities)
      has = has || (source_key(kind) == source && (name.empty() || name == quantity.name) && quantity.components > 1);
  });
  return has;
}

/// The element of a source: its kind and index, with a problem for none or several.
ElementOutput named_element(Reader& reader, const Value& value, std::string_view source) {
  const Value& written = *find(value, source);
  ElementOutput output;
  NameMap<int> known;
  std::vector<std::string> found;
  int index = 0;
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    const int place = index++;
    if (source_key(kind) != source || written.kind != Value::Kind::text) return;
    const NameMap<int>& names = names_of<Kind>(reader);
    if (output.kind < 0) output.kind = place;
    known.insert(names.begin(), names.end());
    const auto element = find_visible(names, written.text, current_scope(reader).visible);
    if (element == names.end()) return;
    output.kind = place;
    output.element = element->second;
    found.push_back(with_article(kind.words));
  });
  if (found.size() > 1)
    report(reader, written, fmt::format("{} is {}", in_quotes(written.text), fmt::join(found, " and ")),
           "rename one of them");
  if (found.empty()) find_element(reader, value, source, known);
  if (found.size() != 1) output.element = -1;
  return output;
}

}  // namespace

Resolved element_output(Reader& reader, const Value& value, const OutputFields& output, std::string_view source) {
  std::string_view words;
  each_element_source([&](auto kind) {
    if (source_key(kind) == source) words = kind.words;
  });
  const Quantities quantity = quantity_of(reader, value, output, quantities_of(source), words);
  const std::string_view name = kQuantityWords[static_cast<std::size_t>(quantity)];
  const bool has_axis = has_components(source, name);
  if (has_axis)
    require(reader, value, "axis", source);
  else if (has_components(source, ""))
    refuse(reader, value, "axis", name);
  ElementOutput element = named_element(reader, value, source);
  if (has_axis) element.axis = static_cast<int>(output.axis.value_or(Letter::x));
  with_kind(element.kind, [&](auto kind) {
    element.quantity = quantity_index(kind, name);
    if (element.element < 0 || name != kPotentialEnergy) return;
    if constexpr (kind.is_elastic) {
      const auto& of = kind.list(reader.model)[static_cast<std::size_t>(element.element)];
      if (element.quantity >= 0)
        tells_trouble(reader, value, of, "");
      else
        report(reader, *find(value, "quantity"),
               fmt::format("{} has {}", with_article(kind.words),
                           section_of(Leader<typename decltype(kind)::Element>())
                               .trouble(reader.model, static_cast<std::size_t>(element.element))));
    }
  });
  element.quantity = std::max(element.quantity, 0);
  return {element, unit_of(reader.model, element)};
}

Resolved elements_output(Reader& reader, const Value& value, const OutputFields& output) {
  constexpr std::array kStored = {Quantities::potential_energy};
  quantity_of(reader, value, output, kStored, "set of elements");
  bool is_told = false;  // the first trouble is enough
  each_element(reader.model, [&](const auto& element) {
    if constexpr (KindOf<std::decay_t<decltype(element)>>::is_elastic)
      is_told = is_told ||
                tells_trouble(reader, value, element, "ask for the energy of each of the other elements by itself");
  });
  return {StoredEnergyOutput{}, "J"};
}

}  // namespace mbgen::reading
