#include "compiler/emit/input_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/mapped.hpp"
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

FrameRows later_inputs(const Model& model, const SolverNames& names, const std::string& scalar) {
  FrameRows rows;
  for (std::size_t i = 0; i < names.inputs.size(); ++i) {
    rows.push_back({{"member", names.inputs[i]}, {"value", polynomial(model, names, static_cast<int>(i), 1, scalar)}});
  }
  return rows;
}

std::string input_rows_text(const Model& model, const SolverNames& names) {
  std::vector<std::string> rows;
  for (const std::vector<int>& row : input_rows(model.inputs)) {
    const auto member = [&](int input) { return "&Inputs::" + names.inputs[static_cast<std::size_t>(input)]; };
    rows.push_back(fmt::format("    {{{}, {{{}}}}}", row.size(), joined(mapped(row, member), ", ")));
  }
  return inputs_have_derivatives(model.inputs) ? joined(rows, ",\n") : "";
}

}  // namespace mbgen
