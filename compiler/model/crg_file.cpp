#include "compiler/model/crg_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace mbgen {
namespace {

constexpr std::size_t kRecord = 80, kMostColumns = 100000, kMostNumbers = 50000000;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::string_view without_blanks(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> crg_number(std::string_view text) {
  text = without_blanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// What columns of data are.
enum class CrgColumn { heading, slope, banking, height };

/// How numbers are written.
struct CrgFormat {
  bool is_binary = true, is_double = false;
  std::size_t size() const { return is_binary ? (is_double ? 8 : 4) : (is_double ? 20 : 10); }
};

/// The text part of a file.
struct CrgHeader {
  CrgEntries parameters, options, modifiers;
  std::vector<CrgColumn> columns;
  std::vector<double> v;  ///< of columns of heights that tell theirs
  CrgFormat format;
  std::size_t data = 0, lines = 0;  ///< where the data begin: byte, and lines before it
  std::size_t definition = 1;       ///< line of the block of columns

  std::optional<double> value(const char* name) const { return entry_of(parameters, name); }
  double value(const char* name, double fallback) const { return value(name).value_or(fallback); }
  /// A modifier that scales; 1 without.
  double scale(const char* name) const { return entry_of(modifiers, name).value_or(1); }
  /// Of elevations: 0 stands for none.
  double scale_of_height(const char* name) const { return scale(name) == 0 ? 1 : scale(name); }
};

CrgProblem at_line(std::size_t line, std::string message, std::string hint = {}) {
  return {line, 0, std::move(message), std::move(hint)};
}

std::optional<CrgProblem> read_parameter(std::string_view text, std::size_t line, CrgEntries& parameters) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    return at_line(line, fmt::format("must be NAME = number, got \"{}\"", text.substr(0, 60)));
  const std::string name = in_capitals(without_blanks(text.substr(0, equals)));
  const std::optional<double> value = crg_number(text.substr(equals + 1));
  if (!value)
    return at_line(line, fmt::format("{} must be a number, got \"{}\"", name, without_blanks(text.substr(equals + 1))));
  if ((name == "SCALE_LENGTH" || name == "SCALE_WIDTH") && !(*value > 0))
    return at_line(line, fmt::format("{} must be positive, got {}", name, *value));
  parameters[name] = *value;
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
    const std::optional<double> v = crg_number(std::string_view(name).substr(equals + 1));
    if (!v)
      return at_line(line, fmt::format("v of a long section must be a number, got \"{}\"", name.substr(equals + 1)));
    header.v.push_back(*v);
  } else {
    return at_line(line, fmt::format("unknown column \"{}\"", name),
                   "columns are the reference line's phi, slope and banking, and long sections");
  }
  return {};
}

/// Reads up to the line of $$$$ that ends the text part.
std::optional<CrgProblem> read_header(std::string_view text, CrgHeader& header) {
  std::string block;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    const std::size_t number = ++header.lines;
    if (line.starts_with("$$$$")) {
      header.data = at;
      return {};
    }
    if (line.starts_with('$')) {
      const std::string name = in_capitals(line.substr(1, line.find_first_of(" \t\r!") - 1));
      if (!name.empty())
        block = name;
      else if (line.find('!') == std::string_view::npos)
        block.clear();
      if (block == "KD_DEFINITION") header.definition = number;
      continue;
    }
    line = without_blanks(line.substr(0, line.find('!')));
    if (line.empty() || line.starts_with('*')) continue;
    std::optional<CrgProblem> problem;
    if (block == "ROAD_CRG") problem = read_parameter(line, number, header.parameters);
    if (block == "ROAD_CRG_OPTS") problem = read_parameter(line, number, header.options);
    if (block == "ROAD_CRG_MODS") problem = read_parameter(line, number, header.modifiers);
    if (block == "KD_DEFINITION" && line.starts_with("#:")) problem = read_format(line.substr(2), number, header);
    if (block == "KD_DEFINITION" && (line.starts_with("D:") || line.starts_with("d:")))
      problem = read_column(line.substr(2), number, header);
    if (problem) return problem;
  }
  return at_line(header.lines, "file has no data: no line of $$$$ ends its text part");
}

/// Numbers of the data, section by section.
struct CrgData {
  std::vector<double> numbers;
  std::size_t sections = 0;
};

double big_endian(std::string_view bytes) {
  std::uint64_t bits = 0;
  for (const char byte : bytes) bits = bits << 8 | static_cast<unsigned char>(byte);
  return bytes.size() == 8 ? std::bit_cast<double>(bits)
                           : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
}

/// Records are filled one after the other; the last one ends with NaN.
void read_binary(std::string_view data, const CrgHeader& header, CrgData& result) {
  const std::size_t size = header.format.size(), columns = header.columns.size();
  const std::size_t count = std::min(data.size() / kRecord * (kRecord / size), kMostNumbers);
  result.sections = count / columns;
  for (std::size_t i = 0; i < result.sections * columns; ++i)
    result.numbers.push_back(big_endian(data.substr(i * size, size)));
}

/// Every section begins with a new line of at most 80 characters.
std::optional<CrgProblem> read_text(std::string_view data, const CrgHeader& header, CrgData& result) {
  const std::size_t width = header.format.size(), columns = header.columns.size();
  const std::size_t of_record = kRecord / width;
  std::size_t line = header.lines, read = 0;
  for (std::size_t at = 0; at < data.size();) {
    const std::size_t end = std::min(data.find('\n', at), data.size());
    std::string_view record = data.substr(at, end - at);
    at = end + 1;
    ++line;
    if (without_blanks(record).empty()) continue;
    const std::size_t wanted = std::min(columns - read, of_record);
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::string_view field = without_blanks(record.substr(std::min(k * width, record.size()), width));
      const std::optional<double> number = field.starts_with('*') ? std::optional(kNotANumber) : crg_number(field);
      if (!number && field.empty())
        return at_line(line, fmt::format("section has {} numbers, {} columns are defined", read + k, columns));
      if (!number) return at_line(line, fmt::format("must be a number, got \"{}\"", field));
      result.numbers.push_back(*number);
    }
    if (result.numbers.size() > kMostNumbers) return at_line(line, "file has too many numbers");
    read = (read + wanted) % columns;
  }
  if (read != 0)
    return at_line(line, fmt::format("last section has {} numbers, {} columns are defined", read, columns));
  result.sections = result.numbers.size() / columns;
  return {};
}

/// Where the columns of heights are.
std::optional<CrgProblem> place_columns(const CrgHeader& header, std::size_t heights, CrgRoad& road) {
  if (!header.v.empty() && header.v.size() != heights)
    return at_line(header.definition, "some long sections tell their v, others do not");
  road.v = header.v;
  if (road.v.empty()) {
    const std::optional<double> right = header.value("LONG_SECTION_V_RIGHT"),
                                left = header.value("LONG_SECTION_V_LEFT");
    std::optional<double> step = header.value("LONG_SECTION_V_INCREMENT");
    if (!step && right && left && heights > 1) step = (*left - *right) / static_cast<double>(heights - 1);
    if (!right || !step)
      return at_line(header.definition, "file does not tell the v of its long sections",
                     "LONG_SECTION_V_RIGHT and LONG_SECTION_V_INCREMENT do");
    for (std::size_t k = 0; k < heights; ++k) road.v.push_back(*right + *step * static_cast<double>(k));
  }
  for (double& v : road.v) v *= header.scale("SCALE_WIDTH");
  for (std::size_t k = 1; k < heights; ++k)
    if (!(road.v[k] > road.v[k - 1]))
      return at_line(header.definition,
                     fmt::format("v of long sections must increase, {} comes after {}", road.v[k], road.v[k - 1]));
  return {};
}

/// Heights that are missing, by GRID_NAN_MODE: 2 (also for none and for numbers without a meaning) those to their
/// right, else to their left; 1 zero; each plus GRID_NAN_OFFSET. 0 leaves them missing, and such a road bears no wheel.
std::optional<CrgProblem> fill_heights(const CrgHeader& header, CrgRoad& road) {
  const double mode = entry_of(header.modifiers, "GRID_NAN_MODE").value_or(2);
  const double offset = entry_of(header.modifiers, "GRID_NAN_OFFSET").value_or(0);
  const std::size_t columns = road.v.size();
  for (std::size_t row = 0; row < road.heights.size(); row += columns) {
    double* const heights = &road.heights[row];
    std::vector<std::size_t> gaps;
    for (std::size_t k = 0; k < columns; ++k)
      if (std::isnan(heights[k])) gaps.push_back(k);
    if (gaps.empty()) continue;
    if (mode == 0)
      return CrgProblem{0, header.data,
                        fmt::format("section {} has no height at v = {:g}, and GRID_NAN_MODE = 0 leaves it so",
                                    row / columns + 1, road.v[gaps[0]]),
                        "GRID_NAN_MODE = 2 takes the height beside it, 1 takes 0"};
    for (const std::size_t k : gaps)
      if (mode == 1) heights[k] = 0;
    for (const std::size_t k : gaps)
      if (k > 0 && std::isnan(heights[k])) heights[k] = heights[k - 1];
    for (std::size_t k = columns - 1; k > 0; --k)
      if (std::isnan(heights[k - 1])) heights[k - 1] = heights[k];
    for (const std::size_t k : gaps) heights[k] = static_cast<double>(static_cast<float>(heights[k] + offset));
  }
  return {};
}

/// Integrates the headings: forward, or where the end is given both ways, each weighted by how near it began.
void lay_reference_line(const CrgHeader& header, bool is_curved, CrgRoad& road) {
  const std::size_t n = road.heading.size();
  const double h = road.increment, first = header.value("REFERENCE_LINE_START_PHI", 0);
  road.x.assign(n, header.value("REFERENCE_LINE_START_X", 0));
  road.y.assign(n, header.value("REFERENCE_LINE_START_Y", 0));
  road.heading[0] = first;
  const double bend = header.scale("SCALE_CURVATURE");
  for (double& heading : road.heading) heading = bend == 1 ? heading : first + bend * (heading - first);
  const bool is_scaled = bend != 1 || header.scale("SCALE_LENGTH") != 1;  // the line then ends elsewhere
  const auto end = [&](const char* name) { return is_scaled ? std::nullopt : header.value(name); };
  const std::optional<double> end_x = end("REFERENCE_LINE_END_X"), end_y = end("REFERENCE_LINE_END_Y");
  const bool both_ways = is_curved && end_x && end_y;
  std::vector<double> back_x(n, end_x.value_or(0)), back_y(n, end_y.value_or(0));
  for (std::size_t i = n - 1; both_ways && i > 0; --i) {
    back_x[i - 1] = back_x[i] - h * std::cos(road.heading[i]);
    back_y[i - 1] = back_y[i] - h * std::sin(road.heading[i]);
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double share = both_ways ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
    road.x[i] = (1 - share) * (road.x[i - 1] + h * std::cos(road.heading[i])) + share * back_x[i];
    road.y[i] = (1 - share) * (road.y[i - 1] + h * std::sin(road.heading[i])) + share * back_y[i];
  }
  road.end_x = end_x && end_y ? *end_x : road.x[n - 1];
  road.end_y = end_x && end_y ? *end_y : road.y[n - 1];
  road.end_heading = bend == 1 ? header.value("REFERENCE_LINE_END_PHI", road.heading[n - 1]) : road.heading[n - 1];
}

std::optional<CrgProblem> make_road(const CrgHeader& header, const CrgData& data, CrgRoad& road) {
  const std::size_t columns = header.columns.size();
  const auto heights = static_cast<std::size_t>(std::ranges::count(header.columns, CrgColumn::height));
  road.start = header.value("REFERENCE_LINE_START_U", 0);
  road.increment = header.value("REFERENCE_LINE_INCREMENT", 0);
  if (!(road.increment > 1e-6))
    return at_line(header.definition,
                   fmt::format("REFERENCE_LINE_INCREMENT must be above 1e-6 m, got {}", road.increment));
  road.increment *= header.scale("SCALE_LENGTH");
  if (heights < 2)
    return at_line(header.definition, fmt::format("a road needs 2 long sections, file defines {}", heights));
  if (data.sections < 2)
    return at_line(header.lines, fmt::format("a road needs 2 sections of data, file has {}", data.sections));
  if (std::optional<CrgProblem> problem = place_columns(header, heights, road)) return problem;
  const double steeper = header.scale_of_height("SCALE_SLOPE"), banked = header.scale_of_height("SCALE_BANKING");
  const double first_slope = steeper * header.value("REFERENCE_LINE_START_S", 0);
  const auto higher = static_cast<float>(header.scale_of_height("SCALE_Z_GRID"));
  bool is_curved = false, has_slope = false;
  road.heading.assign(data.sections, header.value("REFERENCE_LINE_START_PHI", 0));
  std::vector<double> slope(data.sections, first_slope);
  for (std::size_t i = 0; i < data.sections; ++i)
    for (std::size_t c = 0; c < columns; ++c) {
      const double number = data.numbers[i * columns + c];
      const CrgColumn column = header.columns[c];
      if (column == CrgColumn::height) {
        road.heights.push_back(static_cast<double>(higher * static_cast<float>(number)));
        continue;
      }
      if (!std::isfinite(number) && i > 0)
        return CrgProblem{0, header.data, fmt::format("column {} of section {} is no number", c + 1, i + 1), {}};
      if (column == CrgColumn::heading) is_curved = true, road.heading[i] = number;
      if (column == CrgColumn::slope) has_slope = true, slope[i] = steeper * number;
      if (column == CrgColumn::banking) road.banking.resize(data.sections, 0.0), road.banking[i] = banked * number;
    }
  if (std::optional<CrgProblem> problem = fill_heights(header, road)) return problem;
  for (std::size_t k = 0; k < road.heights.size(); ++k)
    if (!std::isfinite(road.heights[k]))
      return CrgProblem{0, header.data, fmt::format("section {} has no height", k / heights + 1), {}};
  if (road.banking.empty() && header.value("REFERENCE_LINE_START_B", 0) != 0)
    road.banking.assign(data.sections, banked * header.value("REFERENCE_LINE_START_B", 0));
  for (double& banking : road.banking)
    if (std::isnan(banking)) banking = 0;
  lay_reference_line(header, is_curved, road);
  road.line_height.assign(data.sections, header.value("REFERENCE_LINE_START_Z", 0));
  if (has_slope || first_slope != 0)
    for (std::size_t i = 1; i < data.sections; ++i)
      road.line_height[i] = road.line_height[i - 1] + slope[i] * road.increment;
  return {};
}

}  // namespace

std::optional<double> entry_of(const CrgEntries& entries, const char* name) {
  const auto found = entries.find(name);
  return found == entries.end() ? std::nullopt : std::optional(found->second);
}

std::optional<CrgProblem> read_crg(std::string_view text, CrgRoad& road) {
  CrgHeader header;
  CrgData data;
  if (std::optional<CrgProblem> problem = read_header(text, header)) return problem;
  if (header.columns.empty())
    return at_line(header.definition, "file defines no columns of data",
                   "lines of $KD_Definition that begin with D: do");
  const std::string_view numbers = text.substr(header.data);
  if (header.format.is_binary) {
    read_binary(numbers, header, data);
  } else if (std::optional<CrgProblem> problem = read_text(numbers, header, data)) {
    return problem;
  }
  road = {};
  road.options = std::move(header.options);
  road.modifiers = header.modifiers;
  return make_road(header, data, road);
}

}  // namespace mbgen
