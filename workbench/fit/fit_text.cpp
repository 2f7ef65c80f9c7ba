// The result of a fit for people and programs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/text/json_text.hpp"
#include "workbench/fit/fit.hpp"
#include "workbench/search/found_model.hpp"
#include "workbench/search/result_text.hpp"

namespace mbgen::fit {
namespace {

/// A correlation from here on is told.
constexpr double kToldCorrelation = 0.9;
/// Errors below this part of their standard deviation are not told to be no noise.
constexpr double kFarBelowNoise = 0.3;
/// Excess of the sum of squares, in its standard deviations, that is told.
constexpr double kToldExcess = 5;
/// Residuals are told to be no noise where white noise has such correlations less often.
constexpr double kNoNoise = 0.01;

std::string remark_of(const FitResult& result, std::size_t u) {
  if (result.certainty.at_bound[u] != 0)
    return fmt::format("at its {} bound", result.certainty.at_bound[u] < 0 ? "lower" : "upper");
  return result.certainty.identified[u] ? "" : "not identified";
}

std::string unknown_rows(const FitResult& result) {
  std::vector<TableRow> rows{{"parameter", "value", "standard error", "start", "bounds", ""}};
  for (std::size_t u = 0; u < result.unknowns.size(); ++u) {
    const Unknown& unknown = result.unknowns[u];
    const double error = result.certainty.standard_errors[u];
    rows.push_back({fmt::format("{} [{}]", unknown.name, unknown.unit.empty() ? "1" : unknown.unit),
                    fmt::format("{:.7g}", result.values[u]), std::isfinite(error) ? fmt::format("{:.3g}", error) : "-",
                    fmt::format("{:.6g}", unknown.start),
                    unknown.is_physical ? "physical" : fmt::format("{:.4g} to {:.4g}", unknown.lower, unknown.upper),
                    remark_of(result, u)});
  }
  return aligned_rows(rows);
}

std::string correlation_lines(const FitResult& result) {
  std::string text;
  for (std::size_t u = 0; u < result.unknowns.size(); ++u)
    for (std::size_t v = 0; v < u; ++v) {
      const double value = result.certainty.correlation(static_cast<Eigen::Index>(u), static_cast<Eigen::Index>(v));
      if (std::abs(value) >= kToldCorrelation)
        text += fmt::format("  {} and {} are correlated by {:.4f}\n", result.unknowns[v].name, result.unknowns[u].name,
                            value);
    }
  return text;
}

std::string channel_rows(const FitResult& result) {
  std::vector<TableRow> rows{{"channel", "values", "error, rms", "sigma", "explained", "Durbin-Watson", "file"}};
  for (const ChannelFit& channel : result.channels)
    rows.push_back({fmt::format("{} [{}]", channel.channel, channel.unit.empty() ? "1" : channel.unit),
                    fmt::format("{}", channel.data.size()), fmt::format("{:.4g}", channel.rms),
                    fmt::format("{:.4g}{}", channel.sigma, channel.is_sigma_estimated ? " (estimated)" : ""),
                    channel.data.size() > 1 ? fmt::format("{:.2f} %", 100 * channel.explained) : "-",
                    channel.whiteness.lags > 0 ? fmt::format("{:.3f}", channel.whiteness.durbin_watson) : "-",
                    channel.file + (channel.is_held_out ? " (held out)" : "")});
  return aligned_rows(rows);
}

std::string doubt_lines(const FitResult& result) {
  std::string text;
  for (const Indifference& one : result.certainty.indifferences)
    text += fmt::format("  not identified: {}\n", one.words);
  for (const ChannelFit& channel : result.channels)
    if (!channel.is_held_out && channel.rms > kFarBelowNoise * channel.sigma &&
        channel.whiteness.probability < kNoNoise)
      text += fmt::format(
          "  {}: {}: the errors are no white noise (Ljung-Box, {} lags, p = {:.2g}): the model lacks something, or "
          "neighbours of the data depend on each other; standard errors are then too small\n",
          channel.file, channel.channel, channel.whiteness.lags, channel.whiteness.probability);
  const double freedoms = std::max(1.0, result.residuals - static_cast<double>(result.unknowns.size()));
  if (result.loss.empty() && result.squares > freedoms + kToldExcess * std::sqrt(2 * freedoms))
    text += fmt::format(
        "  errors are {:.3g} times as large as their standard deviations: these, or the model, are wrong, and standard "
        "errors of parameters are too small\n",
        std::sqrt(result.squares / freedoms));
  for (const std::string& warning : result.warnings) text += fmt::format("  warning: {}\n", warning);
  return text;
}

nlohmann::ordered_json matrix_json(const Eigen::MatrixXd& matrix) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    nlohmann::ordered_json row = nlohmann::ordered_json::array();
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) row.push_back(number_or_null(matrix(r, c)));
    rows.push_back(std::move(row));
  }
  return rows;
}

nlohmann::ordered_json unknowns_json(const FitResult& result) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const Certainty& certainty = result.certainty;
  for (std::size_t u = 0; u < result.unknowns.size(); ++u) {
    const Unknown& unknown = result.unknowns[u];
    list.push_back({{"name", unknown.name},
                    {"unit", unknown.unit},
                    {"value", result.values[u]},
                    {"standard_error", number_or_null(certainty.standard_errors[u])},
                    {"start", unknown.start},
                    {"lower", number_or_null(unknown.lower)},
                    {"upper", number_or_null(unknown.upper)},
                    {"at_bound", certainty.at_bound[u] < 0   ? "lower"
                                 : certainty.at_bound[u] > 0 ? "upper"
                                                             : ""},
                    {"identified", static_cast<bool>(certainty.identified[u])}});
  }
  return list;
}

}  // namespace

std::string fit_text(const FitResult& result) {
  const auto count = [](auto number, const char* word) {
    return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
  };
  const long freedoms = result.residuals - static_cast<long>(result.unknowns.size());
  std::string text =
      fmt::format("{}: {} from {}, engine {}, {}, derivatives: {}\n", result.model,
                  count(result.unknowns.size(), "unknown"), count(result.residuals, "value"), result.engine,
                  result.converged ? count(result.iterations, "iteration")
                                   : fmt::format("not at its end after {}", count(result.iterations, "iteration")),
                  result.derivatives);
  text += fmt::format("  weighted sum of squares {:.7g}, at the start {:.5g}", result.squares, result.squares_at_start);
  text += freedoms > 0 ? fmt::format("; {} if the standard deviations are right\n", freedoms) : "\n";
  if (!result.loss.empty()) text += fmt::format("  loss {}\n", result.loss);
  return text + unknown_rows(result) + correlation_lines(result) + channel_rows(result) + doubt_lines(result);
}

std::string fit_json(const FitResult& result) {
  using Json = nlohmann::ordered_json;
  Json channels = Json::array(), unseen = Json::array();
  for (const ChannelFit& channel : result.channels)
    channels.push_back({{"file", channel.file},
                        {"channel", channel.channel},
                        {"unit", channel.unit},
                        {"held_out", channel.is_held_out},
                        {"values", channel.data.size()},
                        {"rms", channel.rms},
                        {"sigma", channel.sigma},
                        {"sigma_estimated", channel.is_sigma_estimated},
                        {"explained", channel.explained},
                        {"durbin_watson", channel.whiteness.durbin_watson},
                        {"ljung_box_lags", channel.whiteness.lags},
                        {"ljung_box_p", channel.whiteness.probability}});
  for (const Indifference& one : result.certainty.indifferences) {
    Json parts = Json::object();
    for (std::size_t k = 0; k < one.unknowns.size(); ++k) parts[result.unknowns[one.unknowns[k]].name] = one.parts[k];
    unseen.push_back({{"words", one.words}, {"direction", parts}});
  }
  return json_text({{"model", result.model},
                    {"engine", result.engine},
                    {"derivatives", result.derivatives},
                    {"converged", result.converged},
                    {"iterations", result.iterations},
                    {"values", result.residuals},
                    {"sum_of_squares", result.squares},
                    {"sum_of_squares_at_start", result.squares_at_start},
                    {"unknowns", unknowns_json(result)},
                    {"covariance", matrix_json(result.certainty.covariance)},
                    {"correlation", matrix_json(result.certainty.correlation)},
                    {"scaled_eigenvalues", result.certainty.eigenvalues},
                    {"not_identified", unseen},
                    {"channels", channels},
                    {"warnings", result.warnings}});
}

std::string fitted_model(const FitResult& result, const std::string& path) {
  FoundModel found{result.model + "_fitted", "values found by mbgen fit", result.model_file, {}};
  for (const VariedParameter& parameter : result.set)
    if (parameter.name != kStepOfMotion) found.values.emplace_back(parameter.name, *parameter.value);
  for (std::size_t u = 0; u < result.unknowns.size(); ++u)
    if (result.unknowns[u].kind == Unknown::Kind::parameter)
      found.values.emplace_back(result.unknowns[u].name, result.values[u]);
  return text_of(found, path);
}

}  // namespace mbgen::fit
