#include "workbench/import/known.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace mbgen::importing {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

bool has_word(std::string_view list, std::string_view word) {
  const std::vector<std::string_view> words = words_of(list);
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Contexts of the elements allowed in this one, itself first.
std::vector<std::string_view> contexts_of(const KnownFormat& format, std::string_view context) {
  std::vector<std::string_view> contexts = {context};
  for (const SameContext& same : format.contexts) {
    if (same.context == context) contexts.push_back(same.as);
  }
  return contexts;
}

const KnownElement* row_of(const KnownFormat& format, std::string_view context, std::string_view name) {
  for (const std::string_view candidate : contexts_of(format, context)) {
    const std::string path = fmt::format("{}/{}", candidate, name);
    for (const KnownElement& row : format.elements)
      if (row.path == path) return &row;
  }
  return nullptr;
}

/// Names of the elements allowed in a context.
std::vector<std::string_view> names_in(const KnownFormat& format, std::string_view context) {
  std::vector<std::string_view> names;
  for (const std::string_view candidate : contexts_of(format, context)) {
    for (const KnownElement& row : format.elements) {
      const std::size_t slash = row.path.find('/');
      if (row.path.substr(0, slash) == candidate) names.push_back(row.path.substr(slash + 1));
    }
  }
  return names;
}

std::vector<std::string_view> attributes_of(const KnownFormat& format, const KnownElement& row) {
  std::vector<std::string_view> names = words_of(row.read);
  for (const std::string_view name : words_of(row.quiet)) names.push_back(name);
  for (const LostAttribute& lost : format.lost)
    if (lost.path == row.path) names.push_back(lost.name);
  return names;
}

/// Names with a prefix belong to other programs; xmlns declares them.
bool is_foreign(std::string_view name) { return name.find(':') != std::string_view::npos; }
bool is_namespace(std::string_view name) { return name == "xmlns" || name.starts_with("xmlns:"); }

struct Walk {
  struct Told {
    Spot first;
    int count = 0;
    std::string before, after, hint;  ///< the number of places is inserted between
  };
  Reading& reading;
  const KnownFormat& format;
  std::map<std::string, Told> told = {};
  std::map<std::string, std::vector<std::string>> quiet = {};  ///< attributes by element
  Spot first_quiet = {};

  void add_told(Spot spot, std::string before, std::string after, const std::string& hint = {}) {
    Told& entry = told[before + after];
    if (entry.count++ == 0) entry = {spot, 1, std::move(before), std::move(after), hint};
  }

  void add_quiet(Spot spot, const std::string& element, const std::string& name) {
    if (quiet.empty()) first_quiet = spot;
    std::vector<std::string>& names = quiet[element];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }

  void attribute(const Element& element, const KnownElement& row, const Attribute& attribute) {
    if (is_namespace(attribute.name) || has_word(row.read, attribute.name)) return;
    if (has_word(row.quiet, attribute.name)) return add_quiet(attribute.spot, element.name, attribute.name);
    for (const LostAttribute& lost : format.lost) {
      if (lost.path != row.path || lost.name != attribute.name) continue;
      return add_told(attribute.spot, fmt::format("{} of <{}>", attribute.name, element.name),
                      fmt::format(" is not carried over: {}", lost.reason));
    }
    add_told(attribute.spot,
             fmt::format("<{}> has no attribute {} in {}", element.name, quoted_text(attribute.name), format.name),
             ": it is not carried over", did_you_mean(attribute.name, attributes_of(format, row)));
  }

  void element(const Element& element, std::string_view context) {
    const KnownElement* row = row_of(format, context, element.name);
    if (!row) {
      const bool foreign = is_foreign(element.name);
      return add_told(element.spot, fmt::format("<{}>", element.name),
                      foreign ? " not carried over: it is of another program"
                              : fmt::format(" not carried over: it is unknown in <{}>", context),
                      foreign ? "" : did_you_mean(element.name, names_in(format, context)));
    }
    if (row->left_out == "-") return;
    if (!row->left_out.empty())
      return add_told(element.spot, fmt::format("<{}>", element.name),
                      fmt::format(" not carried over: {}", row->left_out));
    if (row->is_quiet) return add_quiet(element.spot, element.name, "");
    for (const Attribute& attribute : element.attributes) this->attribute(element, *row, attribute);
    const std::string_view inside = row->path.substr(row->path.find('/') + 1);
    for (const Element& inner : element.children) this->element(inner, inside);
  }
};

}  // namespace

bool is_known(const KnownFormat& format, std::string_view path, std::string_view attribute) {
  const std::size_t slash = path.find('/');
  const KnownElement* row = row_of(format, path.substr(0, slash), path.substr(slash + 1));
  if (!row) return false;
  if (!row->left_out.empty() || row->is_quiet) return true;
  const std::vector<std::string_view> names = attributes_of(format, *row);
  return attribute.empty() || std::find(names.begin(), names.end(), attribute) != names.end();
}

void note_left_out(Reading& reading, const Element& root, const KnownFormat& format) {
  Walk walk{reading, format};
  walk.element(root, "");
  for (const auto& [key, told] : walk.told) {
    const std::string times = told.count > 1 ? fmt::format(" ({} of them)", told.count) : std::string();
    note(reading, told.first, told.before + times + told.after, told.hint);
  }
  if (walk.quiet.empty()) return;
  std::string list;
  for (const auto& [element, names] : walk.quiet) {
    list += fmt::format("{}<{}>", list.empty() ? "" : "; ", element);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!names[i].empty()) list += fmt::format("{}{}", i == 0 ? " " : ", ", names[i]);
  }
  note(reading, walk.first_quiet, "not carried over, without a part in the motion of the model: " + list);
}

}  // namespace mbgen::importing
