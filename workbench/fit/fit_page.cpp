// The result of a fit as a page.

#include <fmt/format.h>

#include <cmath>

#include "compiler/text/characters.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/fit/fit.hpp"
#include "workbench/search/result_text.hpp"

namespace mbgen::fit {
namespace {

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

}  // namespace

std::string fit_page(const FitResult& result) {
  std::string text = page_head("Fit of " + result.model, "fit", fit_text(result));
  text += correlation_table(result);
  for (const ChannelFit& channel : result.channels)
    text += fmt::format("<h2>{}, {}{}</h2>\n{}", xml_text(channel.channel), xml_text(channel.file),
                        channel.is_held_out ? ", held out" : "", picture_of(channel));
  return text + kPageEnd;
}

}  // namespace mbgen::fit
