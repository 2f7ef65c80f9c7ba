#pragma once
// OpenCRG files: a grid of heights along a reference line. Source: ASAM OpenCRG 1.2.0, chapters "file format" and
// "evaluation".

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/formats/crg_entries.hpp"

namespace mbgen {

/// Ends of a reference line.
///   open     it goes straight on for ever
///   meeting  its end is its start: sections follow each other in a ring
///   apart    end and start go straight on until they meet, `before` and `behind` them
struct CrgClosure {
  enum class Kind { open, meeting, apart };
  Kind kind = Kind::open;
  double before = 0, behind = 0;  ///< m, >= 0
  double gap = 0;                 ///< m, between end and start, of a line that is asked to close
};

/// A road of an OpenCRG file. u: along the reference line, v: to the left of it, m. Sections are the rows of the file.
struct CrgRoad {
  double start = 0, increment = 1;               ///< m: u of the first section, and the distance of two
  std::vector<double> v;                         ///< m, of the columns of heights, increasing, at least two
  std::vector<double> heights;                   ///< m, section by section, right to left; no NaN
  std::vector<double> x, y, heading;             ///< of the reference line at each section: m, rad of the way to it
  double end_x = 0, end_y = 0, end_heading = 0;  ///< where the straight line behind the end begins
  std::vector<double> line_height;               ///< m, of the reference line at each section
  std::vector<double> banking;                   ///< 1, rise to the left at each section; empty: none
  CrgClosure closure;
  CrgEntries options, modifiers;  ///< what the file asks for
  std::vector<CrgProblem> notes;  ///< how it was read where it leaves something open

  std::size_t sections() const { return x.size(); }
  double end() const { return start + increment * static_cast<double>(sections() - 1); }
};

/// Reads a file: text (LRFI, LDFI) and binary (KRBI, KDBI) data; heights as single precision, as the C API keeps them.
/// Heights that are no number become what GRID_NAN_MODE says (2 without: the height to their right, else to their left;
/// 1: 0; 0 is a problem), plus GRID_NAN_OFFSET. Modifiers that scale are applied, others and the options are not.
/// Sections of binary data end where REFERENCE_LINE_END_U says, else with the last one that is not all NaN in the last
/// record. Notes: v from 0 where only an increment is given, numbers like 2.0+e00, an END_U beside the data.
/// Fails: with the first problem; binary data that END_U asks for and that are not there. Requires nothing of the text.
std::optional<CrgProblem> read_crg(std::string_view text, CrgRoad& road);

/// The same of files that name one another by $ROAD_CRG_FILE, the last one with the data: blocks of options and
/// modifiers of an earlier file count in place of those of a later one.
std::optional<CrgProblem> read_crg(std::span<const std::string_view> texts, CrgRoad& road);

/// The file that has the data of this one, relative to it; empty: this one has them.
std::string named_crg_file(std::string_view text);

}  // namespace mbgen
