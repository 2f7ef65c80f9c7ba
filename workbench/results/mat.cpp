// Tables as MAT files of level 4: records of a header (type, rows, columns, imaginary flag, length of the name; five
// 32-bit integers), the name with its final zero, and the values column by column.
// Source: "MAT-File Format", The MathWorks, "Level 4 MAT-Files".

#include "workbench/results/mat.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "workbench/results/faults.hpp"

namespace mbgen {
namespace {

static_assert(std::endian::native == std::endian::little,
              "MAT files are written in the order of a little-endian machine");

constexpr std::int32_t kDoubles = 0, kText = 51;  ///< little-endian doubles; text whose letters stand as bytes (P = 5)
constexpr std::size_t kMostEntries = 1'000'000'000;

/// The number of `count` little-endian bytes behind the others.
template <class Number>
void append_number(std::string& bytes, Number number) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

void append_header(std::string& bytes, const std::string& name, std::int32_t type, std::size_t rows,
                   std::size_t columns) {
  for (const std::size_t number : {static_cast<std::size_t>(type), rows, columns, std::size_t{0}, name.size() + 1}) {
    append_number(bytes, static_cast<std::int32_t>(number));
  }
  bytes.append(name.c_str(), name.size() + 1);
}

/// Lines of text as a matrix of letters, blanks behind the shorter ones.
void append_texts(std::string& bytes, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t width = 0;
  for (const std::string& text : texts) width = std::max(width, text.size());
  append_header(bytes, name, kText, texts.size(), width);
  for (std::size_t letter = 0; letter < width; ++letter) {
    for (const std::string& text : texts) bytes += letter < text.size() ? text[letter] : ' ';
  }
}

/// One matrix of a file, still as bytes.
struct Record {
  std::int32_t type = 0;
  std::size_t rows = 0, columns = 0;
  std::string_view bytes;
};

/// The first record, taken off the bytes. Fails: false when it is none of ours.
bool take_record(std::string_view& rest, std::string& name, Record& record) {
  std::array<std::int32_t, 5> header{};
  if (rest.size() < sizeof(header)) return false;
  std::memcpy(header.data(), rest.data(), sizeof(header));
  rest.remove_prefix(sizeof(header));
  const auto [type, rows, columns, imaginary, name_length] = header;
  if ((type != kDoubles && type != kText) || rows < 0 || columns < 0 || imaginary != 0 || name_length < 1) return false;
  record = {type, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns), {}};
  const std::size_t size = record.rows * record.columns * (type == kDoubles ? sizeof(double) : 1);
  if (record.rows * record.columns > kMostEntries || rest.size() < static_cast<std::size_t>(name_length) + size)
    return false;
  name = std::string(rest.substr(0, static_cast<std::size_t>(name_length) - 1));
  record.bytes = rest.substr(static_cast<std::size_t>(name_length), size);
  rest.remove_prefix(static_cast<std::size_t>(name_length) + size);
  return true;
}

/// Row of a matrix of letters, without the blanks behind.
std::string text_of(const Record& record, std::size_t row) {
  std::string text;
  for (std::size_t letter = 0; letter < record.columns; ++letter) text += record.bytes[letter * record.rows + row];
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

std::string mat_text(const Results& results) {
  std::string bytes;
  std::vector<std::string> names, units;
  for (const Column& column : results.columns) {
    names.push_back(column.heading.name);
    units.push_back(column.heading.unit);
  }
  append_texts(bytes, "names", names);
  append_texts(bytes, "units", units);
  append_header(bytes, "data", kDoubles, results.rows(), results.columns.size());
  for (const Column& column : results.columns) {
    for (const double value : column.values) append_number(bytes, value);
  }
  append_texts(bytes, "run", {results.run});
  return bytes;
}

bool is_mat(std::string_view bytes) {
  constexpr std::string_view kLevel5 = "MATLAB 5.0 MAT-file";
  if (bytes.starts_with(kLevel5)) return true;
  std::int32_t type = -1;
  if (bytes.size() < sizeof(type)) return false;
  std::memcpy(&type, bytes.data(), sizeof(type));
  constexpr std::int32_t kLargestType = 4100;  // of all byte orders in the format
  return (type >= 0 && type <= kLargestType) || bytes.substr(0, 2) == std::string_view("\0\0", 2);
}

Result<Results> read_mat(std::string_view bytes, const std::string& file) {
  const auto refuse = [&] {
    return table_fault(file, 0, "not a MAT file of level 4 as mbgen writes it, with data, names and units");
  };
  std::map<std::string, Record> records;
  while (!bytes.empty()) {
    std::string name;
    Record record;
    if (!take_record(bytes, name, record)) return refuse();
    records[name] = record;
  }
  const Record data = records["data"], names = records["names"], units = records["units"], run = records["run"];
  const bool fits = data.type == kDoubles && names.type == kText && units.type == kText && names.rows == data.columns &&
                    units.rows == data.columns;
  if (!fits || data.columns == 0) return refuse();
  Results results;
  for (std::size_t c = 0; c < data.columns; ++c) {
    Column column{{text_of(names, c), text_of(units, c)}, std::vector<double>(data.rows)};
    std::memcpy(column.values.data(), data.bytes.data() + c * data.rows * sizeof(double), data.rows * sizeof(double));
    results.columns.push_back(std::move(column));
  }
  if (run.rows == 1) results.run = text_of(run, 0);
  return results;
}

}  // namespace mbgen
