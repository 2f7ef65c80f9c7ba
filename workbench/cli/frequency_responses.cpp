#include "workbench/cli/frequency_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/results/results.hpp"

namespace mbgen::cli {
namespace {

constexpr int kMostFrequencies = 100000;

template <class Item>
int index_of(const std::vector<Item>& items, const std::string& name, const char* kind, const Model& model) {
  std::vector<std::string> known;
  for (const Item& item : items) known.push_back(item.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<int>(found - known.begin());
  const std::string hint = nearest_hint(name, known);
  throw UserError(fmt::format("--bode: {} has no {} \"{}\"\n{}", model.name, kind, name, hint));
}

std::vector<double> frequencies_of(const std::string& typed) {
  std::vector<double> numbers;
  for (const std::string& part : split_at(typed, ':')) numbers.push_back(parse_number(part, "--frequencies"));
  if (numbers.size() == 2) numbers.push_back(200);
  const bool is_range = numbers.size() == 3 && numbers[0] > 0 && numbers[1] > numbers[0] && numbers[2] >= 2 &&
                        numbers[2] <= kMostFrequencies && numbers[2] == std::floor(numbers[2]);
  if (!is_range)
    throw UserError(
        fmt::format("--frequencies: \"{}\" is no range of frequencies in Hz\n  hint: FIRST:LAST:COUNT, for example "
                    "0.1:20:200, up to {} of them\n",
                    typed, kMostFrequencies));
  const double first = numbers[0], last = numbers[1], most = numbers[2] - 1;
  std::vector<double> frequencies;
  for (double i = 0; i <= most; ++i) frequencies.push_back(first * std::pow(last / first, i / most));
  frequencies.back() = last;
  return frequencies;
}

/// Unit of output over input.
std::string unit_over(const std::string& output, const std::string& input) {
  const auto of = [](const std::string& unit) {
    return unit.find_first_of("/ *") == std::string::npos ? unit : "(" + unit + ")";
  };
  if (input.empty() || input == "1") return output.empty() ? "1" : output;
  return (output.empty() ? "1" : of(output)) + "/" + of(input);
}

}  // namespace

FrequencyResponses frequency_responses(const BodeArguments& arguments, const Model& model, const LinearSystem& system) {
  FrequencyResponses result;
  result.frequencies = frequencies_of(arguments.frequencies.empty() ? "0.1:20:200" : arguments.frequencies);
  for (const std::string& pair : arguments.pairs) {
    const std::size_t colon = pair.find(':');
    if (colon == std::string::npos) throw UserError(fmt::format("--bode: \"{}\" is no INPUT:OUTPUT\n", pair));
    FrequencyResponse response{pair.substr(0, colon), pair.substr(colon + 1), "", {}};
    const auto is_it = [&](const FrequencyResponse& one) {
      return one.input == response.input && one.output == response.output;
    };
    if (std::ranges::any_of(result.all, is_it)) throw UserError(fmt::format("--bode: \"{}\" stands twice\n", pair));
    const int input = index_of(model.inputs, response.input, "input", model);
    const int output = index_of(model.outputs, response.output, "output", model);
    response.unit = unit_over(model.outputs[static_cast<std::size_t>(output)].unit,
                              model.inputs[static_cast<std::size_t>(input)].unit);
    response.values = frequency_response(model, system, input, output, result.frequencies);
    result.all.push_back(std::move(response));
  }
  return result;
}

std::vector<double> magnitudes(const FrequencyResponse& response) {
  std::vector<double> result;
  for (const std::complex<double>& value : response.values) result.push_back(std::abs(value));
  return result;
}

std::vector<double> phases(const FrequencyResponse& response) {
  constexpr double kTurn = 360;
  std::optional<double> last;
  std::vector<double> result;
  for (const std::complex<double>& value : response.values) {
    const double phase = std::arg(value) * 180 / std::numbers::pi;
    if (!std::isfinite(std::abs(value))) {  // an undamped mode turns the phase by half a turn
      result.push_back(std::nan(""));
      continue;
    }
    result.push_back(last ? *last + std::remainder(phase - *last, kTurn) : phase);
    last = result.back();
  }
  return result;
}

std::string responses_text(const FrequencyResponses& responses) {
  std::string text = "\n  frequency response\n";
  for (const FrequencyResponse& response : responses.all) {
    const std::vector<double> size = magnitudes(response), phase = phases(response);
    const auto peak = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const auto low = std::find_if(size.begin(), size.end(), [&](double s) { return s < size[0] / std::sqrt(2.0); });
    text += fmt::format("  {} over {} [{}]\n", response.output, response.input, response.unit);
    text += fmt::format("    {:.6g} at {:.4g} Hz with {:.4g} deg\n", size[0], responses.frequencies[0], phase[0]);
    text += fmt::format("    largest {:.6g} at {:.4g} Hz\n", size[peak], responses.frequencies[peak]);
    if (low != size.end())
      text += fmt::format("    below 1/sqrt(2) of the first from {:.4g} Hz on\n",
                          responses.frequencies[static_cast<std::size_t>(low - size.begin())]);
  }
  return text;
}

nlohmann::ordered_json responses_json(const FrequencyResponses& responses) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FrequencyResponse& response : responses.all) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const std::complex<double>& value : response.values) values.push_back({value.real(), value.imag()});
    list.push_back({{"input", response.input},
                    {"output", response.output},
                    {"unit", response.unit},
                    {"frequency", responses.frequencies},
                    {"response", std::move(values)}});
  }
  return list;
}

std::string responses_csv(const FrequencyResponses& responses) {
  std::string text = "frequency [Hz]";
  std::vector<std::vector<double>> columns;
  for (const FrequencyResponse& response : responses.all) {
    const std::string name = response.output + "/" + response.input;
    text += "," + csv_field(heading_text({name, response.unit})) + "," + csv_field(name + " phase [deg]");
    columns.push_back(magnitudes(response));
    columns.push_back(phases(response));
  }
  text += "\n";
  for (std::size_t i = 0; i < responses.frequencies.size(); ++i) {
    text += fmt::format("{}", responses.frequencies[i]);
    for (const std::vector<double>& column : columns) text += fmt::format(",{}", column[i]);
    text += "\n";
  }
  return text;
}

std::vector<PageDiagram> responses_diagrams(const FrequencyResponses& responses) {
  const Heading frequency{"frequency", "Hz"};
  std::vector<PageDiagram> diagrams;
  PageDiagram phase{"Phase", frequency, {"phase", "deg"}, "x", {}};
  for (const FrequencyResponse& response : responses.all) {
    const std::string label = response.output + "/" + response.input;
    const auto same = [&](const PageDiagram& diagram) { return diagram.y.unit == response.unit; };
    auto diagram = std::find_if(diagrams.begin(), diagrams.end(), same);
    if (diagram == diagrams.end())
      diagram = diagrams.insert(diagrams.end(), {"Magnitude", frequency, {"magnitude", response.unit}, "xy", {}});
    diagram->curves.push_back({label, responses.frequencies, magnitudes(response)});
    phase.curves.push_back({label, responses.frequencies, phases(response)});
  }
  // One response is named by the title; several by their legend.
  for (PageDiagram& diagram : diagrams)
    if (diagram.curves.size() == 1) diagram.title += " of " + diagram.curves.front().name;
  if (phase.curves.size() == 1) phase.title += " of " + phase.curves.front().name;
  if (!phase.curves.empty()) diagrams.push_back(std::move(phase));
  return diagrams;
}

std::string responses_svg(const FrequencyResponses& responses) {
  std::vector<Panel> panels;
  Panel phase{"deg", {}, true};
  for (const FrequencyResponse& response : responses.all) {
    const std::string label = response.output + "/" + response.input;
    const auto same = [&](const Panel& panel) { return panel.unit == response.unit; };
    auto panel = std::find_if(panels.begin(), panels.end(), same);
    if (panel == panels.end()) panel = panels.insert(panels.end(), {response.unit, {}});
    panel->curves.push_back({label, responses.frequencies, magnitudes(response)});
    phase.curves.push_back({label, responses.frequencies, phases(response)});
  }
  panels.push_back(std::move(phase));
  return plot_svg({"frequency", "Hz", true}, panels);
}

}  // namespace mbgen::cli
