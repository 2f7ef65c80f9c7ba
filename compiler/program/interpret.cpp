#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Counts one operation in each of `lanes`; negations, constants, inputs and what packs and takes apart are free.
void count(OperationCount& total, Op op, int lanes) {
  switch (op) {
    case Op::constant:
    case Op::input:
    case Op::negate:
    case Op::pack:
    case Op::first_lane:
    case Op::second_lane:
      return;
    case Op::add:
    case Op::subtract:
      total.add += lanes;
      return;
    case Op::multiply:
      total.multiply += lanes;
      return;
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      total.multiply += lanes;
      total.add += lanes;
      return;
    case Op::divide:
      total.divide += lanes;
      return;
    case Op::sqrt:
      total.sqrt += lanes;
      return;
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::atan2:
      total.trigonometric += lanes;
      return;
    default:
      total.other += lanes;
      return;
  }
}

/// A value at sets of inputs side by side.
constexpr std::size_t kLanes = 8;
using Lanes = std::array<double, kLanes>;

Lanes applied(Op op, const Lanes& first, const Lanes& second, const Lanes& third) {
  Lanes result;
  const auto each = [&](const auto& operation) {
    for (std::size_t i = 0; i < kLanes; ++i) result[i] = operation(first[i], second[i], third[i]);
  };
  switch (op) {
    case Op::add:
      each([](double a, double b, double) { return a + b; });
      break;
    case Op::subtract:
      each([](double a, double b, double) { return a - b; });
      break;
    case Op::multiply:
      each([](double a, double b, double) { return a * b; });
      break;
    case Op::divide:
      each([](double a, double b, double) { return a / b; });
      break;
    case Op::negate:
      each([](double a, double, double) { return -a; });
      break;
    default:
      each([op](double a, double b, double c) { return apply(op, a, b, c); });
  }
  return result;
}

Lanes in_all(double value) {
  Lanes result;
  result.fill(value);
  return result;
}

/// The values of a program at kLanes sets of inputs.
class SideBySide {
 public:
  explicit SideBySide(const Program& program)
      : program_(program), values_(program.nodes.size()), varies_(program.nodes.size(), 0) {}

  void run(const std::vector<Lanes>& inputs) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const Node& node = program_.nodes[i];
      if (node.op == Op::constant) {
        values_[i] = in_all(node.constant);
      } else if (node.op == Op::input) {
        values_[i] = inputs[static_cast<std::size_t>(node.input)];
        const double first = values_[i].front();
        varies_[i] = std::ranges::any_of(values_[i], [&](double value) { return value != first; });
      } else {
        compute(node, i);
      }
    }
  }
  const Lanes& value(std::size_t node) const { return values_[node]; }

 private:
  void compute(const Node& node, std::size_t i) {
    const int count = arity(node.op);
    const Lanes* operands[3] = {&none_, &none_, &none_};
    varies_[i] = 0;
    for (int k = 0; k < count; ++k) {
      operands[k] = &values_[node.operands[k]];
      if (varies_[node.operands[k]] != 0) varies_[i] = 1;
    }
    const auto& [first, second, third] = operands;
    if (node.op == Op::sample) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) values_[i][lane] = sample_of(*program_.samples, (*first)[lane]);
    } else if (varies_[i] != 0) {
      values_[i] = applied(node.op, *first, *second, *third);
    } else {
      values_[i] = in_all(apply(node.op, first->front(), second->front(), third->front()));
    }
  }

  const Program& program_;
  const Lanes none_{};
  std::vector<Lanes> values_;
  std::vector<char> varies_;
};

void require_inputs(const Program& program, std::size_t given) {
  if (given == program.inputs.size()) return;
  throw std::invalid_argument(
      fmt::format("program {} has {} inputs, {} given", program.name, program.inputs.size(), given));
}

}  // namespace

std::vector<double> interpret(const Program& program, std::span<const double> inputs, std::size_t sets) {
  require_inputs(program, inputs.size() / sets);
  if (has_pairs(program)) return interpret(unfolded(program), inputs, sets);
  std::vector<double> result(program.outputs.size() * sets);
  SideBySide lanes(program);
  std::vector<Lanes> taken(program.inputs.size());
  for (std::size_t from = 0; from < sets; from += kLanes) {
    for (std::size_t i = 0; i < taken.size(); ++i)
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        taken[i][lane] = inputs[i * sets + std::min(from + lane, sets - 1)];
    lanes.run(taken);
    for (std::size_t i = 0; i < program.outputs.size(); ++i)
      for (std::size_t lane = 0; lane < std::min(kLanes, sets - from); ++lane)
        result[i * sets + from + lane] = lanes.value(program.outputs[i].value)[lane];
  }
  return result;
}

std::vector<double> interpret(const Program& program, std::span<const double> inputs) {
  require_inputs(program, inputs.size());
  if (has_pairs(program)) return interpret(unfolded(program), inputs);
  std::vector<double> values(program.nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& node = program.nodes[i];
    if (node.op == Op::constant) {
      values[i] = node.constant;
    } else if (node.op == Op::input) {
      values[i] = inputs[static_cast<std::size_t>(node.input)];
    } else if (node.op == Op::sample) {
      values[i] = sample_of(*program.samples, values[node.operands[0]]);
    } else {
      double operands[3] = {0, 0, 0};
      for (int k = 0; k < arity(node.op); ++k) operands[k] = values[node.operands[k]];
      values[i] = apply(node.op, operands[0], operands[1], operands[2]);
    }
  }
  std::vector<double> result;
  result.reserve(program.outputs.size());
  for (const OutputValue& output : program.outputs) result.push_back(values[output.value]);
  return result;
}

std::vector<bool> needed_values(const Program& program) {
  std::vector<bool> needed(program.nodes.size(), false);
  for (const OutputValue& output : program.outputs) needed[output.value] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const Node& node = program.nodes[i];
    for (int k = 0; k < arity(node.op); ++k) needed[node.operands[k]] = true;
  }
  return needed;
}

OperationCount count_operations(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  const std::vector<int> widths = widths_of(program);
  OperationCount total;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) count(total, program.nodes[i].op, std::max(widths[i], 1));
  }
  return total;
}

std::map<Section, std::size_t> places_of_sections(const Program& program) {
  std::map<Section, std::size_t> places;
  for (const Section& section : program.sections) places.emplace(section, places.size());
  return places;
}

std::vector<OperationCount> count_operations_by_section(const Program& program) {
  const std::vector<bool> needed = needed_values(program);
  const std::map<Section, std::size_t> places = places_of_sections(program);
  const std::vector<int> widths = widths_of(program);
  std::vector<OperationCount> totals(program.sections.size());
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) count(totals[places.at(program.nodes[i].section)], program.nodes[i].op, std::max(widths[i], 1));
  }
  return totals;
}

}  // namespace mbgen
