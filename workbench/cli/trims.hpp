#pragma once
// Steady motions of a vehicle that `mbgen linearize --speed` asks for.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "workbench/manoeuvre/trim.hpp"

namespace mbgen::cli {

/// As typed: numbers, of the first two also ranges FIRST:LAST:COUNT.
struct TrimArguments {
  std::string speed;                 ///< m/s
  std::string lateral_acceleration;  ///< m/s^2
  std::optional<double> radius;      ///< m
  std::optional<double> grade;       ///< rise over run
  std::vector<std::string> files;    ///< to write, .csv or .svg

  bool is_asked() const { return !speed.empty(); }
};

struct TrimStudy {
  Compilation compilation;  ///< with the outputs of the vehicle's motion and inclined gravity
  std::vector<Trim> trims;
  std::string varied;  ///< speed or lateral_acceleration of a range, "" for a single motion
  std::string end;     ///< why a range is not complete, "" if it is

  bool is_range() const { return !varied.empty(); }
};

/// Fails: UserError for arguments that are no numbers or exclude each other, a model without vehicle, a vehicle without
/// this steady motion; a range needs its first one.
TrimStudy trim_study(const std::string& model, const std::vector<std::string>& set,
                     const std::vector<std::string>& inputs, const TrimArguments& arguments);

/// The motion and the gains of steering of a single motion; the table of a range, with angles in degrees.
std::string trims_text(const TrimStudy& study);
nlohmann::ordered_json trims_json(const TrimStudy& study);
/// Writes the files of the arguments. read: files that must not be overwritten.
void write_trims(const TrimArguments& arguments, const TrimStudy& study, const std::vector<std::string>& read);

}  // namespace mbgen::cli
