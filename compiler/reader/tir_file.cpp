#include "compiler/reader/tir_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/tables/csv_table.hpp"
#include "compiler/reader/tyre_notes.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"

namespace mbgen::reading {
namespace {

/// The line up to its comment; comment characters within quotes are text.
std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') quoted = !quoted;
    if (!quoted && (line[i] == '$' || line[i] == '!')) return line.substr(0, i);
  }
  return line;
}

/// Adds the value of a line. Reports a duplicate.
void add_entry(Reader& reader, TirEntries& entries, std::string_view line, TirEntry entry) {
  const std::size_t equals = line.find('=');
  const std::string key = upper(without_blanks(line.substr(0, equals)));
  entry.value = without_blanks(line.substr(equals + 1));
  if (entry.value.size() >= 2 && entry.value.front() == '\'' && entry.value.back() == '\'')
    entry.value = without_blanks(entry.value.substr(1, entry.value.size() - 2));
  const std::ptrdiff_t column = entry.value.empty() ? 0 : entry.value.data() - line.data();
  entry.place = {entry.key.file, entry.key.offset + static_cast<std::uint32_t>(column)};
  const auto [first, is_new] = entries.keys.emplace(key, entry);
  if (is_new) return;
  report(reader, entry.place,
         fmt::format("key {} is given twice, first at {}", key,
                     place_text(reader.documents, first->second.place, entry.place)));
}

/// The entry of a key, marked as used, or nullptr.
const TirEntry* use_entry(TirEntries& entries, std::string_view key) {
  const auto found = entries.keys.find(key);
  if (found == entries.keys.end()) return nullptr;
  found->second.used = true;
  return &found->second;
}

/// All entries of a file; for tables, with rows without a key, the section.
TirEntries entries_of(Reader& reader, const Document& document, std::uint32_t file) {
  TirEntries entries;
  const std::string_view text = document.text;
  std::string_view section;
  Place section_place;
  const auto place_of = [&](std::string_view part) {
    return Place{file, static_cast<std::uint32_t>(part.data() - text.data())};
  };
  for (std::size_t line = 0; line < document.line_starts.size(); ++line) {
    const std::size_t start = document.line_starts[line];
    const std::string_view content =
        without_blanks(without_comment(text.substr(start, std::min(text.find('\n', start), text.size()) - start)));
    if (content.empty() || content.front() == '{') continue;  // names of columns
    if (content.front() == '[') {
      section = without_blanks(content.substr(1, content.find(']') - 1));
      section_place = place_of(content);
      continue;
    }
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos) {
      const bool known = !entries.tables.empty() && entries.tables.back().first.data() == section.data();
      if (!known) entries.tables.emplace_back(section, section.empty() ? place_of(content) : section_place);
      continue;
    }
    add_entry(reader, entries, content, {.section = section, .key = place_of(content)});
  }
  return entries;
}

/// The number of a key; nothing if it is absent, or with a problem.
std::optional<double> number_of_key(Reader& reader, TirEntries& entries, std::string_view key) {
  const TirEntry* entry = use_entry(entries, key);
  if (!entry) return std::nullopt;
  const std::optional<double> number = number_of(*entry);
  if (number && std::abs(*number) <= kLargestNumber) return number;
  const std::string problem =
      number ? too_large(entry->value) : fmt::format("must be a number, got {}", in_quotes(entry->value));
  report(reader, entry->place, fmt::format("key {} {}", key, problem));
  return std::nullopt;
}

struct TirUnit {
  std::string_view quantity, word;
  double factor;  ///< to SI
};

constexpr TirUnit kTirUnits[] = {
    {"LENGTH", "METER", 1},
    {"LENGTH", "MM", 1e-3},
    {"LENGTH", "MILLIMETER", 1e-3},
    {"LENGTH", "CM", 1e-2},
    {"LENGTH", "CENTIMETER", 1e-2},
    {"LENGTH", "KM", 1e3},
    {"LENGTH", "INCH", 0.0254},
    {"LENGTH", "FOOT", 0.3048},
    {"FORCE", "NEWTON", 1},
    {"FORCE", "KILONEWTON", 1e3},
    {"FORCE", "KNEWTON", 1e3},
    {"FORCE", "POUND_FORCE", 4.4482216152605},
    {"FORCE", "KG_FORCE", 9.80665},
    {"TIME", "SECOND", 1},
    {"TIME", "SEC", 1},
    {"TIME", "MILLISECOND", 1e-3},
    {"ANGLE", "RADIAN", 1},
    {"ANGLE", "RADIANS", 1},
    {"ANGLE", "RAD", 1},
};

/// Factor of a quantity to SI; 1 without a unit. Reports unknown units.
double unit_of(Reader& reader, TirEntries& entries, std::string_view quantity) {
  const TirEntry* entry = use_entry(entries, quantity);
  if (!entry) return 1;
  std::string known;
  for (const TirUnit& unit : kTirUnits) {
    if (unit.quantity != quantity) continue;
    if (unit.word == upper(entry->value)) return unit.factor;
    known += (known.empty() ? "" : ", ") + std::string(unit.word);
  }
  report(reader, entry->place,
         fmt::format("unit of {} must be one of {}, got {}", quantity, known, in_quotes(entry->value)));
  return 1;
}

/// PROPERTY_FILE_FORMAT, and its tyre model, else the model from FITTYP.
struct TirFormat {
  std::string_view word;
  std::optional<TyreModel> model = {};
};

constexpr TirFormat kTirFormats[] = {{"PAC2002", TyreModel::pac2002},
                                     {"MF_05", TyreModel::pac2002},
                                     {"MF52", TyreModel::pac2002},
                                     {"MF61", TyreModel::mf61},
                                     {"MF62", TyreModel::mf61},
                                     {"MF-TYRE"},
                                     {"USER"}};

/// The tyre model of a file; nothing, with a problem, for an unsupported one.
std::optional<TyreModel> tyre_model_of(Reader& reader, const Value& value, TirEntries& entries) {
  constexpr std::string_view kHint =
      "the files understood are PAC2002 and Magic Formula 5.2 (FITTYP 6, 21 or 52), 6.1 and 6.2 (FITTYP 61 or 62)";
  const auto refuse = [&](Place place, const std::string& message) {
    report(reader, place, message, std::string(kHint));
    return std::nullopt;
  };
  const TirEntry *format = use_entry(entries, "PROPERTY_FILE_FORMAT"), *type = use_entry(entries, "FITTYP");
  if (!format && !type) {
    report(reader, value, "file names no tyre model, neither PROPERTY_FILE_FORMAT nor FITTYP", std::string(kHint));
    return std::nullopt;
  }
  const std::string word = !format ? "MF-TYRE" : upper(format->value);
  const auto named = std::ranges::find(kTirFormats, word, &TirFormat::word);
  if (named == std::end(kTirFormats))
    return refuse(format->place, "tyre model " + in_quotes(format->value) + " is not supported");
  if (!type) {
    if (named->model) return named->model;
    return refuse(format->place, "tyre model " + in_quotes(format->value) + " needs FITTYP, which tells its version");
  }
  const std::optional<double> number = number_of_key(reader, entries, "FITTYP");
  if (!number) return std::nullopt;
  const bool is_older = *number == 6 || *number == 21 || *number == 52;
  if (!is_older && *number != 61 && *number != 62)
    return refuse(type->place, fmt::format("tyre model FITTYP {} is not supported", *number));
  const TyreModel model = is_older ? TyreModel::pac2002 : TyreModel::mf61;
  if (named->model && named->model != model)
    note_once(reader, type->place,
              fmt::format("FITTYP {} is followed, PROPERTY_FILE_FORMAT {} says otherwise", *number,
                          in_quotes(format->value)));
  return model;
}

TirUnits units_of(Reader& reader, TirEntries& entries) {
  const TirUnits units{unit_of(reader, entries, "LENGTH"), unit_of(reader, entries, "FORCE"),
                       unit_of(reader, entries, "TIME")};
  unit_of(reader, entries, "ANGLE");
  return units;
}

double unit_of_coefficient(const TirUnits& units, std::string_view name) {
  if (name == "UNLOADED_RADIUS") return units.length;
  if (name == "FNOMIN") return units.force;
  if (name == "NOMPRES") return units.force / (units.length * units.length);
  if (name.ends_with("_STIFFNESS")) return units.force / units.length;
  return name == "LONGVL" ? units.length / units.time : 1;
}

void read_coefficients(Reader& reader, const Value& value, TirEntries& entries, const TirUnits& units, TirTyre& tyre) {
  for (const TyreField& row : tyre_fields(tyre.model)) {
    const std::string_view name = row.name;
    if (tyre.model == TyreModel::mf61 && is_of_turn_slip(name) && !tyre.turning.turn_slip) {
      tyre.coefficients.emplace_back(row.default_value);
      continue;
    }
    const std::optional<double> number = number_of_key(reader, entries, name);
    const TirEntry* entry = use_entry(entries, name);
    if (is_scale(tyre.model, name) && !entry) {
      report(reader, value, fmt::format("file has no {}", name));
    } else if ((is_scale(tyre.model, name) || name == "LONGVL") && number && *number <= 0) {
      report(reader, entry->place, fmt::format("key {} must be positive, got {}", name, *number));
    }
    const double unit = number ? unit_of_coefficient(units, name) : 1;
    tyre.coefficients.emplace_back(number.value_or(row.default_value) * unit);
  }
}

/// Whether turn slip is active: from the model, else from the last digit of USE_MODE, 5 in MF-Tyre: combined forces and
/// turn slip. A file without its coefficients gets a note.
TurningOfFile turning_of(Reader& reader, TirEntries& entries, const TirUnits& units, const RequestsOfTyre& requests) {
  constexpr double kCombinedAndTurnSlip = 5;
  TurningOfFile turning;
  const std::optional<double> mode = number_of_key(reader, entries, "USE_MODE");
  const bool asks = mode && std::fmod(std::abs(*mode), 10) == kCombinedAndTurnSlip;
  const auto is_there = [&](std::string_view name) {
    const auto entry = entries.keys.find(name);
    return entry != entries.keys.end() && number_of(entry->second).value_or(0) != 0;
  };
  const bool complete = std::ranges::all_of(kTurnSlipNeeds, is_there);
  if (asks && !requests.turn_slip && !complete)
    note(reader, entries.keys.find("USE_MODE")->second.place, "turn slip, for which USE_MODE asks, is not in the file",
         std::string(kTurnSlipNeedsText));
  turning.turn_slip = requests.turn_slip.value_or(asks && complete);
  if (turning.turn_slip) turning.yaw_stiffness = number_of_key(reader, entries, "YAW_STIFFNESS");
  if (turning.yaw_stiffness) *turning.yaw_stiffness *= units.force * units.length;
  return turning;
}

/// Stiffness and pressure of MF 6.1; missing ones are left to the tyre's own defaults.
template <class Number>
void read_mf61(const Number& number, const TirUnits& units, TirTyre& tyre) {
  const auto of = [&](std::string_view name) {
    return tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), name)].value;
  };
  const double per_length = units.force / units.length, scale = number("LCZ", 1);
  if (const double stiffness = number("VERTICAL_STIFFNESS", 0)) {
    tyre.stiffness = stiffness * per_length * scale;
  } else if (const double linear = number("Q_FZ1", 0)) {
    tyre.stiffness = of("FNOMIN") / of("UNLOADED_RADIUS") * std::sqrt(linear * linear + 4 * of("Q_FZ2")) * scale;
  }
  if (const double pressure = number("INFLPRES", 0)) tyre.pressure = pressure * per_length / units.length;
}

/// Cams of MF-Swift; their base is ELLIPS_SHIFT times the contact length at nominal load, from coefficients Q_RA1 and
/// Q_RA2. Source: I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka, Vehicle System Dynamics 48, 2010.
CamsOfFile cams_of(Reader& reader, TirEntries& entries, const TirTyre& tyre) {
  const auto number = [&](std::string_view key) {
    const std::optional<double> found = number_of_key(reader, entries, key);
    if (found && *found <= 0)
      report(reader, use_entry(entries, key)->place, fmt::format("key {} must be positive", key));
    return found;
  };
  CamsOfFile cams{{}, number("ELLIPS_LENGTH"), number("ELLIPS_HEIGHT"), number("ELLIPS_ORDER")};
  const std::optional<double> shift = number("ELLIPS_SHIFT");
  const std::optional<double> root = number_of_key(reader, entries, "Q_RA1");
  const std::optional<double> linear = number_of_key(reader, entries, "Q_RA2");
  if (!shift || !root || !linear || tyre.stiffness.value_or(0) <= 0) return cams;
  const double radius = tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), "UNLOADED_RADIUS")].value;
  const double load = tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), "FNOMIN")].value;
  const double deflection = load / (*tyre.stiffness * radius);
  if (const double half = *linear * deflection + *root * std::sqrt(deflection); half > 0) cams.base = *shift * 2 * half;
  return cams;
}

}  // namespace

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

std::optional<double> number_of(const TirEntry& entry) {
  std::string text(entry.value);
  for (char& c : text) c = c == 'd' || c == 'D' ? 'e' : c;  // exponents of Fortran
  const std::string_view digits = std::string_view(text).substr(text.starts_with('+') ? 1 : 0);
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<TirTyre> read_tir(Reader& reader, const Value& value, const RequestsOfTyre& requests) {
  const std::size_t problems = reader.problems.size();
  std::uint32_t file = 0;
  const Document* document = open_beside(reader, value, "tyre file", file);
  if (!document) return std::nullopt;
  TirEntries entries = entries_of(reader, *document, file);
  const std::optional<TyreModel> model = tyre_model_of(reader, value, entries);
  if (!model || reader.problems.size() > problems) return std::nullopt;
  const TirUnits units = units_of(reader, entries);
  TirTyre tyre{.model = *model};
  if (*model == TyreModel::mf61) tyre.turning = turning_of(reader, entries, units, requests);
  read_coefficients(reader, value, entries, units, tyre);
  const auto number = [&](std::string_view key, double absent) {
    return number_of_key(reader, entries, key).value_or(absent);
  };
  if (reader.problems.size() > problems) return std::nullopt;
  if (*model == TyreModel::mf61) {
    read_mf61(number, units, tyre);
  } else {
    if (const double stiffness = number("VERTICAL_STIFFNESS", 0))
      tyre.stiffness = stiffness * units.force / units.length;
    tyre.rolling_resistance = number_of_key(reader, entries, "QSY1");
  }
  tyre.damping = number_of_key(reader, entries, "VERTICAL_DAMPING");
  if (tyre.damping) *tyre.damping *= units.force * units.time / units.length;
  if (requests.cams) tyre.cams = cams_of(reader, entries, tyre);
  if (reader.problems.size() > problems) return std::nullopt;
  if (const TirEntry* nominal = use_entry(entries, "FNOMIN")) tyre.nominal = nominal->key;
  note_unused(reader, *model, entries);
  note_sizes(reader, entries, units, tyre);
  return tyre;
}

}  // namespace mbgen::reading
