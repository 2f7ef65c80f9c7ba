#include "workbench/import/xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <pugixml.hpp>

#include "compiler/text/number.hpp"

namespace mbgen::importing {
namespace {

constexpr int kMaximumDepth = 256;
constexpr std::size_t kMaximumElements = 2'000'000;
constexpr std::size_t kMaximumBytes = std::size_t{64} << 20;
constexpr std::size_t kLongestShownLine = 200;

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Offsets of the names of an element's attributes, in their order. Requires: well-formed XML at `offset`, the position
/// of the element's name.
std::vector<std::size_t> attribute_offsets(const std::string& text, std::size_t offset) {
  std::vector<std::size_t> offsets;
  const std::size_t end = text.size();
  std::size_t i = offset;
  const auto skip = [&](auto&& unwanted) {
    while (i < end && unwanted(text[i])) ++i;
  };
  skip([](char c) { return !is_blank(c) && c != '>' && c != '/'; });
  while (i < end) {
    skip(is_blank);
    if (i >= end || text[i] == '>' || text[i] == '/') break;
    offsets.push_back(i);
    skip([](char c) { return c != '"' && c != '\''; });
    if (i >= end) break;
    const char quote = text[i++];
    skip([quote](char c) { return c != quote; });
    ++i;
  }
  return offsets;
}

/// Recursive loading of files.
struct Loader {
  Reading& reading;
  std::size_t elements = 0;
  bool ok = true;

  void fail(Spot spot, std::string message, std::string hint = {}) {
    problem(reading, spot, std::move(message), std::move(hint));
    ok = false;
  }
};

bool load_children(Loader& loader, const pugi::xml_node& node, int file, int depth, Element& target,
                   std::vector<std::string>& open_files);

/// Parses a file; its root element is kept by `document`. Fails (null node, with a problem).
pugi::xml_node parse(Loader& loader, pugi::xml_document& document, int file) {
  const std::string& text = loader.reading.sources[static_cast<std::size_t>(file)].text;
  if (text.size() > kMaximumBytes) {
    loader.fail({file, 0}, fmt::format("file is larger than 64 MB, it has {} bytes", text.size()));
    return {};
  }
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    loader.fail({file, std::min(offset, text.size())},
                fmt::format("not well-formed XML: {}", std::string(result.description())),
                "a robot is described in a file of URDF (<robot>), SDF (<sdf>) or MJCF (<mujoco>)");
    return {};
  }
  return document.document_element();
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == text.npos ? std::string()
                            : std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

Element element_of(const Loader& loader, const pugi::xml_node& node, int file) {
  Element element;
  element.name = node.name();
  element.text = trimmed(node.child_value());
  element.spot = {file, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0))};
  const std::string& text = loader.reading.sources[static_cast<std::size_t>(file)].text;
  const std::vector<std::size_t> offsets = attribute_offsets(text, element.spot.offset);
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::size_t index = element.attributes.size();
    const std::size_t offset = index < offsets.size() ? offsets[index] : element.spot.offset;
    element.attributes.push_back({attribute.name(), attribute.value(), {file, offset}});
  }
  return element;
}

/// Replaces an <include> by the content of its file.
bool load_include(Loader& loader, const Element& include, int depth, Element& target,
                  std::vector<std::string>& open_files) {
  const std::optional<std::string> name = required_text(loader.reading, include, "file");
  if (!name) return loader.ok = false;
  // In MuJoCo the path is relative to the folder of the main file.
  const auto folder = std::filesystem::path(loader.reading.request.file).parent_path();
  const std::string path = (folder / *name).string();
  if (std::find(open_files.begin(), open_files.end(), path) != open_files.end()) {
    loader.fail(include.spot, fmt::format("file {} includes itself", quoted_text(*name)));
    return false;
  }
  std::optional<std::string> text = loader.reading.request.read ? loader.reading.request.read(path) : std::nullopt;
  if (!text) {
    loader.fail(include.spot, fmt::format("cannot read included file {}", quoted_text(path)),
                "the path is taken from the folder of the main file");
    return false;
  }
  const int file = add_source(loader.reading, path, std::move(*text));
  pugi::xml_document document;
  const pugi::xml_node root = parse(loader, document, file);
  if (!root) return false;
  open_files.push_back(path);
  const bool loaded = load_children(loader, root, file, depth, target, open_files);
  open_files.pop_back();
  return loaded;
}

bool load_children(Loader& loader, const pugi::xml_node& node, int file, int depth, Element& target,
                   std::vector<std::string>& open_files) {
  for (const pugi::xml_node& inner : node.children()) {
    if (inner.type() != pugi::node_element) continue;
    Element element = element_of(loader, inner, file);
    if (depth >= kMaximumDepth) {
      loader.fail(element.spot, fmt::format("elements are nested deeper than {} levels", kMaximumDepth));
      return false;
    }
    if (++loader.elements > kMaximumElements) {
      loader.fail(element.spot, fmt::format("more than {} elements", kMaximumElements));
      return false;
    }
    if (element.name == "include" && attribute(element, "file")) {
      if (!load_include(loader, element, depth + 1, target, open_files)) return false;
      continue;
    }
    if (!load_children(loader, inner, file, depth + 1, element, open_files)) return false;
    target.children.push_back(std::move(element));
  }
  return true;
}

/// A number as typed; infinite for inf and for numbers beyond double. Fails (nothing): it is no number.
std::optional<double> parse_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty() || std::isnan(value)) return std::nullopt;
  if (error != std::errc::result_out_of_range) return error == std::errc() ? std::optional(value) : std::nullopt;
  const std::size_t exponent = word.find_first_of("eE");
  const bool is_small = exponent == std::string_view::npos ? word.find('.') < 3 && word.find('0') < 2
                                                           : word.substr(exponent + 1).starts_with('-');
  if (is_small) return 0.0;
  return std::copysign(std::numeric_limits<double>::infinity(), word.starts_with('-') ? -1.0 : 1.0);
}

/// Numbers of an attribute; too large ones are refused, or infinite for limits.
std::optional<std::vector<double>> read_numbers(Reading& reading, const Attribute& attribute, std::size_t least,
                                                std::size_t most, bool are_limits) {
  std::vector<double> values;
  const std::string_view text = attribute.value;
  for (std::size_t i = 0; i < text.size();) {
    if (is_blank(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    std::optional<double> value = parse_number(word);
    if (!value || (!are_limits && std::isinf(*value))) {
      problem(reading, attribute.spot, fmt::format("{}: {} is not a finite number", attribute.name, quoted_text(word)));
      return std::nullopt;
    }
    const bool is_large = std::abs(*value) > kLargestNumber;
    if (is_large && !are_limits) {
      problem(reading, attribute.spot, fmt::format("{}: {} is larger than 1e15", attribute.name, quoted_text(word)));
      return std::nullopt;
    }
    if (is_large) value = std::copysign(std::numeric_limits<double>::infinity(), *value);
    values.push_back(*value);
    i = end;
  }
  if (values.size() < least || values.size() > most) {
    const std::string wanted = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    problem(reading, attribute.spot,
            fmt::format("{} takes {} number{}, got {}", attribute.name, wanted, most == 1 ? "" : "s", values.size()));
    return std::nullopt;
  }
  return values;
}

}  // namespace

int add_source(Reading& reading, std::string file, std::string text) {
  Source source{std::move(file), std::move(text), {0}};
  for (std::size_t i = 0; i < source.text.size(); ++i) {
    if (source.text[i] == '\n') source.line_starts.push_back(i + 1);
  }
  reading.sources.push_back(std::move(source));
  return static_cast<int>(reading.sources.size()) - 1;
}

std::optional<Element> read_xml(Reading& reading) {
  return read_xml(reading, reading.request.file, reading.request.text);
}

std::optional<Element> read_xml(Reading& reading, const std::string& name, const std::string& text) {
  Loader loader{reading};
  const int file = add_source(reading, name, text);
  pugi::xml_document document;
  const pugi::xml_node node = parse(loader, document, file);
  if (!node) return std::nullopt;
  Element root = element_of(loader, node, file);
  std::vector<std::string> open_files = {name};
  if (!load_children(loader, node, file, 1, root, open_files)) return std::nullopt;
  return root;
}

Where where_of(const Reading& reading, Spot spot) {
  const Source& source = reading.sources[static_cast<std::size_t>(spot.file)];
  const auto next = std::upper_bound(source.line_starts.begin(), source.line_starts.end(), spot.offset);
  const std::size_t start = *(next - 1);
  Where where;
  where.file = source.file;
  where.line = static_cast<int>(next - source.line_starts.begin());
  where.column = static_cast<int>(spot.offset - start) + 1;
  std::size_t end = next == source.line_starts.end() ? source.text.size() : *next - 1;
  if (end > start && source.text[end - 1] == '\r') --end;
  if (end - start <= kLongestShownLine) where.line_text = source.text.substr(start, end - start);
  return where;
}

void problem(Reading& reading, Spot spot, std::string message, std::string hint) {
  reading.problems.push_back({where_of(reading, spot), std::move(message), std::move(hint), {}});
}

void note(Reading& reading, Spot spot, std::string message, std::string hint) {
  reading.notes.push_back({where_of(reading, spot), std::move(message), std::move(hint), {}});
}

const Element* child(const Element& element, std::string_view name) {
  for (const Element& inner : element.children) {
    if (inner.name == name) return &inner;
  }
  return nullptr;
}

const Attribute* attribute(const Element& element, std::string_view name) {
  for (const Attribute& candidate : element.attributes) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

std::string text_of(const Element& element, std::string_view name) {
  const Attribute* found = attribute(element, name);
  return found ? found->value : std::string();
}

std::string quoted_text(std::string_view text) {
  constexpr std::size_t kMostShown = 60;
  std::string shown;
  for (const char c : text.substr(0, kMostShown)) shown += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  if (text.size() > kMostShown) shown += "...";
  return '"' + shown + '"';
}

std::optional<std::string> required_text(Reading& reading, const Element& element, std::string_view name) {
  const Attribute* found = attribute(element, name);
  if (found && !found->value.empty()) return found->value;
  problem(reading, found ? found->spot : element.spot, fmt::format("<{}> needs a {}", element.name, name));
  return std::nullopt;
}

std::optional<std::vector<double>> numbers(Reading& reading, const Attribute& attribute, std::size_t least,
                                           std::size_t most) {
  return read_numbers(reading, attribute, least, most, false);
}

std::optional<std::vector<double>> limits(Reading& reading, const Attribute& attribute, std::size_t least,
                                          std::size_t most) {
  return read_numbers(reading, attribute, least, most, true);
}

double number(Reading& reading, const Element& element, std::string_view name, double fallback) {
  const Attribute* found = attribute(element, name);
  if (!found) return fallback;
  const std::optional<std::vector<double>> values = numbers(reading, *found, 1, 1);
  return values ? values->front() : fallback;
}

}  // namespace mbgen::importing
