#include "workbench/kc/kc_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/characters.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/kc/kc_shown.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {
namespace {

using namespace kc;

/// Name of a column without its side.
std::string quantity_of(const std::string& name) {
  for (const std::string_view side : {"_left", "_right"}) {
    if (name.ends_with(side) && name != "roll_centre_to_left") return name.substr(0, name.size() - side.size());
  }
  return name.starts_with("ratio_") ? "ratio" : name;
}

/// The curve of an overlay beside a column of a table, in its colour; without points if the overlay has none. number:
/// of the overlay among its kind.
Curve curve_beside(const KcOverlay& overlay, const std::string& table, const Heading& heading, int number, int colour) {
  Curve curve{fmt::format("{}, {}", heading.name, overlay.label), {}, {}};
  curve.style = overlay.is_measured ? Curve::Style::points
                : number % 2 == 0   ? Curve::Style::dashed
                                    : Curve::Style::dotted;
  curve.colour = colour;
  for (const KcTable& of : overlay.tables) {
    if (of.name != table) continue;
    for (const Column& column : of.columns) {
      if (column.heading.name != heading.name || shown(column.heading.unit).unit != heading.unit) continue;
      curve.x = drawn(of.columns.front()).values;
      curve.y = drawn(column).values;
    }
  }
  return curve;
}

/// Adds the curves of overlays to a panel: those of the first two variants and of the first measured file in the
/// colours of the panel's own.
void add_overlays(const KcReport& report, const std::string& table, Panel& panel) {
  const std::vector<Curve> own = panel.curves;
  int variants = 0, measured = 0;
  for (const KcOverlay& overlay : report.overlays) {
    const int number = overlay.is_measured ? measured++ : variants++;
    const int further = static_cast<int>(own.size()) * (overlay.is_measured ? number : number / 2);
    for (std::size_t c = 0; c < own.size(); ++c) {
      Curve curve = curve_beside(overlay, table, {own[c].label, panel.unit}, number, static_cast<int>(c) + further);
      if (!curve.x.empty()) panel.curves.push_back(std::move(curve));
    }
  }
}

/// A panel for each quantity, both sides in one.
std::vector<Panel> panels_of(const KcReport& report, const KcTable& table) {
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
  for (Panel& panel : panels) add_overlays(report, table.name, panel);
  return panels;
}

std::string picture(const KcTable& table, const std::vector<Panel>& panels, const PlotSize& size) {
  const Heading over = drawn(table.columns.front()).heading;
  return plot_svg({over.name, over.unit}, panels, size);
}

/// The panels beside each other, each with its own axis.
std::string pictures(const KcReport& report, const KcTable& table) {
  std::string text;
  for (const Panel& panel : panels_of(report, table)) text += picture(table, {panel}, {470, 150});
  return text;
}

std::string figure_rows(const KcReport& report) {
  std::string text;
  for (const KcFigure& figure : report.figures) {
    const Shown as = shown(figure.unit);
    std::string values;
    for (const double value : figure.values) values += fmt::format("<td>{}</td>", shown_number(value * as.factor));
    if (figure.values.size() == 1) values = values.substr(0, 3) + " colspan=\"2\"" + values.substr(3);
    text += fmt::format("<tr><th>{}</th>{}<td>{}</td><td class=\"words\">{}</td></tr>\n", xml_text(figure.name), values,
                        xml_text(as.unit), xml_text(figure.meaning));
  }
  return text;
}

/// SI values with all their digits, a row for each quantity.
std::string matrix_csv(const KcMatrix& matrix) {
  std::string text = "row";
  for (const Heading& heading : matrix.columns) text += "," + csv_field(heading_text(heading));
  text += '\n';
  for (std::size_t r = 0; r < matrix.rows.size(); ++r) {
    text += csv_field(heading_text(matrix.rows[r]));
    for (const double value : matrix.values[r]) text += std::isfinite(value) ? fmt::format(",{}", value) : ",";
    text += '\n';
  }
  return text;
}

/// A block of a matrix as a table.
std::string block_rows(const KcMatrix& matrix, const MatrixBlock& block) {
  std::string text = "<table>\n<tr><th></th>";
  for (const std::size_t c : block.columns)
    text +=
        fmt::format("<td>{}, {}</td>", plain_name(matrix.columns[c]), matrix.columns[c].unit == "N" ? "kN" : "kN m");
  text += "</tr>\n";
  for (const std::size_t r : block.rows) {
    text += fmt::format("<tr><th>{}, {}</th>", plain_name(matrix.rows[r]), shown(matrix.rows[r].unit).unit);
    for (const std::size_t c : block.columns)
      text += fmt::format("<td>{}</td>", shown_number(matrix.values[r][c] * shown(kc::unit_of(matrix, r, c)).factor));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string matrix_parts(const KcReport& report) {
  std::string text;
  for (const KcMatrix& matrix : report.matrices) {
    text += fmt::format("<details><summary>{} (<a href=\"{}_compliance_{}.csv\">table</a>)</summary>\n", matrix.title,
                        report.axle, matrix.name);
    for (const MatrixBlock& block : blocks_of(matrix))
      text += fmt::format("<h3>{} wheel, loads {}</h3>\n{}", block.wheel, block.loads, block_rows(matrix, block));
    text += "</details>\n";
  }
  return text.empty() ? text : "<h2>Compliance</h2>\n" + text;
}

std::string overlay_rows(const KcReport& report, const KcOverlay& overlay) {
  std::string text;
  for (const KcDifference& one : differences_of(report, overlay)) {
    const Shown as = shown(one.unit);
    text += fmt::format("<tr><th>{}</th>", xml_text(one.name));
    for (const std::vector<double>* values : {&one.values, &one.differences}) {
      for (std::size_t i = 0; i < values->size(); ++i)
        text += fmt::format("<td{}>{}</td>", values->size() == 1 ? " colspan=\"2\"" : "",
                            shown_number((*values)[i] * as.factor));
    }
    if (overlay.is_measured) text += fmt::format("<td>{}</td>", shown_number(one.rms * as.factor));
    text += fmt::format("<td>{}</td></tr>\n", xml_text(as.unit));
  }
  return text;
}

std::string overlay_parts(const KcReport& report) {
  std::string text;
  for (const KcOverlay& overlay : report.overlays) {
    text += fmt::format("<h2>{}</h2>\n<p>At the start, and the difference{}.</p>\n", xml_text(overlay.label),
                        overlay.is_measured ? " there and, as root mean square, along the curve" : "");
    for (const std::string& note : overlay.notes) text += fmt::format("<p>Note: {}</p>\n", xml_text(note));
    text += fmt::format("<table>\n{}</table>\n", overlay_rows(report, overlay));
  }
  return text;
}

std::string page_head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title>\n<style>"
      "body{{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}}"
      "table{{border-collapse:collapse}}th{{text-align:left;font-weight:normal}}"
      "th,td{{padding:.15em .8em .15em 0;border-bottom:1px solid #e2e2e2}}"
      "td{{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}}td.words{{text-align:left;white-"
      "space:normal;color:#666}}h3{{font-size:1em}}"
      "svg{{max-width:49%;height:auto}}</style></head>\n<body>\n<h1>{}</h1>\n<p>Kinematics and compliance, by mbgen. "
      "Definitions: docs/use/kc.md of mbgen.</p>\n",
      title, title);
}

std::string page(const KcReport& report) {
  std::string text = page_head(xml_text(fmt::format("{}: axle {}", report.model, report.axle)));
  for (const std::string& note : report.notes) text += fmt::format("<p>Note: {}</p>\n", xml_text(note));
  text += fmt::format("<h2>At the start</h2>\n<table>\n{}</table>\n", figure_rows(report));
  text += overlay_parts(report);
  for (const KcTable& table : report.tables) {
    text += fmt::format("<h2>{}</h2>\n<p><a href=\"{}_{}.csv\">table</a></p>\n{}", xml_text(table.title), report.axle,
                        table.name, pictures(report, table));
  }
  return text + matrix_parts(report) + "</body></html>\n";
}

/// Names of the figures of all reports, each once.
std::vector<const KcFigure*> all_figures(const std::vector<KcReport>& reports) {
  std::vector<const KcFigure*> list;
  for (const KcReport& report : reports)
    for (const KcFigure& figure : report.figures)
      if (std::none_of(list.begin(), list.end(), [&](const KcFigure* known) { return known->name == figure.name; }))
        list.push_back(&figure);
  return list;
}

/// Values of a figure as cells of two columns, empty if the report does not have it.
std::string cells_of(const KcReport& report, const KcFigure& figure) {
  for (const KcFigure& own : report.figures) {
    if (own.name != figure.name) continue;
    std::string cells;
    for (const double value : own.values)
      cells += fmt::format("<td{}>{}</td>", own.values.size() == 1 ? " colspan=\"2\"" : "",
                           shown_number(value * shown(own.unit).factor));
    return cells;
  }
  return "<td colspan=\"2\"></td>";
}

/// The figures of all axles beside each other, with links to their pages.
std::string overview(const std::vector<KcReport>& reports) {
  std::string text = page_head(xml_text(reports.front().model + ": axles")) + "<table>\n<tr><th></th>";
  for (const KcReport& report : reports)
    text +=
        fmt::format("<td colspan=\"2\"><a href=\"{}.html\">{}</a></td>", xml_text(report.axle), xml_text(report.axle));
  text += "</tr>\n";
  for (const KcFigure* figure : all_figures(reports)) {
    text += fmt::format("<tr><th>{}</th>", xml_text(figure->name));
    for (const KcReport& report : reports) text += cells_of(report, *figure);
    text += fmt::format("<td>{}</td><td class=\"words\">{}</td></tr>\n", xml_text(shown(figure->unit).unit),
                        xml_text(figure->meaning));
  }
  text += "</table>\n";
  for (const KcReport& report : reports)
    for (const std::string& note : report.notes)
      text += fmt::format("<p>Note: axle {}: {}</p>\n", xml_text(report.axle), xml_text(note));
  return text + "</body></html>\n";
}

}  // namespace

const KcTable* table_named(const KcReport& report, const std::string& name) {
  const auto found = std::ranges::find(report.tables, name, &KcTable::name);
  return found == report.tables.end() ? nullptr : &*found;
}

std::vector<NamedText> kc_files(const KcReport& report) {
  std::vector<NamedText> files;
  for (const KcTable& table : report.tables) {
    files.push_back({fmt::format("{}_{}.csv", report.axle, table.name), csv_text(table.columns)});
    files.push_back(
        {fmt::format("{}_{}.svg", report.axle, table.name), picture(table, panels_of(report, table), {760, 130})});
  }
  for (const KcMatrix& matrix : report.matrices)
    files.push_back({fmt::format("{}_compliance_{}.csv", report.axle, matrix.name), matrix_csv(matrix)});
  files.push_back({report.axle + ".html", page(report)});
  return files;
}

std::vector<NamedText> kc_files(const std::vector<KcReport>& reports) {
  std::vector<NamedText> files;
  for (const KcReport& report : reports)
    for (NamedText& file : kc_files(report)) files.push_back(std::move(file));
  if (reports.size() > 1) files.push_back({"index.html", overview(reports)});
  return files;
}

}  // namespace mbgen
