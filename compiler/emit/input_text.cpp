#include "compiler/emit/input_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/emit/text.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// Taylor polynomial of an input by Horner's rule: `inputs.a + dt * (inputs.b + dt / 2.0 * inputs.c)`.
std::string polynomial(const Model& model, const SolverNames& names, int input, int order, const std::string& scalar) {
  const std::string value = "inputs." + names.inputs[input];
  const int rate = model.inputs[input].derivative;
  if (rate < 0) return value;
  const std::string factor = order == 1 ? "dt" : "dt / " + number_text(order, scalar);
  const std::string rest = polynomial(model, names, rate, order + 1, scalar);
  const bool is_last = model.inputs[rate].derivative < 0;
  return fmt::format("{} + {} * {}", value, factor, is_last ? rest : fmt::format("({})", rest));
}

}  // namespace

std::vector<std::vector<int>> input_rows(const std::vector<Input>& inputs) {
  std::vector<int> users(inputs.size(), 0);
  for (const Input& input : inputs) {
    if (input.derivative >= 0) ++users[static_cast<std::size_t>(input.derivative)];
  }
  std::vector<std::vector<int>> rows;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (users[i] > 0 || inputs[i].derivative < 0) continue;
    std::vector<int> row;
    for (int next = static_cast<int>(i); next >= 0; next = inputs[static_cast<std::size_t>(next)].derivative) {
      row.push_back(next);
    }
    const auto is_shared = [&](int input) { return users[static_cast<std::size_t>(input)] > 1; };
    if (std::none_of(row.begin(), row.end(), is_shared)) rows.push_back(std::move(row));
  }
  return rows;
}

std::string input_polynomial(const Model& model, const SolverNames& names, int input, const std::string& scalar) {
  return polynomial(model, names, input, 1, scalar);
}

namespace {

std::string definition(const Model& model, const SolverNames& names, const std::string& scalar) {
  std::string text = "Inputs advance_inputs(const Inputs& inputs, " + scalar + " dt) noexcept {\n  Inputs later;\n";
  for (std::size_t i = 0; i < names.inputs.size(); ++i) {
    const std::string value = input_polynomial(model, names, static_cast<int>(i), scalar);
    text += wrapped_statement(fmt::format("  later.{} = {};", names.inputs[i], value)) + "\n";
  }
  return text + "  return later;\n}\n\n";
}

/// Declarations of kInputRows and InputPaths.
std::string rows_text(const Model& model, const SolverNames& names, const std::string& scalar) {
  std::vector<std::string> rows;
  for (const std::vector<int>& row : input_rows(model.inputs)) {
    std::vector<std::string> members;
    for (const int input : row) members.push_back("&Inputs::" + names.inputs[static_cast<std::size_t>(input)]);
    rows.push_back(fmt::format("    {{{}, {{{}}}}}", row.size(), fmt::join(members, ", ")));
  }
  if (rows.empty()) return "";
  return "\n/// Inputs with their derivatives.\ninline constexpr mbgen::InputRow<Inputs, " + scalar +
         "> kInputRows[] = {\n" + fmt::format("{}", fmt::join(rows, ",\n")) + "};\n\n" +
         wrapped_words(
             "Makes the rates of inputs whose caller gives values only, see mbgen/input_paths.hpp. Start with "
             "`InputPaths paths{};`, give every step `paths.of_step(inputs, h)`.",
             "/// ") +
         "\nusing InputPaths = mbgen::InputPaths<Inputs, kInputRows>;\n";
}

}  // namespace

InputText input_text(const Model& model, const SolverNames& names, const std::string& scalar) {
  if (!inputs_have_derivatives(model.inputs)) {
    return {.comment = "/// Inputs with their defaults. They are constant during a step.",
            .declaration = "",
            .definition = "",
            .member = "",
            .now = "",
            .start = "",
            .dynamics_comment = wrapped_words("The solver at constant parameters and inputs as an integrator sees it: "
                                              "without joint forces from outside.",
                                              "/// "),
            .name = "inputs"};
  }
  const std::string rows = rows_text(model, names, scalar);
  const std::string new_values =
      rows.empty() ? "new values and rates" : "new values and rates, or values to InputPaths";
  return {.comment = wrapped_words("Inputs with their defaults, as they are at the start of a step. During the step "
                                   "those with a derivative among the inputs go on as advance_inputs says, the others "
                                   "are constant; after it give " +
                                       new_values +
                                       ". A rate left at zero says that its input stands still: an input that moves "
                                       "all the same jumps, and no body feels the acceleration.",
                                   "/// "),
          .declaration =
              "\n/// Inputs dt seconds later: value + rate dt + acceleration dt^2/2, as far as they have "
              "derivatives.\nInputs advance_inputs(const Inputs& inputs, " +
              scalar + " dt) noexcept;\n",
          .definition = definition(model, names, scalar),
          .member = "  double start;  ///< s, time of the inputs\n",
          .now = "  const Inputs now = advance_inputs(inputs, " +
                 std::string(scalar == "float" ? "static_cast<float>(state.t - start)" : "state.t - start") + ");\n",
          .start = ", state.t",
          .dynamics_comment = wrapped_words("The solver at constant parameters and advancing inputs as an integrator "
                                            "sees it: without joint forces from outside.",
                                            "/// "),
          .name = "now",
          .include = rows.empty() ? "" : "#include \"mbgen/input_paths.hpp\"\n",
          .rows = rows};
}

}  // namespace mbgen
