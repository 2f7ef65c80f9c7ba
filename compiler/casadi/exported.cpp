#include "compiler/casadi/exported.hpp"

#include <fmt/format.h>

#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Directions that one call of a derivative takes, as CasADi asks for them: powers of two.
constexpr int kWidths[] = {1, 2, 4, 8};

}  // namespace

std::string PatternTable::name_of(const Pattern& pattern) {
  std::string numbers = fmt::format("{}, {}", pattern.rows, pattern.columns());
  for (const int first : pattern.first) numbers += fmt::format(", {}", first);
  for (const int row : pattern.row) numbers += fmt::format(", {}", row);
  const auto [entry, is_new] = names_.try_emplace(numbers, fmt::format("sparsity_{}", names_.size() + 1));
  if (is_new)
    rows_.push_back({{"array", fmt::format("static const casadi_int {}[] = {{\n{}}};", entry->second,
                                           wrapped_words(numbers, "    "))}});
  return entry->second;
}

FrameValues exported_row(const Exported& exported, PatternTable& patterns) {
  const auto rows = [&](const std::vector<std::pair<std::string, Pattern>>& list) {
    return mapped(list, [&](const auto& item) {
      return FrameValues{{"label", item.first}, {"pattern", patterns.name_of(item.second)}};
    });
  };
  return {{"function", exported.name},
          {"call", exported.call},
          {"input_count", exported.inputs.size()},
          {"output_count", exported.outputs.size()},
          {"function_inputs", rows(exported.inputs)},
          {"function_outputs", rows(exported.outputs)}};
}

std::vector<Exported> exported_functions(const CasadiFunction& function, const CasadiArguments& arguments,
                                         const std::string& table) {
  const std::vector<std::string> names = arguments.names();
  const std::vector<int> first = arguments.first();
  const int rows = static_cast<int>(function.rows.size());
  std::vector<std::pair<std::string, Pattern>> inputs, blocks;
  for (std::size_t a = 0; a < names.size(); ++a) {
    inputs.push_back({names[a], dense_pattern(first[a + 1] - first[a])});
    blocks.push_back(
        {"jac_" + function.result + "_" + names[a], columns_of(function.jacobian, first[a], first[a + 1])});
  }
  std::vector<Exported> all = {
      {function.name, "evaluate(&" + table + ", arg, res, w)", inputs, {{function.result, dense_pattern(rows)}}}};
  auto of_derivatives = inputs;
  of_derivatives.push_back({"out_" + function.result, empty_pattern(rows)});
  all.push_back({"jac_" + function.name, "jacobian(&" + table + ", arg, res, w)", of_derivatives, blocks});
  for (const int width : kWidths) {
    Exported forward{fmt::format("fwd{}_{}", width, function.name),
                     fmt::format("forward(&{}, {}, arg, res, w)", table, width),
                     of_derivatives,
                     {{"fwd_" + function.result, dense_pattern(rows, width)}}};
    Exported adjoint{fmt::format("adj{}_{}", width, function.name),
                     fmt::format("adjoint(&{}, {}, arg, res, w)", table, width),
                     of_derivatives,
                     {}};
    adjoint.inputs.push_back({"adj_" + function.result, dense_pattern(rows, width)});
    for (std::size_t a = 0; a < names.size(); ++a) {
      const Pattern seeds = dense_pattern(first[a + 1] - first[a], width);
      forward.inputs.push_back({"fwd_" + names[a], seeds});
      adjoint.outputs.push_back({"adj_" + names[a], seeds});
    }
    all.insert(all.end(), {forward, adjoint});
  }
  return all;
}

}  // namespace mbgen
