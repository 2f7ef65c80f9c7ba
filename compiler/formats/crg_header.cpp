#include "compiler/formats/crg_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kMostColumns = 100000;

std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// Exponent +e00 and the like, after a number.
bool is_signed_exponent(std::string_view text) {
  const auto take = [&](std::string_view among) {
    const bool is_there = !text.empty() && among.find(text.front()) != std::string_view::npos;
    if (is_there) text.remove_prefix(1);
    return is_there;
  };
  if (!take("+-") || !take("eE")) return false;
  take("+-");
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<CrgProblem> read_parameter(std::string_view text, CrgHeader& header, CrgEntries& parameters) {
  const std::size_t line = header.lines;
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    return at_line(line, fmt::format("must be NAME = number, got \"{}\"", text.substr(0, 60)));
  const std::string name = in_capitals(without_blanks(text.substr(0, equals)));
  const std::string_view written = without_blanks(text.substr(equals + 1));
  const std::optional<CrgNumber> number = crg_number(written);
  if (!number) return at_line(line, fmt::format("{} must be a number, got \"{}\"", name, written));
  if (number->is_odd) header.notes.push_back(odd_number(line, name + " = ", written, number->value));
  if ((name == "SCALE_LENGTH" || name == "SCALE_WIDTH") && !(number->value > 0))
    return at_line(line, fmt::format("{} must be positive, got {}", name, number->value));
  parameters[name] = number->value;
  return {};
}

std::optional<CrgProblem> read_format(std::string_view text, std::size_t line, CrgHeader& header) {
  const std::string name = in_capitals(without_blanks(text));
  if (name != "LRFI" && name != "LDFI" && name != "KRBI" && name != "KDBI")
    return at_line(line, fmt::format("data format must be one of LRFI, LDFI, KRBI, KDBI, got \"{}\"", name));
  header.format = {name[0] == 'K', name[1] == 'D'};
  return {};
}

std::optional<CrgProblem> read_column(std::string_view text, std::size_t line, CrgHeader& header) {
  const std::string name = in_capitals(without_blanks(text.substr(0, text.find(','))));
  const auto begins = [&](std::string_view with) { return name.starts_with(with); };
  if (header.columns.size() == kMostColumns) return at_line(line, "file has too many columns");
  if (begins("REFERENCE LINE PHI"))
    header.columns.push_back(CrgColumn::heading);
  else if (begins("REFERENCE LINE SLOPE"))
    header.columns.push_back(CrgColumn::slope);
  else if (begins("REFERENCE LINE BANKING"))
    header.columns.push_back(CrgColumn::banking);
  else if (begins("LONG SECTION")) {
    header.columns.push_back(CrgColumn::height);
    const std::size_t equals = name.find('=');
    if (equals == std::string::npos) return {};
    const std::string_view written = without_blanks(std::string_view(name).substr(equals + 1));
    const std::optional<CrgNumber> v = crg_number(written);
    if (!v) return at_line(line, fmt::format("v of a long section must be a number, got \"{}\"", written));
    if (v->is_odd) header.notes.push_back(odd_number(line, "v of a long section = ", written, v->value));
    header.v.push_back(v->value);
  } else {
    return at_line(line, fmt::format("unknown column \"{}\"", name),
                   "columns are the reference line's phi, slope and banking, and long sections");
  }
  return {};
}

/// Name of a file, possibly continued in further lines.
std::optional<CrgProblem> read_file_name(std::string_view text, std::size_t line, CrgHeader& header) {
  if (text.find('$') != std::string_view::npos)
    return at_line(line, fmt::format("file name \"{}\" has an environment variable, which mbgen does not read", text),
                   "write the name itself, relative to this file");
  header.file += text;
  return {};
}

/// A line of a block. Result: its problem.
std::optional<CrgProblem> read_line(const std::string& block, std::string_view line, CrgHeader& header) {
  const std::size_t number = header.lines;
  if (block == "ROAD_CRG") return read_parameter(line, header, header.parameters);
  if (block == "ROAD_CRG_OPTS") return read_parameter(line, header, header.options);
  if (block == "ROAD_CRG_MODS") return read_parameter(line, header, header.modifiers);
  if (block == "ROAD_CRG_FILE") return read_file_name(line, number, header);
  if (block != "KD_DEFINITION") return {};
  if (line.starts_with("#:")) return read_format(line.substr(2), number, header);
  return line.starts_with("D:") || line.starts_with("d:") ? read_column(line.substr(2), number, header) : std::nullopt;
}

}  // namespace

CrgProblem at_line(std::size_t line, std::string message, std::string hint) {
  return {line, 0, std::move(message), std::move(hint)};
}

std::optional<CrgNumber> crg_number(std::string_view text) {
  text = without_blanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string of_c;
  if (text.find_first_of("dD") != std::string_view::npos) {
    of_c = text;
    for (char& c : of_c) c = c == 'd' || c == 'D' ? 'e' : c;
    text = of_c;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return {};
  const std::string_view behind = text.substr(static_cast<std::size_t>(end - text.data()));
  if (!behind.empty() && !is_signed_exponent(behind)) return {};
  return CrgNumber{value, !behind.empty()};
}

CrgProblem odd_number(std::size_t line, std::string_view name, std::string_view written, double value) {
  return at_line(line, fmt::format("{}{} is read as {}, as the C API of ASAM reads it", name, written, value));
}

std::optional<CrgProblem> read_header(std::string_view text, CrgHeader& header) {
  std::string block;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    const std::size_t number = ++header.lines;
    if (line.starts_with("$$$$")) {
      header.data = at;
      if (!header.file.empty()) return at_line(number, "file has data of its own, and names another one that has them");
      return {};
    }
    if (line.starts_with('$')) {
      const std::string name = in_capitals(line.substr(1, line.find_first_of(" \t\r!") - 1));
      if (!name.empty())
        block = name;
      else if (line.find('!') == std::string_view::npos)
        block.clear();
      if (block == "KD_DEFINITION") header.definition = number;
      header.has_options |= block == "ROAD_CRG_OPTS";
      header.has_modifiers |= block == "ROAD_CRG_MODS";
      continue;
    }
    line = without_blanks(line.substr(0, line.find('!')));
    if (line.empty() || line.starts_with('*')) continue;
    if (std::optional<CrgProblem> problem = read_line(block, line, header)) return problem;
  }
  if (!header.file.empty()) return {};
  return at_line(header.lines, "file has no data: no line of $$$$ ends its text part");
}

}  // namespace mbgen
