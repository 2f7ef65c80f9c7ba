// Tables: curves by points, maps by grids of points.
#include "compiler/reader/tables/read_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/curve.hpp"
#include "compiler/expressions/named_table.hpp"
#include "compiler/expressions/overshoot.hpp"
#include "compiler/expressions/table_pieces.hpp"
#include "compiler/reader/tables/csv_table.hpp"
#include "compiler/reader/tables/table_fields.hpp"

namespace mbgen::reading {
namespace {

/// Checks that points come either from the model or from a file, and columns from a file.
void check_table(Reader& reader, const Value& value) {
  const Member *points = find_member(value, "table"), *csv = find_member(value, "csv");
  if (!points && !csv) report(reader, value, "a table needs \"table\" or \"csv\"");
  if (points && csv) report(reader, csv->place, "table has both \"table\" and \"csv\"");
  for (const std::string_view key : {"x", "y"}) {
    const Member* column = find_member(value, key);
    if (column && !csv)
      report(reader, column->place, fmt::format("a table without \"csv\" takes no {}", in_quotes(key)));
  }
}

/// Place of numbers among the samples; equal ones, as in a part placed four times, are stored once.
int place_of_numbers(Reader& reader, const std::vector<double>& numbers) {
  std::vector<double>& samples = *reader.samples;
  for (const auto& [first, count] : reader.stored_numbers)
    if (count == numbers.size() && std::equal(numbers.begin(), numbers.end(), samples.begin() + first)) return first;
  const auto first = static_cast<int>(samples.size());
  reader.stored_numbers.emplace_back(first, numbers.size());
  samples.insert(samples.end(), numbers.begin(), numbers.end());
  return first;
}

/// Moves the pieces of a table of many points to the samples.
void keep_as_data(Reader& reader, const Value& value, Table& table) {
  if (table.x.size() > kMostPointsAsData) {
    const Member* csv = find_member(value, "csv");
    report(reader, csv ? csv->value : member_or_object(value, "table"),
           fmt::format("table has {} points, at most {} go into a solver", table.x.size(), kMostPointsAsData),
           "leave out points that lie on the curve through their neighbours");
    return;
  }
  table.data = {reader.samples, place_of_numbers(reader, pieces_of(table)), spacing_of(table)};
}

/// Notes a spline that overshoots its points by more than their range.
void note_overshoot(Reader& reader, const Value& value, const Table& table) {
  constexpr int kParts = 32;
  constexpr double kTold =
      0.5;  // of the range of the points; splines through smooth points overshoot by a few hundredths
  if (table.interpolation != Table::Interpolation::spline || table.slopes.size() < 2) return;
  const auto [least, most] = std::minmax_element(table.y.begin(), table.y.end());
  const Overshoot farthest = farthest_overshoot(table.x, *least, *most, kParts, [&](std::size_t i, double x) {
    return interpolate_monotone_cubic(table.x.data() + i, table.y.data() + i, table.slopes.data() + i, 2, x);
  });
  if (!(farthest.beyond > kTold * (*most - *least))) return;
  note(reader, value.place,
       fmt::format(
           "the spline leaves its points, which are {:.4g} to {:.4g}, by {:.4g} at {:.4g}, between {:g} and {:g}",
           *least, *most, farthest.beyond, farthest.at, table.x[farthest.piece], table.x[farthest.piece + 1]),
       "\"interpolation\": \"monotone_cubic\" and \"linear\" stay within the points");
}

/// The table of its fields, which were read from `value`. are_si: see CsvColumns.
Table table_of(Reader& reader, const Value& value, TableFields& fields, bool are_si) {
  check_table(reader, value);
  if (fields.csv && find(value, "csv")->kind == Value::Kind::text)
    fields.points = read_csv_table(reader, value, {.x = fields.x, .y = fields.y, .are_si = are_si});
  Table target{fields.interpolation, {}, {}, fields.periodic, {}, {}};
  for (const auto& [x, y] : fields.points) {
    target.x.push_back(x);
    target.y.push_back(y);
  }
  target.slopes = slopes_of(target);
  note_overshoot(reader, value, target);
  if (target.x.size() > kMostPointsAsOperations) keep_as_data(reader, value, target);
  return target;
}

/// Whether numbers increase; a problem names the first that does not. place(i): of a number.
template <class Place>
bool check_increase(Reader& reader, const std::vector<double>& lines, std::string_view name, const Place& place) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!(lines[i] <= lines[i - 1])) continue;
    report(reader, place(i), fmt::format("{} of a map must increase, {} comes after {}", name, lines[i], lines[i - 1]));
    return false;
  }
  return true;
}

/// x, y and z of a CSV file: y in its first line, then in each line x and z.
void read_grid(Reader& reader, const Value& value, MapFields& map) {
  const Value& file = *find(value, "csv");
  const std::vector<std::vector<CsvNumber>> lines = read_csv_grid(reader, file);
  if (lines.empty()) return;
  const std::size_t columns = lines.front().size();
  if (lines.size() < 3 || columns < 2) {
    report(reader, file, "map needs at least 2 lines of x and 2 columns of y",
           "the first line has y behind a heading, each further line x and the values of z");
    return;
  }
  for (const CsvNumber& y : lines.front()) map.y.push_back(y.number);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != columns + 1) {
      report(reader, lines[i].front().place,
             fmt::format("line has {} numbers, must have {}: x and a z for each y", lines[i].size(), columns + 1));
      return;
    }
    map.x.push_back(lines[i].front().number);
    map.z.emplace_back();
    for (std::size_t j = 1; j <= columns; ++j) map.z.back().push_back(lines[i][j].number);
  }
  check_increase(reader, map.x, "x", [&](std::size_t i) { return lines[i + 1].front().place; });
  check_increase(reader, map.y, "y", [&](std::size_t j) { return lines.front()[j].place; });
}

/// Checks x, y and z that stand in the model.
void check_grid(Reader& reader, const Value& value, const MapFields& map) {
  for (const std::string_view key : {"x", "y", "z"})
    if (!find(value, key)) return report(reader, value, fmt::format("a map needs {}, or \"csv\"", in_quotes(key)));
  const auto place_in = [&](std::string_view key) {
    return [&value, key](std::size_t i) { return find(value, key)->items[i].place; };
  };
  if (map.x.size() < 2 || map.y.size() < 2 || map.z.size() < 2) return;  // was reported
  check_increase(reader, map.x, "x", place_in("x"));
  check_increase(reader, map.y, "y", place_in("y"));
  const Value& z = *find(value, "z");
  if (map.z.size() != map.x.size())
    report(reader, z, fmt::format("z has {} rows, must have one for each of the {} x", map.z.size(), map.x.size()));
  for (std::size_t i = 0; i < map.z.size(); ++i)
    if (map.z[i].size() != map.y.size())
      report(reader, z.items[i],
             fmt::format("row of z has {} numbers, must have one for each of the {} y", map.z[i].size(), map.y.size()));
}

std::shared_ptr<NamedTable> named_map(Reader& reader, const Value& value, const MapFields& map) {
  std::vector<double> z;
  for (const std::vector<double>& row : map.z) z.insert(z.end(), row.begin(), row.end());
  const int degree = map.interpolation == Table::Interpolation::linear ? 1 : 3;
  const auto count = static_cast<std::size_t>((degree + 1) * (degree + 1));
  if ((map.x.size() - 1) * (map.y.size() - 1) * count > kMostPointsAsData) {
    report(reader, value,
           fmt::format("map has {} by {} points, which need more than {} coefficients", map.x.size(), map.y.size(),
                       kMostPointsAsData),
           "\"interpolation\": \"linear\" needs a quarter of those of \"monotone_cubic\"");
    return nullptr;
  }
  CharacteristicMap result{lines_before(map.x), lines_before(map.y), degree, reader.samples, 0};
  for (Table* line : {&result.along_x, &result.along_y})
    if (line->x.size() > kMostPointsAsOperations) keep_as_data(reader, value, *line);
  result.first = place_of_numbers(reader, map_coefficients(map.x, map.y, z, degree));
  return std::make_shared<NamedTable>(NamedTable{std::move(result), map.outside == Outside::hold});
}

void make_known(Reader& reader, const Entry& entry, std::shared_ptr<const NamedTable> table) {
  if (!reader.names.tables.emplace(entry.name, std::move(table)).second)
    report(reader, entry.place, in_quotes(entry.name) + " is the name of a table, too", "rename one of them");
}

/// Calls read(value, fields) for every entry with readable fields, and makes the table known that it gives, null after
/// a problem.
template <class Fields, class Read>
void read_named(Reader& reader, const Entries& entries, const Read& read) {
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    const std::size_t before = reader.problems.size();
    Fields fields = with_defaults<Fields>();
    std::shared_ptr<NamedTable> table;
    if (read_fields(reader, *entry.value, fields)) table = read(*entry.value, fields);
    if (reader.problems.size() != before) table = nullptr;
    if (table) {
      table->name = entry.name;
      table->is_chosen = table->is_chosen || find(*entry.value, "outside") != nullptr;
    }
    make_known(reader, entry, std::move(table));
  }
}

}  // namespace

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<std::array<double, 2>>& target) {
  if (value.kind != Value::Kind::array || value.items.size() < 2) {
    report(reader, value, fmt::format("must be an array of at least 2 points [x, y], got {}", describe(value)));
    return;
  }
  for (const Value& item : value.items) {
    std::array<double, 2> point{kUnreadable, kUnreadable};
    if (item.kind != Value::Kind::array || item.items.size() != 2) {
      report(reader, item, fmt::format("must be a point [x, y], got {}", describe(item)));
    } else {
      for (std::size_t i = 0; i < 2; ++i) read_value(reader, item.items[i], info, point[i]);
      if (!target.empty() && point[0] <= target.back()[0]) {
        report(reader, item.items[0],
               fmt::format("x of a table must increase, {} comes after {}", point[0], target.back()[0]));
      }
    }
    target.push_back(point);
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo&, Table& target) {
  if (value.kind != Value::Kind::object) {
    report(reader, value, fmt::format("must be a table, got {}", describe(value)));
    return;
  }
  TableFields fields = with_defaults<TableFields>();
  read_fields(reader, value, fields);
  target = table_of(reader, value, fields, true);
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<double>& target) {
  if (value.kind != Value::Kind::array || value.items.size() < 2)
    return report(reader, value, fmt::format("must be an array of at least 2 numbers, got {}", describe(value)));
  for (const Value& item : value.items) read_value(reader, item, info, target.emplace_back(kUnreadable));
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<std::vector<double>>& target) {
  if (value.kind != Value::Kind::array || value.items.size() < 2)
    return report(reader, value,
                  fmt::format("must be an array of at least 2 rows of numbers, got {}", describe(value)));
  for (const Value& item : value.items) read_value(reader, item, info, target.emplace_back());
}

void read_tables(Reader& reader, const Entries& entries) {
  read_named<NamedTableFields>(reader, entries, [&](const Value& value, NamedTableFields& fields) {
    const bool holds = fields.outside == Outside::hold;
    if (holds && fields.periodic)
      report(reader, *find(value, "outside"), "a periodic table has no outside", "leave out \"outside\"");
    return std::make_shared<NamedTable>(NamedTable{table_of(reader, value, fields, false), holds, fields.periodic});
  });
}

void read_maps(Reader& reader, const Entries& entries) {
  read_named<MapFields>(reader, entries, [&](const Value& value, MapFields& map) {
    const std::size_t before = reader.problems.size();
    const Member *csv = find_member(value, "csv"), *z = find_member(value, "z");
    if (csv && z) report(reader, csv->place, "map has both \"z\" and \"csv\"");
    if (csv && csv->value.kind == Value::Kind::text && !z) read_grid(reader, value, map);
    if (!csv) check_grid(reader, value, map);
    return reader.problems.size() == before ? named_map(reader, value, map) : nullptr;
  });
}

}  // namespace mbgen::reading
