#pragma once
// Tyre property files of Adams and TNO (.tir).

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/reader/read_turning.hpp"

namespace mbgen::reading {

/// Data of a file for the cams of TyreEnvelope.
struct CamsOfFile {
  std::optional<double> base = {}, length = {}, height = {}, order = {};
};

/// The tyre of a .tir file, in SI units.
struct TirTyre {
  TyreModel model;                                ///< pac2002 or mf61
  std::vector<Quantity> coefficients = {};        ///< in the order of tyre_fields(model)
  std::optional<double> stiffness = {};           ///< N/m: VERTICAL_STIFFNESS; for mf61 else from Q_FZ1 and Q_FZ2
  std::optional<double> damping = {};             ///< N s/m: VERTICAL_DAMPING
  std::optional<double> rolling_resistance = {};  ///< QSY1 of pac2002
  std::optional<double> pressure = {};            ///< Pa: INFLPRES
  CamsOfFile cams = {};                           ///< ELLIPS_..., on request
  TurningOfFile turning = {};                     ///< of mf61
  Place nominal = {};                             ///< of FNOMIN
};

/// KEY = value of a section.
struct TirEntry {
  std::string_view value = {};    ///< without quotes and comment
  Place place = {};               ///< of the value
  std::string_view section = {};  ///< without brackets, as written
  Place key = {};
  bool used = false;  ///< its number or word was read
};

struct TirEntries {
  std::map<std::string, TirEntry, std::less<>> keys;       ///< in capitals
  std::vector<std::pair<std::string_view, Place>> tables;  ///< sections with rows without a key
};

/// Requests of a tyre to its file.
struct RequestsOfTyre {
  bool cams = false;                   ///< the tyre uses the cams of the file
  std::optional<bool> turn_slip = {};  ///< from the model; else from the file's USE_MODE
};

/// Reads a file of PAC2002 or Magic Formula 5.2, 6.1 or 6.2, relative to the file that names it. Sections, units,
/// comments ($ and
/// !) and texts in quotes are understood; entries without a part in the formulas of tyre.hpp are passed over, with a
/// note. Fails: nothing, with complaints at lines of the file: another tyre model, units that are unknown, a
/// coefficient that is no number or stands twice, no radius, nominal load or pressure. Coefficients of turn slip are
/// read where it acts.
std::optional<TirTyre> read_tir(Reader& reader, const Value& value, const RequestsOfTyre& requests);

/// Capital letters, for comparison of keys and sections.
std::string upper(std::string_view text);

/// The number of an entry, with an exponent of C or Fortran; nothing for text.
std::optional<double> number_of(const TirEntry& entry);

/// Notes unused entries in the model, once per file, sorted by purpose. Silent on common entries (header, units,
/// dimensions, limits of validity) and on coefficients with neutral values. Unknown names get the nearest one. model:
/// of the file.
void note_unused(Reader& reader, TyreModel model, const TirEntries& entries);

/// Factors to SI.
struct TirUnits {
  double length, force, time;
};

/// Notes sizes that are impossible for a tyre in the units of the file: numbers in millimetres declared as metres, or
/// the reverse. tyre: in SI.
void note_sizes(Reader& reader, const TirEntries& entries, const TirUnits& units, const TirTyre& tyre);

}  // namespace mbgen::reading
