#pragma once
// The text part of an OpenCRG file. Source: ASAM OpenCRG 1.2.0, chapter "file format".

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/formats/crg_entries.hpp"

namespace mbgen {

/// The quantity of a column of data.
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
  std::size_t data = 0, lines = 0;                  ///< where the data begin: byte, and lines before it
  std::size_t definition = 1;                       ///< line of the block of columns
  std::string file;                                 ///< of $ROAD_CRG_FILE, which has the data; empty: this one has
  bool has_options = false, has_modifiers = false;  ///< their blocks are there
  std::vector<CrgProblem> notes;

  std::optional<double> value(const char* name) const { return entry_of(parameters, name); }
  double value(const char* name, double fallback) const { return value(name).value_or(fallback); }
  /// A modifier that scales; 1 without.
  double scale(const char* name) const { return entry_of(modifiers, name).value_or(1); }
  /// Of elevations: 0 stands for none.
  double scale_of_height(const char* name) const { return scale(name) == 0 ? 1 : scale(name); }
};

/// Reads up to the line of $$$$ that ends the text part, or to the end where the data are in another file.
std::optional<CrgProblem> read_header(std::string_view text, CrgHeader& header);

CrgProblem at_line(std::size_t line, std::string message, std::string hint = {});

/// A number as files have it.
struct CrgNumber {
  double value;
  bool is_odd;  ///< written as 2.0+e00, of which the C API reads the 2.0
};
/// Exponents are of C or Fortran. Result: none if it is not a number.
std::optional<CrgNumber> crg_number(std::string_view text);

/// That an odd number is read. name: "NAME = ", or nothing.
CrgProblem odd_number(std::size_t line, std::string_view name, std::string_view written, double value);

}  // namespace mbgen
