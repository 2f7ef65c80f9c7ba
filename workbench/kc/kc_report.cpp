#include "workbench/kc/kc_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/text/characters.hpp"
#include "compiler/text/json_text.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/drawing/svg.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// A unit for people, and the factor to it.
struct Shown {
  std::string unit;
  double factor = 1;
};

/// Angles in degrees, lengths in mm, rates of springs in N/mm.
Shown shown(const std::string& unit) {
  constexpr double kDegrees = 57.295779513082320877, kMillimetres = 1e3;
  const struct {
    const char* si;
    Shown as;
  } table[] = {{"rad", {"deg", kDegrees}},
               {"m", {"mm", kMillimetres}},
               {"rad/m", {"deg/m", kDegrees}},
               {"N/m", {"N/mm", 1 / kMillimetres}},
               {"m/rad", {"mm/deg", kMillimetres / kDegrees}},
               {"N m/rad", {"N m/deg", 1 / kDegrees}},
               {"rad/N", {"deg/kN", kDegrees * 1e3}},
               {"m/N", {"mm/kN", kMillimetres * 1e3}},
               {"rad/(N m)", {"deg/(kN m)", kDegrees * 1e3}},
               {"1", {"", 1}}};
  for (const auto& row : table) {
    if (unit == row.si) return row.as;
  }
  return {unit, 1};
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.5g}", value == 0 ? 0 : value) : "-"; }

Column drawn(const Column& column) {
  const Shown as = shown(column.heading.unit);
  Column result{{column.heading.name, as.unit}, column.values};
  for (double& value : result.values) value *= as.factor;
  return result;
}

/// Name of a column without its side.
std::string quantity_of(const std::string& name) {
  for (const std::string_view side : {"_left", "_right"}) {
    if (name.ends_with(side) && name != "roll_centre_to_left") return name.substr(0, name.size() - side.size());
  }
  return name.starts_with("ratio_") ? "ratio" : name;
}

/// A panel for each quantity, both sides in one.
std::vector<Panel> panels_of(const KcTable& table) {
  const std::vector<double> over = drawn(table.columns.front()).values;
  std::vector<Panel> panels;
  std::string last;
  for (std::size_t c = 1; c < table.columns.size(); ++c) {
    const Column column = drawn(table.columns[c]);
    const std::string quantity = quantity_of(column.heading.name) + column.heading.unit;
    if (quantity != last) panels.push_back({column.heading.unit, {}});
    last = quantity;
    panels.back().curves.push_back({column.heading.name, over, column.values});
  }
  return panels;
}

std::string picture(const KcTable& table, const std::vector<Panel>& panels, const PlotSize& size) {
  const Heading over = drawn(table.columns.front()).heading;
  return plot_svg({over.name, over.unit}, panels, size);
}

/// The panels beside each other, each with its own axis.
std::string pictures(const KcTable& table) {
  std::string text;
  for (const Panel& panel : panels_of(table)) text += picture(table, {panel}, {470, 150});
  return text;
}

/// SI values with all their digits.
std::string csv(const KcTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    text += (c > 0 ? "," : "") + csv_field(heading_text(table.columns[c].heading));
  text += '\n';
  for (std::size_t row = 0; row < table.columns.front().values.size(); ++row) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const double value = table.columns[c].values[row];
      text += (c > 0 ? "," : "") + (std::isfinite(value) ? fmt::format("{}", value) : std::string());
    }
    text += '\n';
  }
  return text;
}

std::string figure_rows(const KcReport& report) {
  std::string text;
  for (const KcFigure& figure : report.figures) {
    const Shown as = shown(figure.unit);
    std::string values;
    for (const double value : figure.values) values += fmt::format("<td>{}</td>", number(value * as.factor));
    if (figure.values.size() == 1) values = values.substr(0, 3) + " colspan=\"2\"" + values.substr(3);
    text += fmt::format("<tr><th>{}</th>{}<td>{}</td><td class=\"words\">{}</td></tr>\n", xml_text(figure.name), values,
                        xml_text(as.unit), xml_text(figure.meaning));
  }
  return text;
}

std::string page(const KcReport& report) {
  const std::string title = xml_text(fmt::format("{}: axle {}", report.model, report.axle));
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title>\n<style>"
      "body{{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}}"
      "table{{border-collapse:collapse}}th{{text-align:left;font-weight:normal}}"
      "th,td{{padding:.15em .8em .15em 0;border-bottom:1px solid #e2e2e2}}"
      "td{{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}}td.words{{text-align:left;white-"
      "space:normal;color:#666}}"
      "svg{{max-width:49%;height:auto}}</style></head>\n<body>\n<h1>{}</h1>\n<p>Kinematics and compliance, by mbgen. "
      "Definitions: docs/use/kc.md of mbgen.</p>\n",
      title, title);
  for (const std::string& note : report.notes) text += fmt::format("<p>Note: {}</p>\n", xml_text(note));
  text += fmt::format("<h2>At the start</h2>\n<table>\n{}</table>\n", figure_rows(report));
  for (const KcTable& table : report.tables) {
    text += fmt::format("<h2>{}</h2>\n<p><a href=\"{}_{}.csv\">table</a></p>\n{}", xml_text(table.title), report.axle,
                        table.name, pictures(table));
  }
  return text + "</body></html>\n";
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(finite_or_null(value));
  return list;
}

}  // namespace

std::string kc_text(const KcReport& report) {
  std::string text = fmt::format("{}: axle {}\n\nAt the start\n", report.model, report.axle);
  for (const KcFigure& figure : report.figures) {
    const Shown as = shown(figure.unit);
    text += fmt::format("  {:<34}", figure.name);
    for (const double value : figure.values) text += fmt::format("{:>12}", number(value * as.factor));
    text += as.unit.empty() ? "\n" : fmt::format(" {}\n", as.unit);
  }
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  return text;
}

Json kc_json(const KcReport& report) {
  Json figures = Json::object(), tables = Json::object();
  for (const KcFigure& figure : report.figures)
    figures[figure.name] = {{"unit", figure.unit}, {"values", numbers(figure.values)}, {"meaning", figure.meaning}};
  for (const KcTable& table : report.tables) {
    for (const Column& column : table.columns)
      tables[table.name][column.heading.name] = {{"unit", column.heading.unit}, {"values", numbers(column.values)}};
  }
  return {{"model", report.model},
          {"axle", report.axle},
          {"figures", figures},
          {"tables", tables},
          {"notes", report.notes}};
}

std::vector<NamedText> kc_files(const KcReport& report) {
  std::vector<NamedText> files;
  for (const KcTable& table : report.tables) {
    files.push_back({fmt::format("{}_{}.csv", report.axle, table.name), csv(table)});
    files.push_back({fmt::format("{}_{}.svg", report.axle, table.name), picture(table, panels_of(table), {760, 130})});
  }
  files.push_back({report.axle + ".html", page(report)});
  return files;
}

}  // namespace mbgen
