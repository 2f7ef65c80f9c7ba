#pragma once
// Frequency responses that `mbgen linearize --bode` asks for.

#include <complex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compiler/linearisation/frequency_response.hpp"
#include "workbench/report/report.hpp"

namespace mbgen::cli {

/// As typed.
struct BodeArguments {
  std::vector<std::string> pairs;  ///< IN:OUT
  std::string frequencies;         ///< FIRST:LAST[:COUNT], Hz; "" for 0.1:20:200
  std::vector<std::string> files;  ///< to write, .csv or .svg
};

/// The response of one output to one input.
struct FrequencyResponse {
  std::string input, output, unit;           ///< unit: of output over input
  std::vector<std::complex<double>> values;  ///< per frequency
};

struct FrequencyResponses {
  std::vector<double> frequencies;  ///< Hz, evenly spaced logarithms
  std::vector<FrequencyResponse> all;
};

/// Fails: UserError for a name that is no input or output (the nearest is named), or frequencies that do not rise from
/// above 0.
FrequencyResponses frequency_responses(const BodeArguments& arguments, const Model& model, const LinearSystem& system);

/// Magnitude, and phase in degrees without jumps, in (-180, 180] at the first frequency.
std::vector<double> magnitudes(const FrequencyResponse& response);
std::vector<double> phases(const FrequencyResponse& response);

/// A line for each: the values at the lowest frequency, the peak, and where the magnitude falls below 1/sqrt(2) of the
/// first one.
std::string responses_text(const FrequencyResponses& responses);
nlohmann::ordered_json responses_json(const FrequencyResponses& responses);
std::string responses_csv(const FrequencyResponses& responses);
/// For the page of modes: a diagram for the magnitudes of each unit, and one for all phases.
std::vector<PageDiagram> responses_diagrams(const FrequencyResponses& responses);
/// A panel for the magnitudes of each unit, and one for all phases.
std::string responses_svg(const FrequencyResponses& responses);

}  // namespace mbgen::cli
