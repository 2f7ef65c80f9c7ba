#include "compiler/model/inputs.hpp"

#include <algorithm>

namespace mbgen {
namespace {

/// Taylor polynomial of an input by Horner's rule, without its first `order` - 1 terms and their factors.
double advanced(const std::vector<Input>& inputs, const std::vector<double>& values, int input, double dt, int order) {
  const auto i = static_cast<std::size_t>(input);
  if (inputs[i].derivative < 0) return values[i];
  return values[i] + dt / order * advanced(inputs, values, inputs[i].derivative, dt, order + 1);
}

}  // namespace

std::vector<double> advanced_inputs(const std::vector<Input>& inputs, const std::vector<double>& values, double dt) {
  std::vector<double> result;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    result.push_back(advanced(inputs, values, static_cast<int>(i), dt, 1));
  }
  return result;
}

bool inputs_have_derivatives(const std::vector<Input>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.derivative >= 0; });
}

bool is_made_rate(const std::vector<Input>& inputs, int input) {
  const Where& where = inputs[static_cast<std::size_t>(input)].where;
  return std::any_of(inputs.begin(), inputs.end(), [&](const Input& other) {
    return other.derivative == input && other.where.line > 0 && other.where.file == where.file &&
           other.where.pointer == where.pointer;
  });
}

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

}  // namespace mbgen
