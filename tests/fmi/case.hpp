#pragma once
// What the importer drives: an FMU, its description and the table of `mbgen simulate`.

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "description.hpp"
#include "library.hpp"

constexpr int kOk = 0, kWarning = 1, kDiscard = 2, kError = 3;

using Row = std::vector<double>;

/// The table of `mbgen simulate`: names of its columns but time and residual, and their rows.
struct Table {
  std::vector<std::string> names;
  std::vector<Row> rows;
};

inline Table read_table(const std::string& path) {
  std::ifstream file(path);
  std::string line, field;
  Table table;
  std::getline(file, line);
  for (std::istringstream fields(line); std::getline(fields, field, ',');)
    table.names.push_back(field.substr(0, field.find(' ')));
  while (std::getline(file, line)) {
    Row row;
    for (std::istringstream fields(line); std::getline(fields, field, ',');)
      row.push_back(std::strtod(field.c_str(), nullptr));
    row.pop_back();
    row.erase(row.begin());
    table.rows.push_back(row);
  }
  table.names.pop_back();
  table.names.erase(table.names.begin());
  require(table.rows.size() > 10, "rows of " + path);
  return table;
}

struct Case {
  const Library& library;
  const Description& description;
  const Table& table;
  std::vector<unsigned> columns;  ///< references of the table's columns
  std::string set = {};           ///< parameter to set before the initialisation, "" for none
  double value = 0;
};

/// Whether the last message has this part.
inline bool says(const std::string& part) { return last_message.find(part) != std::string::npos; }

inline bool same_bits(const Row& a, const Row& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

template <class Unit>
Row values(Unit& unit, const std::vector<unsigned>& references) {
  Row result;
  require(unit.get(references, result) == kOk, "get");
  return result;
}

template <class Unit>
void start(Unit& unit) {
  require(unit.setup(0, 0) == kOk, "setup");
  require(unit.leave() == kOk, "end of the initialisation");
}
