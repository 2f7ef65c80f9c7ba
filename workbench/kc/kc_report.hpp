#pragma once
// Report of a rig on an axle: figures and curves, as text, tables, pictures and a page.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/host/files.hpp"
#include "workbench/kc/kc_data.hpp"

namespace mbgen {

/// The figures for people: angles in degrees, small lengths in mm. Then the differences of overlays.
std::string kc_text(const KcReport& report);

/// A compliance matrix for people, in blocks of a wheel and the wheels that are loaded. Fails: UserError if the report
/// has no matrix of this name.
std::string kc_matrix_text(const KcReport& report, const std::string& name);

/// The figures and tables for programs.
nlohmann::ordered_json kc_json(const KcReport& report);

/// A CSV table and an SVG picture for each curve, a CSV table for each compliance matrix, then the page AXLE.html with
/// all of them.
std::vector<NamedText> kc_files(const KcReport& report);

/// The files of all axles, and the page index.html with their figures beside each other if there are several.
std::vector<NamedText> kc_files(const std::vector<KcReport>& reports);

/// Points that were measured. table: its columns have the names of columns of the curve `curve`, the first of them
/// among them, in any order, in SI units, in those of pictures, or without units. Fails: Diagnostic with the known
/// names.
Result<KcOverlay> measured_overlay(const KcReport& report, const std::string& curve, const Results& table,
                                   const std::string& file);

/// The curve of a file of measured points, by its name: AXLE_CURVE.csv, CURVE.csv, or longer ones with these; "" for
/// none.
std::string curve_of_file(const KcReport& report, const std::string& file);

}  // namespace mbgen
