// Numbers of a manoeuvre by the paths of their fields, for studies.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compiler/text/characters.hpp"
#include "workbench/manoeuvre/tables_manoeuvre.hpp"

namespace mbgen {
namespace reading {
namespace {

/// The value of a step, which an object gets where it has none; null where there is no place for it.
Value* reached(Value& value, const std::string& step) {
  if (value.kind == Value::Kind::array) {
    const std::optional<std::size_t> item = find_item(value, step);
    return item ? &value.items[*item] : nullptr;
  }
  if (value.kind != Value::Kind::object) return nullptr;
  const auto is_it = [&](const Member& member) { return member.key == step; };
  auto found = std::find_if(value.members.begin(), value.members.end(), is_it);
  if (found == value.members.end()) {
    Value added;
    added.kind = Value::Kind::object;
    added.place = value.place;
    found = value.members.insert(found, {step, value.place, std::move(added)});
  }
  return &found->value;
}

void put_value(Value& root, const ManoeuvreValue& put) {
  Value* value = &root;
  for (const std::string& step : split_at(put.name, '.'))
    if (value = reached(*value, step); !value) return;
  const Place place = value->place;
  *value = Value();
  value->kind = Value::Kind::number;
  value->place = place;
  value->number = put.value;
}

const ObjectKind* find_kind(const std::vector<ObjectKind>& kinds, std::string_view name) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const ObjectKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

bool is_number(const FieldInfo& info) { return info.shape == Shape::number && info.name != "mbgen_manoeuvre"; }

/// Names of the fields of a kind that are numbers, or hold some.
std::vector<std::string_view> names_of_numbers(const ObjectKind& kind) {
  std::vector<std::string_view> names;
  for (const FieldInfo& info : kind.fields)
    if (is_number(info) || !info.of.empty()) names.push_back(info.name);
  return names;
}

std::string unknown(const std::string& step, const ObjectKind& kind) {
  const std::string hint = did_you_mean(step, names_of_numbers(kind));
  return fmt::format("{} has no number \"{}\"{}{}", kind.name, step, hint.empty() ? "" : "; ", hint);
}

/// The field of a kind that a step names; null for none.
const FieldInfo* field_of(const ObjectKind& kind, const std::string& step) {
  const auto is_it = [&](const FieldInfo& info) { return info.name == step; };
  const auto found = std::find_if(kind.fields.begin(), kind.fields.end(), is_it);
  return found == kind.fields.end() ? nullptr : &*found;
}

ManoeuvreNumber number_of(const Value& root, const std::string& name) {
  const std::vector<ObjectKind> kinds = manoeuvre_kinds();
  const std::vector<std::string> steps = split_at(name, '.');
  const ObjectKind* kind = find_kind(kinds, find(root, "type")->text);
  const Value* value = &root;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (value && value->kind == Value::Kind::array) {
      const std::optional<std::size_t> item = find_item(*value, steps[i]);
      if (!item)
        return {"", fmt::format("{} has no item \"{}\" of {}, counted from 0", steps[i - 1], steps[i],
                                value->items.size())};
      value = &value->items[*item];
      continue;
    }
    const FieldInfo* field = field_of(*kind, steps[i]);
    const bool is_last = i + 1 == steps.size();
    if (field && is_number(*field) && is_last) return {std::string(field->unit), ""};
    const ObjectKind* next = field ? find_kind(kinds, field->of) : nullptr;
    if (!next) return {"", unknown(steps[i], *kind)};
    kind = next;
    value = value ? find(*value, steps[i]) : nullptr;
  }
  return {"", fmt::format("\"{}\" is no number: {}", name, did_you_mean("", names_of_numbers(*kind)))};
}

}  // namespace

void put_values(Value& root, const std::vector<ManoeuvreValue>& values) {
  for (const ManoeuvreValue& value : values) put_value(root, value);
}

}  // namespace reading

ManoeuvreNumber find_number(std::string_view text, const std::string& name) {
  using namespace reading;
  Document document;
  document.text = text;
  Problems problems;
  if (!parse_document(document, 0, problems)) return {"", "the manoeuvre cannot be read"};
  return number_of(document.root, name);
}

}  // namespace mbgen
