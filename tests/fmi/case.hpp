#pragma once
// Input of the importer: an FMU, its description and the table of `mbgen simulate`.

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <set>

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

/// Whether the motion goes through the pole of a ball.
inline bool changes_charts(const Case& c) {
  return c.description.identifier == "tumbling" || c.description.identifier == "rod_ball";
}

/// Near the pole of a ball the angles of the model are made from others by whoever shows them: mbgen or the unit, whose
/// compilers round otherwise. All else has the same bits.
inline bool same_row(const Case& c, const Row& found, const Row& expected) {
  if (!changes_charts(c)) return same_bits(found, expected);
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(std::abs(found[k] - expected[k]) <= 1e-13 * (1 + std::abs(expected[k])))) return false;
  return true;
}

/// Outputs, then derivatives.
inline std::vector<Unknown> unknowns_of(const Description& description) {
  std::vector<Unknown> unknowns = description.outputs;
  unknowns.insert(unknowns.end(), description.derivatives.begin(), description.derivatives.end());
  return unknowns;
}

inline std::vector<unsigned> references_of(const std::vector<Unknown>& unknowns) {
  std::vector<unsigned> references;
  for (const Unknown& unknown : unknowns) references.push_back(unknown.reference);
  return references;
}

/// Knowns of directional derivatives.
struct Knowns {
  std::vector<unsigned> all;      ///< the states first
  std::set<unsigned> parameters;  ///< those of them that are tunable
};

/// FMI 2 knows parameters at the initialisation only.
inline Knowns knowns_of(const Description& description, bool with_parameters) {
  Knowns knowns{description.states(), {}};
  for (const Variable& variable : description.variables) {
    const bool is_tuned = with_parameters && variable.variability == "tunable";
    if (is_tuned) knowns.parameters.insert(variable.reference);
    if (is_tuned || variable.causality == "input") knowns.all.push_back(variable.reference);
  }
  return knowns;
}

/// Rows from now on.
template <class Unit>
std::vector<Row> run_on(const Case& c, Unit& unit, int first, int count) {
  std::vector<Row> rows;
  for (int i = first; i < first + count; ++i) {
    require(unit.step(i * c.description.step, c.description.step) == kOk, "step");
    rows.push_back(values(unit, c.columns));
  }
  return rows;
}
