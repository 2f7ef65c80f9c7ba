// Entries of a .tir file that the model does not use.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/tir_file.hpp"

namespace mbgen::reading {
namespace {

/// Coefficients of the format without a formula here: a name, or its begin before a number.
struct TirGroup {
  std::string_view purpose;
  std::array<std::string_view, 12> names, numbered;
};

constexpr TirGroup kGroups[] = {
    {"turn slip", {"LMP"}, {"PECP", "PDXP", "PKYP", "PDYP", "PHYP", "QDTP", "QBRP", "QCRP", "QDRP"}},
    {"inflation pressure", {"LIP"}, {"PPX", "PPY", "PPZ", "PPMX", "QPZ", "PFZ"}},
    {"rolling resistance beyond QSY1", {}, {"QSY"}},
    {"overturning moment beyond QSX3", {}, {"QSX"}},
    {"relaxation of other tyre models", {"LSGKP", "LSGAL"}, {"PTX", "PTY", "PCFX", "PCFY"}},
    {"gyroscopic moment", {"MBELT", "LGYR"}, {"QTZ"}},
    {"friction over slip speed", {"LMUV"}, {}},
    {"belt and carcass",
     {"YAW_STIFFNESS", "FREQ_LONG", "FREQ_LAT", "FREQ_YAW", "FREQ_WINDUP", "DAMP_LONG", "DAMP_LAT", "DAMP_YAW",
      "DAMP_WINDUP"},
     {"Q_BVX", "Q_BVT", "PCMZ", "ECMZ", "DAMP_RESIDUAL", "DAMP_VLOW"}},
    {"radius and stiffness over load and speed",
     {"BREFF", "DREFF", "FREFF", "QFCX", "QFCY", "QFCG", "Q_FCX", "Q_FCY", "BOTTOM_OFFST", "BOTTOM_STIFF"},
     {"QV", "QFZ", "QFCX", "QFCY", "QFCG", "Q_V", "Q_FZ", "Q_RE", "Q_CAM", "Q_FYS"}},
    {"contact patch",
     {"PAE", "PBE", "PCE", "PLS", "ELLIPS_SHIFT", "ELLIPS_LENGTH", "ELLIPS_HEIGHT", "ELLIPS_ORDER", "ELLIPS_MAX_STEP",
      "ELLIPS_NWIDTH", "ELLIPS_NLENGTH"},
     {"PA", "PB", "PW", "Q_RA", "Q_RB", "Q_A"}},
};
constexpr std::string_view kUnknownPurpose = "unknown names";

/// Common sections without effect on forces, and prefixes of limits of validity.
constexpr std::string_view kSilentSections[] = {"MDI_HEADER", "UNITS", "MODEL", "DIMENSION", "INERTIA"};
constexpr std::string_view kSilentEnding = "_RANGE";

/// Keys used in addition to the coefficients.
constexpr std::string_view kOthers[] = {
    "VERTICAL_STIFFNESS", "VERTICAL_DAMPING", "INFLPRES", "USE_MODE", "LCZ", "Q_FZ1"};

/// Pressures of measurement and limits, used with coefficients of inflation pressure.
constexpr std::string_view kSilentKeys[] = {"IP", "IP_NOM", "NOMPRES", "INFLPRES", "PRESMIN", "PRESMAX"};

template <class Words>
bool is_among(std::string_view word, const Words& words) {
  return !word.empty() && std::find(std::begin(words), std::end(words), word) != std::end(words);
}

std::string_view purpose_of(std::string_view key) {
  const std::size_t last = key.find_last_not_of("0123456789");
  const std::string_view start = key.substr(0, last == std::string_view::npos ? 0 : last + 1);
  for (const TirGroup& group : kGroups) {
    if (is_among(key, group.names) || (start != key && is_among(start, group.numbered))) return group.purpose;
  }
  return kUnknownPurpose;
}

/// Whether a coefficient has a neutral value: a factor of 1, or a term of 0.
bool is_neutral(std::string_view key, const TirEntry& entry) {
  return number_of(entry) == (key.starts_with('L') && key != "LMUV" ? 1.0 : 0.0);
}

bool is_silent(const std::string& key, const TirEntry& entry) {
  const std::string section = upper(entry.section);
  return entry.used || is_among(section, kSilentSections) || section.ends_with(kSilentEnding) ||
         is_among(key, kSilentKeys) || (purpose_of(key) != kUnknownPurpose && is_neutral(key, entry));
}

bool is_earlier(Place a, Place b) { return a.offset < b.offset; }

/// " turn slip (PECP1, PECP2);" for the keys of one purpose: all coefficients of the format, only a few others.
std::string list_of(std::string_view purpose, const std::vector<std::string_view>& keys) {
  constexpr std::size_t kMostUnknown = 12;
  if (keys.empty()) return {};
  const std::size_t named = purpose == kUnknownPurpose ? std::min(keys.size(), kMostUnknown) : keys.size();
  std::string names;
  for (std::size_t i = 0; i < named; ++i) {
    names += i ? ", " : "";
    names += is_valid_name(keys[i]) ? std::string(keys[i]) : in_quotes(keys[i]);
  }
  if (keys.size() > named) names += fmt::format(" and {} more", keys.size() - named);
  return fmt::format("{} ({}); ", purpose, names);
}

/// Names of the format near to the first unknown ones, each as `did you mean`.
std::string nearest_names(TyreModel model, const std::vector<std::string_view>& unknown) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string_view> known;
  for (const TyreField& field : tyre_fields(model)) known.push_back(field.name);
  for (const std::string_view name : kOthers) known.push_back(name);
  std::string hint;
  for (std::size_t i = 0; i < std::min(unknown.size(), kMost); ++i) {
    const std::string nearest = did_you_mean(unknown[i], known);
    if (!nearest.empty()) hint += fmt::format("{}{}: {}", hint.empty() ? "" : ", ", unknown[i], nearest);
  }
  return hint;
}

}  // namespace

void note_unused(Reader& reader, TyreModel model, const TirEntries& entries) {
  std::map<std::string_view, std::vector<std::string_view>> keys;
  std::vector<Place> places;
  for (const auto& [key, entry] : entries.keys) {
    if (is_silent(key, entry)) continue;
    keys[purpose_of(key)].push_back(key);
    places.push_back(entry.key);
  }
  std::vector<std::string_view> tables;
  for (const auto& [section, place] : entries.tables) {
    tables.push_back(section);
    places.push_back(place);
  }
  if (places.empty()) return;
  std::string lists;
  for (const TirGroup& group : kGroups) lists += list_of(group.purpose, keys[group.purpose]);
  lists += list_of(kUnknownPurpose, keys[kUnknownPurpose]) + list_of("tables", tables);
  lists.resize(lists.size() - 2);
  Where where = where_of(reader.documents, *std::min_element(places.begin(), places.end(), is_earlier));
  const auto is_of_file = [&](const Diagnostic& note) { return note.where.file == where.file; };
  Diagnostics& notes = reader.model.notes;
  if (std::any_of(notes.begin(), notes.end(), is_of_file)) return;  // several tyres may use the file
  notes.push_back(
      {std::move(where), "the model does not use " + lists, nearest_names(model, keys[kUnknownPurpose]), {}});
}

}  // namespace mbgen::reading
