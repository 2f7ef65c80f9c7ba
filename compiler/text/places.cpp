// Positions of values in messages: file, line, column, JSON pointer.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "compiler/text/document.hpp"

namespace mbgen::reading {
namespace {

constexpr std::size_t kLongestShownLine = 240;

std::string escaped(const std::string& key) {
  std::string text;
  for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

/// Last element that starts at or before the offset, or the end.
template <class Elements>
auto last_at_or_before(const Elements& elements, std::uint32_t offset) {
  const auto after = std::upper_bound(elements.begin(), elements.end(), offset,
                                      [](std::uint32_t at, const auto& element) { return at < element.place.offset; });
  return after == elements.begin() ? elements.end() : after - 1;
}

std::string pointer_of(const Value& root, std::uint32_t offset) {
  std::string pointer;
  const Value* value = &root;
  while (true) {
    if (value->kind == Value::Kind::object) {
      const auto member = last_at_or_before(value->members, offset);
      if (member == value->members.end()) return pointer;
      pointer += '/';
      pointer += escaped(member->key);
      if (offset < member->value.place.offset) return pointer;
      value = &member->value;
    } else if (value->kind == Value::Kind::array) {
      const auto item = last_at_or_before(value->items, offset);
      if (item == value->items.end()) return pointer;
      pointer += fmt::format("/{}", item - value->items.begin());
      value = &*item;
    } else {
      return pointer;
    }
  }
}

}  // namespace

const Member* find_member(const Value& object, std::string_view key) {
  const auto found = std::find_if(object.members.begin(), object.members.end(),
                                  [&](const Member& member) { return member.key == key; });
  return found == object.members.end() ? nullptr : &*found;
}

std::optional<std::size_t> find_item(const Value& array, std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number && index < array.items.size() ? std::optional(index) : std::nullopt;
}

const Value* find(const Value& object, std::string_view key) {
  const Member* member = find_member(object, key);
  return member ? &member->value : nullptr;
}

Where where_of(const Documents& documents, Place place) {
  const Document& document = documents[place.file];
  const auto& starts = document.line_starts;
  const auto after = std::upper_bound(starts.begin(), starts.end(), place.offset);
  const std::uint32_t start = after == starts.begin() ? 0 : *(after - 1);
  Where where;
  where.file = document.file;
  where.line = static_cast<int>(std::max<std::ptrdiff_t>(after - starts.begin(), 1));
  where.column = static_cast<int>(place.offset - start) + 1;
  where.pointer = pointer_of(document.root, place.offset);
  // Limited to the length shown: a file may be one line.
  const std::string_view shown = std::string_view(document.text).substr(start, kLongestShownLine + 2);
  const std::size_t length = std::min(shown.find('\n'), shown.size());
  if (document.is_shown && length <= kLongestShownLine) {
    where.line_text = shown.substr(0, length);
    if (where.line_text.ends_with('\r')) where.line_text.pop_back();
  }
  return where;
}

std::string place_text(const Documents& documents, Place place, Place from) {
  const Where where = where_of(documents, place);
  const std::string position = fmt::format("{}:{}", where.line, where.column);
  return place.file == from.file ? position : where.file + ":" + position;
}

Place place_in_text(const Documents& documents, const Value& value, std::size_t index) {
  const std::string_view text = documents[value.place.file].text;
  std::size_t at = value.place.offset + 1;
  for (std::size_t decoded = 0; decoded < index && at < text.size() && text[at] != '"';) {
    if (text[at] != '\\') {
      ++at;
      ++decoded;
      continue;
    }
    // \uXXXX gives one to four bytes; exact for one byte, the only case within expressions.
    at += at + 1 < text.size() && text[at + 1] == 'u' ? 6 : 2;
    ++decoded;
  }
  return {value.place.file, static_cast<std::uint32_t>(std::min(at, text.size()))};
}

Diagnostics to_diagnostics(const Documents& documents, Problems problems) {
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.file, a.place.offset) < std::tie(b.place.file, b.place.offset);
  });
  Diagnostics diagnostics;
  for (std::size_t start = 0, end = 0; start < problems.size(); start = end) {
    const Place place = problems[start].place;
    while (end < problems.size() && problems[end].place.file == place.file &&
           problems[end].place.offset == place.offset)
      ++end;
    // Problems common to several instances follow the first of them.
    for (std::size_t i = start; i < end; ++i) {
      const auto says_the_same = [&](const Problem& other) {
        return same_but_for_instance(other.message, problems[i].message);
      };
      const auto first = problems.begin() + static_cast<std::ptrdiff_t>(start);
      const auto here = problems.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::any_of(first, here, says_the_same)) continue;
      std::set<std::string> others;  // instances; one may say it several times
      for (auto one = here + 1; one != problems.begin() + static_cast<std::ptrdiff_t>(end); ++one)
        if (says_the_same(*one) && one->instance != here->instance) others.insert(one->instance);
      const std::size_t more = others.size();
      std::string message = problems[i].message;
      if (!problems[i].instance.empty()) message += ", in instance " + in_quotes(problems[i].instance);
      if (!problems[i].instance.empty() && more > 0) message += fmt::format(" and {} more", more);
      diagnostics.push_back({where_of(documents, place), std::move(message), problems[i].hint, {}});
    }
  }
  return diagnostics;
}

std::string describe(const Value& value) {
  switch (value.kind) {
    case Value::Kind::null:
      return "null";
    case Value::Kind::boolean:
      return value.boolean ? "true" : "false";
    case Value::Kind::number:
      return fmt::format("{}", value.number);
    case Value::Kind::text:
      return in_quotes(value.text);
    case Value::Kind::array:
      return value.items.empty() ? "an empty array" : fmt::format("an array of {}", value.items.size());
    case Value::Kind::object:
      return value.members.empty() ? "an empty object" : "an object";
  }
  return {};
}

}  // namespace mbgen::reading
