#include "compiler/reader/elements/composed.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mbgen::reading {

Composed::Composed(Place at) : place(at) {
  object.kind = Value::Kind::object;
  object.place = at;
}

void Composed::add(std::string_view key, Value value) {
  object.members.push_back({std::string(key), place, std::move(value)});
}

void Composed::add_text(std::string_view key, std::string text, Place at) {
  Value value;
  value.kind = Value::Kind::text;
  value.place = at;
  value.text = std::move(text);
  add(key, std::move(value));
}

Value Composed::number_at(Place place, double number) {
  Value value;
  value.kind = Value::Kind::number;
  value.place = place;
  value.number = number;
  return value;
}

void add_composed(Reader& reader, Entries& section, const Entry& element, std::string_view suffix, Composed part) {
  Entry entry = element;
  entry.written += suffix;
  entry.name = full_name(current_scope(reader).visible.front(), entry.written);
  if (!is_valid_name(entry.name))
    report(reader, element.place, fmt::format("invalid name {} of a part", in_quotes(entry.name)), kNameRule);
  entry.value = &reader.composed.emplace_back(std::move(part.object));
  section.push_back(std::move(entry));
}

void add_composed_hardpoint(Reader& reader, const Entry& element, const std::string& name,
                            const Vector3Quantity& position) {
  Hardpoints& known = reader.hardpoints;
  const std::string full = full_name(current_scope(reader).visible.front(), name);
  if (!known.names.emplace(full, static_cast<int>(known.list.size())).second)
    report(reader, element.place,
           fmt::format("hardpoint {} is defined, and {} makes one of this name", in_quotes(full),
                       in_quotes(element.written)),
           "rename one of them");
  known.list.push_back({full, reader.scope, element.place, position});
}

Entries with_composed(Reader& reader, Entries entries, const Entries& made) {
  const std::size_t own = entries.size();
  for (const Entry& part : made) {
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(own);
    const auto same = std::find_if(entries.begin(), end, [&](const Entry& one) { return one.name == part.name; });
    if (same != end)
      report(reader, same->place,
             fmt::format("name {} is defined twice, the element at {} has a part of this name", in_quotes(part.name),
                         place_text(reader.documents, part.place, same->place)),
             "rename one of them");
    else
      entries.push_back(part);
  }
  return entries;
}

}  // namespace mbgen::reading
