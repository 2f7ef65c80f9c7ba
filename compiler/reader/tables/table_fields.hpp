#pragma once
// Tables and maps as they are written.

#include "compiler/expressions/table.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

struct TableFields {
  std::vector<std::array<double, 2>> points;
  std::optional<std::string> csv;
  std::string x, y;  ///< columns of the CSV file
  Table::Interpolation interpolation = Table::Interpolation::linear;
  bool periodic = false;
};

/// Beyond the points of a table: straight on, or the value at the edge.
enum class Outside { straight, hold };
constexpr std::array<std::string_view, 2> kOutsides = {"straight", "hold"};

/// A table that expressions name.
struct NamedTableFields : TableFields {
  Outside outside = Outside::straight;
};

/// A map that expressions name.
struct MapFields {
  std::vector<double> x, y;
  std::vector<std::vector<double>> z;
  std::optional<std::string> csv;
  Table::Interpolation interpolation = Table::Interpolation::linear;
  Outside outside = Outside::straight;
};

template <>
std::span<const Field<TableFields>> fields<TableFields>();
template <>
std::span<const Field<NamedTableFields>> fields<NamedTableFields>();
template <>
std::span<const Field<MapFields>> fields<MapFields>();

}  // namespace mbgen::reading
