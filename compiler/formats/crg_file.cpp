#include "compiler/formats/crg_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "compiler/formats/crg_header.hpp"
#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kRecord = 80, kMostNumbers = 50000000;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

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

/// Sections that REFERENCE_LINE_END_U asks for, as the C API counts them; nothing without it, or where it is no end.
std::optional<std::size_t> asked_sections(const CrgHeader& header) {
  const std::optional<double> end = header.value("REFERENCE_LINE_END_U");
  const double start = header.value("REFERENCE_LINE_START_U", 0), step = header.value("REFERENCE_LINE_INCREMENT", 0);
  const double steps = end ? std::floor((*end - start) / step + 0.5) : 0;
  return steps >= 1 && steps < static_cast<double>(kMostNumbers) ? std::optional(static_cast<std::size_t>(steps) + 1)
                                                                 : std::nullopt;
}

/// "REFERENCE_LINE_END_U = 4 asks for 5 sections, file has 3"
std::string asks_and_has(const CrgHeader& header, std::size_t asked, std::size_t sections) {
  return fmt::format("REFERENCE_LINE_END_U = {} asks for {} sections, file has {}",
                     *header.value("REFERENCE_LINE_END_U"), asked, sections);
}

/// Numbers follow each other in records of kRecord bytes, the last one filled up with NaN: sections of nothing else
/// that lie in it whole are none, unless REFERENCE_LINE_END_U counts them.
std::optional<CrgProblem> read_binary(std::string_view data, CrgHeader& header, CrgData& result) {
  const std::size_t size = header.format.size(), columns = header.columns.size();
  const std::size_t count = std::min(data.size() / size, kMostNumbers);
  std::vector<double>& numbers = result.numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(big_endian(data.substr(i * size, size)));
  const std::size_t whole = count / columns;
  result.sections = whole;
  const std::size_t first_of_last_record = count - std::min(count, kRecord / size - 1);
  const auto is_filling = [&](std::size_t section) {
    const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(section * columns);
    return section * columns >= first_of_last_record &&
           std::all_of(begin, begin + static_cast<std::ptrdiff_t>(columns), [](double x) { return std::isnan(x); });
  };
  while (result.sections > 0 && is_filling(result.sections - 1)) --result.sections;
  const std::optional<std::size_t> asked = asked_sections(header);
  if (asked && *asked > whole)
    return at_line(header.lines, "data are cut off: " + asks_and_has(header, *asked, result.sections));
  if (asked && *asked < result.sections)
    header.notes.push_back(
        at_line(header.lines, asks_and_has(header, *asked, result.sections) + ": those beyond are left out"));
  result.sections = asked.value_or(result.sections);
  numbers.resize(result.sections * columns);
  return {};
}

/// The number of a field of data. Result: none if it is not a number; **** is NaN.
std::optional<double> number_of_field(std::string_view field, std::size_t line, CrgHeader& header) {
  if (field.starts_with('*')) return kNotANumber;
  const std::optional<CrgNumber> number = crg_number(field);
  if (!number) return {};
  const auto is_of_data = [&](const CrgProblem& note) { return note.line > header.lines; };
  if (number->is_odd && std::ranges::none_of(header.notes, is_of_data))
    header.notes.push_back(odd_number(line, "", field, number->value));
  return number->value;
}

/// Every section begins with a new line of at most 80 characters.
std::optional<CrgProblem> read_text(std::string_view data, CrgHeader& header, CrgData& result) {
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
      const std::optional<double> number = number_of_field(field, line, header);
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
  if (const std::optional<std::size_t> asked = asked_sections(header); asked && *asked != result.sections)
    header.notes.push_back(at_line(header.lines, asks_and_has(header, *asked, result.sections) + ": all are read"));
  return {};
}

/// Where the columns of heights are.
std::optional<CrgProblem> place_columns(CrgHeader& header, std::size_t heights, CrgRoad& road) {
  if (!header.v.empty() && header.v.size() != heights)
    return at_line(header.definition, "some long sections tell their v, others do not");
  road.v = header.v;
  if (road.v.empty()) {
    std::optional<double> right = header.value("LONG_SECTION_V_RIGHT"), step = header.value("LONG_SECTION_V_INCREMENT");
    const std::optional<double> left = header.value("LONG_SECTION_V_LEFT");
    const auto steps = static_cast<double>(heights - 1);
    if (!step && right && left) step = (*left - *right) / steps;
    if (!right && left && step) right = *left - *step * steps;
    if (!right && step) {
      right = 0;
      header.notes.push_back(
          at_line(header.definition,
                  fmt::format("file does not tell where its long sections begin: v is taken from 0 to {}, as "
                              "the C API of ASAM takes it",
                              *step * steps)));
    }
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

std::optional<CrgProblem> make_road(CrgHeader& header, const CrgData& data, CrgRoad& road) {
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

namespace {

/// Reads the data of a file with its header; road: what they make.
std::optional<CrgProblem> read_data(std::string_view text, CrgHeader& header, CrgRoad& road) {
  CrgData data;
  if (header.columns.empty())
    return at_line(header.definition, "file defines no columns of data",
                   "lines of $KD_Definition that begin with D: do");
  const std::string_view numbers = text.substr(header.data);
  if (std::optional<CrgProblem> problem =
          header.format.is_binary ? read_binary(numbers, header, data) : read_text(numbers, header, data))
    return problem;
  road = {};
  road.options = header.options;
  road.modifiers = header.modifiers;
  return make_road(header, data, road);
}

}  // namespace

std::string named_crg_file(std::string_view text) {
  CrgHeader header;
  return read_header(text, header) ? std::string() : header.file;
}

std::optional<CrgProblem> read_crg(std::span<const std::string_view> texts, CrgRoad& road) {
  std::vector<CrgProblem> notes;
  const auto in_file = [&](CrgProblem problem, std::size_t file) {
    problem.file = file;
    return problem;
  };
  CrgHeader naming;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    CrgHeader header;
    if (std::optional<CrgProblem> problem = read_header(texts[i], header)) return in_file(*problem, i);
    // Blocks of a file that names another take the place of those there.
    if (naming.has_options) header.options = naming.options, header.has_options = true;
    if (naming.has_modifiers) header.modifiers = naming.modifiers, header.has_modifiers = true;
    header.parameters.insert(naming.parameters.begin(), naming.parameters.end());
    std::optional<CrgProblem> problem;
    if (i + 1 == texts.size()) problem = read_data(texts[i], header, road);
    for (const CrgProblem& note : header.notes) notes.push_back(in_file(note, i));
    if (problem) return in_file(*problem, i);
    naming = std::move(header);
  }
  road.notes = std::move(notes);
  return {};
}

std::optional<CrgProblem> read_crg(std::string_view text, CrgRoad& road) { return read_crg(std::span(&text, 1), road); }

}  // namespace mbgen
