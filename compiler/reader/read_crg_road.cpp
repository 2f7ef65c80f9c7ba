// Roads of OpenCRG files: their tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/formats/crg_road.hpp"
#include "compiler/formats/crg_unsupported.hpp"
#include "compiler/reader/tables/csv_table.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kMostCells = 50000;  ///< of the plane around a reference line
constexpr std::size_t kMostHeights = 2000000;

/// Appends a table. Result: its index.
int add_table(std::vector<double>& samples, const std::vector<double>& numbers) {
  const auto first = static_cast<int>(samples.size());
  samples.insert(samples.end(), numbers.begin(), numbers.end());
  return first;
}

std::vector<double> line_of(const CrgRoad& road) {
  std::vector<double> line;
  const auto add = [&](std::size_t i) {
    line.insert(line.end(), {road.x[i], road.y[i], road.line_height[i], road.banking.empty() ? 0 : road.banking[i]});
  };
  const std::size_t last = road.sections() - 1;
  const bool is_ring = road.closure.kind == CrgClosure::Kind::meeting;
  add(is_ring ? last - 1 : 0);
  for (std::size_t i = 0; i <= last; ++i) add(i);
  add(is_ring ? 1 : last);
  return line;
}

/// Columns in equal cells, no wider than the narrowest column.
void add_column_cells(const CrgRoad& road, std::vector<double>& samples, RoadGrid& grid) {
  double narrowest = INFINITY;
  for (std::size_t k = 1; k < road.v.size(); ++k) narrowest = std::min(narrowest, road.v[k] - road.v[k - 1]);
  const double width = road.v.back() - road.v.front();
  // Slightly narrower, so that rounding never puts two borders into a cell.
  const double count = std::min(std::ceil(1.001 * width / narrowest), 1e6);
  grid.column_cell = width / count;
  grid.column_cell_count = static_cast<int>(count);
  std::vector<double> cells;
  std::size_t column = 0;
  for (int k = 0; k < grid.column_cell_count; ++k) {
    const double begin = road.v.front() + grid.column_cell * k;
    // A border within rounding of the start counts as after it: the comparison that follows is decisive.
    while (column + 2 < road.v.size() && road.v[column + 1] <= begin - 1e-9 * width) ++column;
    cells.push_back(static_cast<double>(column));
  }
  grid.column_cells = add_table(samples, cells);
}

/// The first of the sections nearest to a position. longest: distance of two neighbours, m; guess: a section near by.
/// Sections that cannot be nearer than the nearest so far are skipped: nearly all for a good guess.
std::size_t nearest_section(const CrgRoad& road, double longest, double x, double y, std::size_t guess) {
  constexpr double kRounding = 1e-9;
  const auto square_to = [&](std::size_t i) {
    const double dx = road.x[i] - x, dy = road.y[i] - y;
    return dx * dx + dy * dy;
  };
  std::size_t nearest = guess;
  double least = square_to(guess) * (1 + kRounding), distance = std::sqrt(least);  // slightly farther than the guess
  for (std::size_t i = 0; i < road.sections();) {
    const double square = square_to(i);
    if (square < least) {
      least = square;
      distance = std::sqrt(square);
      nearest = i;
    }
    const double passed = (1 - kRounding) * (std::sqrt(square) - distance) / longest;
    i += 1 + static_cast<std::size_t>(std::min(static_cast<double>(road.sections()), passed));
  }
  return nearest;
}

/// Sections by cells of the plane around the line.
void add_plane_cells(const CrgRoad& road, std::vector<double>& samples, RoadGrid& grid) {
  const double margin = std::max(std::abs(road.v.front()), std::abs(road.v.back())) + 4 * road.increment;
  const auto [left, right] = std::ranges::minmax(road.x);
  const auto [low, high] = std::ranges::minmax(road.y);
  const double width = right - left + 2 * margin, height = high - low + 2 * margin;
  grid.cell = std::max(2 * road.increment, std::sqrt(width * height / kMostCells));
  grid.cell_x = left - margin;
  grid.cell_y = low - margin;
  grid.cells_x = static_cast<int>(std::ceil(width / grid.cell));
  grid.cells_y = static_cast<int>(std::ceil(height / grid.cell));
  double longest = road.increment;
  for (std::size_t i = 1; i < road.sections(); ++i)
    longest = std::max(longest, std::hypot(road.x[i] - road.x[i - 1], road.y[i] - road.y[i - 1]));
  std::vector<double> cells;
  std::size_t nearest = 0;
  for (int row = 0; row < grid.cells_y; ++row)
    for (int k = 0; k < grid.cells_x; ++k) {
      const double x = grid.cell_x + (k + 0.5) * grid.cell, y = grid.cell_y + (row + 0.5) * grid.cell;
      nearest = nearest_section(road, longest, x, y, nearest);
      cells.push_back(static_cast<double>(std::max<std::size_t>(nearest, 1)));
    }
  grid.cells = add_table(samples, cells);
}

/// The files of a road, linked by $ROAD_CRG_FILE: their indices in the documents, and their names as written. Fails:
/// nothing, with a problem.
std::optional<std::vector<std::pair<std::size_t, std::string>>> files_of_road(Reader& reader, const Value& file) {
  constexpr std::size_t kMostFiles = 8;
  std::uint32_t index = 0;
  if (!open_beside(reader, file, "road", index)) return {};
  std::vector<std::pair<std::size_t, std::string>> files{{index, file.text}};
  for (;;) {
    const std::string named = named_crg_file(reader.documents[files.back().first].text);
    if (named.empty()) return files;
    if (files.size() == kMostFiles) {
      report(reader, file,
             fmt::format("road {}: $ROAD_CRG_FILE leads through more than {} files", in_quotes(file.text), kMostFiles));
      return {};
    }
    std::string problem;
    const Document* next = open_named(reader, reader.documents[files.back().first].file, named, index, problem);
    if (!next) {
      report(reader, file, fmt::format("{}: $ROAD_CRG_FILE {}: {}", files.back().second, in_quotes(named), problem));
      return {};
    }
    files.emplace_back(index, named);
  }
}

/// "road.crg, line 4: ..."
std::string text_of(const CrgProblem& problem, const std::string& file) {
  const std::string where =
      problem.line > 0 ? fmt::format("line {}", problem.line) : fmt::format("byte {}", problem.byte);
  return fmt::format("{}, {}: {}", file, where, problem.message);
}

bool read_files(Reader& reader, const Value& file, CrgRoad& road) {
  const auto files = files_of_road(reader, file);
  if (!files) return false;
  std::vector<std::string_view> texts;
  for (const auto& [index, name] : *files) texts.push_back(reader.documents[index].text);
  if (std::optional<CrgProblem> problem = read_crg(texts, road)) {
    if (!reader.documents[(*files)[problem->file].first].is_shown) problem->message = "file is no OpenCRG file";
    report(reader, file, text_of(*problem, (*files)[problem->file].second), problem->hint);
    return false;
  }
  for (const CrgProblem& each : road.notes)
    note(reader, file.place, text_of(each, (*files)[each.file].second), each.hint);
  return true;
}

}  // namespace

void read_crg_road(Reader& reader, const Value& value, Road& road) {
  CrgFields fields = with_defaults<CrgFields>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, value, fields) || reader.problems.size() > problems) return;
  const Value& file = *find(value, "file");
  CrgRoad read;
  if (!read_files(reader, file, read)) return;
  if (read.heights.size() > kMostHeights) {
    report(reader, file,
           fmt::format("road has {} heights, at most {} go into a solver", read.heights.size(), kMostHeights),
           "cut it shorter or thin it out");
    return;
  }
  read = closed_as_asked(relocated(std::move(read)));
  if (const std::vector<std::string> options = unsupported_options(read); !options.empty())
    note(reader, file.place,
         fmt::format("{} has options that mbgen does not follow: {}", fields.file, fmt::join(options, "; ")));
  RoadGrid& grid = road.grids.emplace_back();
  grid.is_straight = std::ranges::all_of(read.heading, [&](double heading) { return heading == read.heading[0]; }) &&
                     read.end_heading == read.heading[0];
  grid.line = add_table(*reader.samples, line_of(read));
  grid.heights = add_table(*reader.samples, read.heights);
  grid.columns = add_table(*reader.samples, read.v);
  add_column_cells(read, *reader.samples, grid);
  if (!grid.is_straight) add_plane_cells(read, *reader.samples, grid);
  grid.road = std::make_shared<const CrgRoad>(std::move(read));
  follow_options(grid);
  const auto take = [&](const char* key, auto& own, const auto& given) {
    if (find_member(value, key)) own = given;
  };
  take("smooth_begin", grid.smooth_begin, fields.smooth_begin);
  take("smooth_end", grid.smooth_end, fields.smooth_end);
  take("beyond_ends", grid.ends, fields.beyond_ends);
  take("beyond_sides", grid.sides, fields.beyond_sides);
  if (grid.road->closure.kind == CrgClosure::Kind::meeting) grid.ends = RoadBorder::keep, grid.end_offset = 0;
}

}  // namespace mbgen::reading
