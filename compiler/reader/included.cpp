// Changes of included files: items and sections that are removed or replaced.
#include "compiler/reader/included.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mbgen::reading {
namespace {

/// The parts of a JSON Pointer; nothing for a text that is none, or that names the whole file.
std::optional<std::vector<std::string>> steps_of_pointer(std::string_view pointer) {
  if (pointer.size() < 2 || pointer.front() != '/') return {};
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      steps.emplace_back();
    } else if (pointer[i] != '~') {
      steps.back() += pointer[i];
    } else {
      const char next = i + 1 < pointer.size() ? pointer[++i] : ' ';
      if (next != '0' && next != '1') return {};
      steps.back() += next == '0' ? '~' : '/';
    }
  }
  return steps;
}

/// Position of a step in an object or array; nothing where it has none.
std::optional<std::size_t> position_of(const Value& value, const std::string& step) {
  if (value.kind == Value::Kind::object) {
    const auto is_it = [&](const Member& member) { return member.key == step; };
    const auto found = std::find_if(value.members.begin(), value.members.end(), is_it);
    if (found == value.members.end()) return {};
    return static_cast<std::size_t>(found - value.members.begin());
  }
  if (value.kind != Value::Kind::array) return {};
  return find_item(value, step);
}

template <class AnyValue>
AnyValue& inside(AnyValue& value, std::size_t position) {
  return value.kind == Value::Kind::object ? value.members[position].value : value.items[position];
}

/// Follows the steps. Result: the number of them that the file has.
std::size_t steps_there(const Value& root, Change& change) {
  const Value* value = &root;
  for (std::size_t i = 0; i < change.steps.size(); ++i) {
    const std::optional<std::size_t> position = position_of(*value, change.steps[i]);
    if (position) {
      value = &inside(*value, *position);
      continue;
    }
    if (i < change.reached) return i;
    if (i > change.reached) change.nearby.clear();
    change.reached = i;
    for (const Member& member : value->members) change.nearby.push_back(member.key);
    return i;
  }
  return change.steps.size();
}

/// Positions of the steps, which are all there.
std::vector<std::size_t> positions_of(const Value& root, const Change& change) {
  std::vector<std::size_t> positions;
  const Value* value = &root;
  for (const std::string& step : change.steps) {
    positions.push_back(*position_of(*value, step));
    value = &inside(*value, positions.back());
  }
  return positions;
}

/// Requires: all steps are there.
void make(Value& root, const Change& change) {
  Value* holder = &root;
  for (std::size_t i = 0; i + 1 < change.steps.size(); ++i)
    holder = &inside(*holder, *position_of(*holder, change.steps[i]));
  const std::size_t position = *position_of(*holder, change.steps.back());
  if (change.value) {
    inside(*holder, position) = *change.value;
  } else if (holder->kind == Value::Kind::object) {
    holder->members.erase(holder->members.begin() + static_cast<std::ptrdiff_t>(position));
  } else {
    holder->items.erase(holder->items.begin() + static_cast<std::ptrdiff_t>(position));
  }
}

void add_change(Reader& reader, const std::string& pointer, Place place, const Value* value, Changes& changes) {
  std::optional<std::vector<std::string>> steps = steps_of_pointer(pointer);
  if (!steps) {
    report(reader, place, in_quotes(pointer) + " names nothing in a file", "write it as \"/springs/front\"");
    return;
  }
  for (const Change& other : changes) {
    const std::size_t common = std::min(steps->size(), other.steps.size());
    if (!std::equal(steps->begin(), steps->begin() + static_cast<std::ptrdiff_t>(common), other.steps.begin()))
      continue;
    report(reader, place,
           in_quotes(pointer) + (steps->size() == other.steps.size()
                                     ? " is changed twice"
                                     : " and " + in_quotes(other.pointer) + " lie in one another"));
    return;
  }
  changes.push_back({pointer, std::move(*steps), place, value});
}

}  // namespace

Changes read_changes(Reader& reader, const IncludeFields& include) {
  Changes changes;
  if (const Value* remove = include.remove; remove && remove->kind != Value::Kind::array) {
    report(reader, *remove, "must be an array of pointers, got " + describe(*remove));
  } else if (remove) {
    for (const Value& item : remove->items) {
      if (item.kind == Value::Kind::text)
        add_change(reader, item.text, item.place, nullptr, changes);
      else
        report(reader, item, "must be a pointer into the file, as \"/springs/front\", got " + describe(item));
    }
  }
  if (const Value* replace = include.replace; replace && replace->kind != Value::Kind::object) {
    report(reader, *replace, "must be an object of pointers with their new values, got " + describe(*replace));
  } else if (replace) {
    for (const Member& member : replace->members) add_change(reader, member.key, member.place, &member.value, changes);
  }
  return changes;
}

const Value& with_changes(Reader& reader, const Value& root, Changes& changes) {
  std::vector<const Change*> fitting;
  for (Change& change : changes) {
    if (steps_there(root, change) < change.steps.size()) continue;
    change.is_made = true;
    fitting.push_back(&change);
  }
  if (fitting.empty()) return root;
  // Items of arrays that go are counted as the file has them: from the last one on.
  std::sort(fitting.begin(), fitting.end(),
            [&](const Change* a, const Change* b) { return positions_of(root, *a) > positions_of(root, *b); });
  Value& changed = reader.changed_files.emplace_back(root);
  for (const Change* change : fitting) make(changed, *change);
  return changed;
}

void report_unmade(Reader& reader, const std::string& file, const Changes& changes) {
  for (const Change& change : changes) {
    if (change.is_made) continue;
    const std::vector<std::string_view> known(change.nearby.begin(), change.nearby.end());
    const std::string hint = suggests(reader) ? did_you_mean(change.steps[change.reached], known) : "";
    report(reader, change.place, fmt::format("{} has no {}", in_quotes(file), in_quotes(change.pointer)), hint);
  }
}

}  // namespace mbgen::reading
