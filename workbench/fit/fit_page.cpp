// The result of a fit as a page.

#include <fmt/format.h>

#include <cmath>

#include "compiler/text/characters.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/fit/fit.hpp"

namespace mbgen::fit {
namespace {

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>"
    "body{{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}}"
    "pre{{overflow-x:auto;background:#f6f6f6;padding:1em}}table{{border-collapse:collapse}}"
    "th,td{{padding:.15em .6em;border-bottom:1px solid #e2e2e2;text-align:right;font-variant-numeric:tabular-nums}}"
    "svg{{max-width:100%;height:auto}}</style></head>\n<body>\n<h1>{0}</h1>\n"
    "<p>By mbgen fit. Meaning of all numbers: docs/use/fit.md of mbgen.</p>\n";

/// Data and model above each other, and the errors in standard deviations.
std::string picture_of(const ChannelFit& channel) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < channel.data.size(); ++k)
    errors.push_back((channel.model[k] - channel.data[k]) / channel.sigma);
  const Panel both{channel.unit,
                   {{"data", channel.at, channel.data, Curve::Style::points},
                    {"model", channel.at, channel.model, Curve::Style::line}}};
  const Panel of_errors{"", {{"(model - data) / sigma", channel.at, errors, Curve::Style::points}}};
  const Abscissa abscissa = channel.is_of_rig ? Abscissa{"imposed", ""} : Abscissa{};
  return plot_svg(abscissa, {both, of_errors}, {960, 170});
}

std::string correlation_table(const FitResult& result) {
  std::string text = "<h2>Correlations</h2>\n<table>\n<tr><th></th>";
  for (const Unknown& unknown : result.unknowns) text += fmt::format("<th>{}</th>", xml_text(unknown.name));
  text += "</tr>\n";
  for (std::size_t u = 0; u < result.unknowns.size(); ++u) {
    text += fmt::format("<tr><th>{}</th>", xml_text(result.unknowns[u].name));
    for (std::size_t v = 0; v < result.unknowns.size(); ++v) {
      const double value = result.certainty.correlation(static_cast<Eigen::Index>(u), static_cast<Eigen::Index>(v));
      text += std::isfinite(value) ? fmt::format("<td>{:.4f}</td>", value) : "<td>-</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

/// A text of several lines, escaped.
std::string xml_lines(const std::string& text) {
  std::string escaped;
  for (const std::string& line : split_at(text, '\n')) escaped += xml_text(line) + "\n";
  return escaped;
}

}  // namespace

std::string fit_page(const FitResult& result) {
  std::string text = fmt::format(fmt::runtime(kHead), xml_text("Fit of " + result.model));
  text += fmt::format("<pre>{}</pre>\n", xml_lines(fit_text(result)));
  text += correlation_table(result);
  for (const ChannelFit& channel : result.channels)
    text += fmt::format("<h2>{}, {}{}</h2>\n{}", xml_text(channel.channel), xml_text(channel.file),
                        channel.is_held_out ? ", held out" : "", picture_of(channel));
  return text + "</body></html>\n";
}

}  // namespace mbgen::fit
