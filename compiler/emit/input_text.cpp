#include "compiler/emit/input_text.hpp"

#include <fmt/format.h>

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
  return {.comment = wrapped_words("Inputs with their defaults, as they are at the start of a step. During the step "
                                   "those with a derivative among the inputs go on as advance_inputs says, the others "
                                   "are constant; after it give new values.",
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
          .name = "now"};
}

}  // namespace mbgen
