#include "workbench/motion/input_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// Of the inputs at t.
std::string trouble_at(const Model& model, const std::vector<BoundedQuantity>& bounded,
                       const std::vector<double>& parameters, const std::vector<double>& inputs, double t) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Presentation& shown = model.inputs[i].shown;
    if (shown.min && inputs[i] < *shown.min)
      return fmt::format("input {} is {:g} at t = {:g} s, its least value is {:g}", model.inputs[i].name, inputs[i], t,
                         *shown.min);
    if (shown.max && inputs[i] > *shown.max)
      return fmt::format("input {} is {:g} at t = {:g} s, its largest value is {:g}", model.inputs[i].name, inputs[i],
                         t, *shown.max);
  }
  for (const BoundedQuantity& quantity : bounded) {
    if (is_out_of_bounds(model, quantity, parameters, inputs))
      return fmt::format("inputs at t = {:g} s make what no model may have: {}", t, quantity.name);
  }
  return "";
}

}  // namespace

void judge_inputs(const Model& model, const InputsOverTime& inputs, StepVerdict& verdict) {
  std::vector<BoundedQuantity> bounded = bounded_quantities(model);
  std::erase_if(bounded, [](const BoundedQuantity& quantity) { return !quantity.takes_inputs; });
  std::vector<double> parameters;
  for (const Parameter& parameter : model.parameters) parameters.push_back(parameter.value);
  std::vector<double> times = {0};
  times.insert(times.end(), inputs.rows.begin(), inputs.rows.end());
  for (const double t : times) {
    const std::string trouble = trouble_at(model, bounded, parameters, inputs.at(t), t);
    if (trouble.empty()) continue;
    verdict.warnings.push_back(trouble);
    return;
  }
}

}  // namespace mbgen
