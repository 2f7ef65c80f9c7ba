// A report of a rig as text and as JSON.

#include <fmt/format.h>

#include <cmath>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/kc/kc_report.hpp"
#include "workbench/kc/kc_shown.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;
using namespace kc;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json list_of_numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(finite_or_null(value));
  return list;
}

Json json_of_figures(const std::vector<KcFigure>& list) {
  Json figures = Json::object();
  for (const KcFigure& figure : list)
    figures[figure.name] = {
        {"unit", figure.unit}, {"values", list_of_numbers(figure.values)}, {"meaning", figure.meaning}};
  return figures;
}

Json json_of_tables(const std::vector<KcTable>& list) {
  Json tables = Json::object();
  for (const KcTable& table : list) {
    for (const Column& column : table.columns)
      tables[table.name][column.heading.name] = {{"unit", column.heading.unit},
                                                 {"values", list_of_numbers(column.values)}};
  }
  return tables;
}

Json json_of_headings(const std::vector<Heading>& headings) {
  Json list = Json::array();
  for (const Heading& heading : headings) list.push_back({{"name", heading.name}, {"unit", heading.unit}});
  return list;
}

Json json_of_matrices(const std::vector<KcMatrix>& list) {
  Json matrices = Json::object();
  for (const KcMatrix& matrix : list) {
    Json values = Json::array();
    for (const std::vector<double>& row : matrix.values) values.push_back(list_of_numbers(row));
    matrices[matrix.name] = {{"rows", json_of_headings(matrix.rows)},
                             {"columns", json_of_headings(matrix.columns)},
                             {"values", std::move(values)}};
  }
  return matrices;
}

Json json_of_overlays(const KcReport& report) {
  Json list = Json::array();
  for (const KcOverlay& overlay : report.overlays) {
    Json differences = Json::object();
    for (const KcDifference& one : differences_of(report, overlay)) {
      differences[one.name] = {{"unit", one.unit}, {"values", list_of_numbers(one.differences)}};
      if (overlay.is_measured) differences[one.name]["rms"] = finite_or_null(one.rms);
    }
    Json json = {{"label", overlay.label}, {"measured", overlay.is_measured}};
    if (!overlay.is_measured) json["figures"] = json_of_figures(overlay.figures);
    json["tables"] = json_of_tables(overlay.tables);
    json["differences"] = std::move(differences);
    json["notes"] = overlay.notes;
    list.push_back(std::move(json));
  }
  return list;
}

/// Values in their shown unit, each 12 letters wide.
std::string wide(const std::vector<double>& values, double factor) {
  std::string text;
  for (const double value : values) text += fmt::format("{:>12}", shown_number(value * factor));
  return text;
}

std::string difference_text(const KcReport& report, const KcOverlay& overlay) {
  std::string text = fmt::format("\n{}: at the start, and the difference{}\n", overlay.label,
                                 overlay.is_measured ? " there and, as root mean square, along the curve" : "");
  for (const KcDifference& one : differences_of(report, overlay)) {
    const Shown as = shown(one.unit);
    text += fmt::format("  {:<34}{}  {}", one.name, wide(one.values, as.factor), wide(one.differences, as.factor));
    if (overlay.is_measured) text += wide({one.rms}, as.factor);
    text += as.unit.empty() ? "\n" : fmt::format(" {}\n", as.unit);
  }
  for (const std::string& note : overlay.notes) text += fmt::format("note: {}\n", note);
  return text;
}

}  // namespace

std::string kc_text(const KcReport& report) {
  std::string text = fmt::format("{}: axle {}\n\nAt the start\n", report.model, report.axle);
  for (const KcFigure& figure : report.figures) {
    const Shown as = shown(figure.unit);
    text += fmt::format("  {:<34}{}", figure.name, wide(figure.values, as.factor));
    text += as.unit.empty() ? "\n" : fmt::format(" {}\n", as.unit);
  }
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  for (const KcOverlay& overlay : report.overlays) text += difference_text(report, overlay);
  return text;
}

std::string kc_matrix_text(const KcReport& report, const std::string& name) {
  const KcMatrix* matrix = nullptr;
  for (const KcMatrix& one : report.matrices)
    if (one.name == name) matrix = &one;
  if (matrix == nullptr) {
    throw UserError(
        fmt::format("--compliance {}: no spring carries the wheels of axle {}, which have no compliance "
                    "while they are free\n  hint: ask for {}_held\n",
                    name, report.axle, name));
  }
  std::string text = fmt::format("\nCompliance: {}\n", matrix->title);
  for (const MatrixBlock& block : blocks_of(*matrix)) {
    const bool is_one = block.loads == "left" || block.loads == "right";
    text += fmt::format("  {} wheel by loads {}{}{}\n", block.wheel, is_one ? "at the " : "at ",
                        is_one ? block.loads + " wheel" : "both wheels", block.loads == "opposite" ? ", opposite" : "");
    text += fmt::format("  {:<18}", "");
    for (const std::size_t c : block.columns)
      text += fmt::format("{:>14}", fmt::format("{} [{}]", plain_name(matrix->columns[c]),
                                                matrix->columns[c].unit == "N" ? "kN" : "kN m"));
    text += '\n';
    for (const std::size_t r : block.rows) {
      const std::string heading = fmt::format("{} [{}]", plain_name(matrix->rows[r]), shown(matrix->rows[r].unit).unit);
      text += fmt::format("    {:<16}", heading);
      for (const std::size_t c : block.columns)
        text += fmt::format("{:>14}", shown_number(matrix->values[r][c] * shown(kc::unit_of(*matrix, r, c)).factor));
      text += '\n';
    }
  }
  return text;
}

Json kc_json(const KcReport& report) {
  Json json = {{"model", report.model},
               {"axle", report.axle},
               {"figures", json_of_figures(report.figures)},
               {"tables", json_of_tables(report.tables)},
               {"compliance", json_of_matrices(report.matrices)},
               {"notes", report.notes}};
  if (!report.overlays.empty()) json["overlays"] = json_of_overlays(report);
  return json;
}

}  // namespace mbgen
