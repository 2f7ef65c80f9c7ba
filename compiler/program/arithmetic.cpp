#include "compiler/program/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "compiler/decimal/decimal.hpp"

namespace mbgen {
namespace {

/// An operation of one operand.
double of_one(Op op, double x) {
  switch (op) {
    case Op::negate:
      return -x;
    case Op::sqrt:
      return std::sqrt(x);
    case Op::sin:
      return std::sin(x);
    case Op::cos:
      return std::cos(x);
    case Op::tan:
      return std::tan(x);
    case Op::asin:
      return std::asin(x);
    case Op::acos:
      return std::acos(x);
    case Op::atan:
      return std::atan(x);
    case Op::exp:
      return std::exp(x);
    case Op::log:
      return std::log(x);
    case Op::tanh:
      return std::tanh(x);
    case Op::abs:
      return std::abs(x);
    case Op::floor:
      return std::floor(x);
    default:
      throw std::logic_error("constants, inputs, samples and lanes compute nothing");
  }
}

}  // namespace

const char* op_name(Op op) {
  static constexpr std::pair<Op, const char*> kNames[] = {{Op::constant, "constant"},
                                                          {Op::input, "input"},
                                                          {Op::add, "add"},
                                                          {Op::subtract, "sub"},
                                                          {Op::multiply, "mul"},
                                                          {Op::divide, "div"},
                                                          {Op::negate, "neg"},
                                                          {Op::sqrt, "sqrt"},
                                                          {Op::sin, "sin"},
                                                          {Op::cos, "cos"},
                                                          {Op::tan, "tan"},
                                                          {Op::asin, "asin"},
                                                          {Op::acos, "acos"},
                                                          {Op::atan, "atan"},
                                                          {Op::atan2, "atan2"},
                                                          {Op::exp, "exp"},
                                                          {Op::log, "log"},
                                                          {Op::pow, "pow"},
                                                          {Op::tanh, "tanh"},
                                                          {Op::abs, "abs"},
                                                          {Op::min, "min"},
                                                          {Op::max, "max"},
                                                          {Op::select, "select"},
                                                          {Op::multiply_add, "muladd"},
                                                          {Op::multiply_subtract, "mulsub"},
                                                          {Op::subtract_product, "submul"},
                                                          {Op::floor, "floor"},
                                                          {Op::sample, "sample"},
                                                          {Op::pack, "pack"},
                                                          {Op::first_lane, "first_lane"},
                                                          {Op::second_lane, "second_lane"}};
  for (const auto& [named, name] : kNames)
    if (named == op) return name;
  return "unknown";
}

double apply(Op op, double first, double second, double third) {
  switch (op) {
    case Op::add:
      return first + second;
    case Op::subtract:
      return first - second;
    case Op::multiply:
      return first * second;
    case Op::divide:
      return first / second;
    case Op::atan2:
      return std::atan2(first, second);
    case Op::pow:
      return std::pow(first, second);
    case Op::min:
      return std::min(first, second);
    case Op::max:
      return std::max(first, second);
    case Op::select:
      return first >= 0 ? second : third;
    case Op::multiply_add:
      return std::fma(first, second, third);
    case Op::multiply_subtract:
      return std::fma(first, second, -third);
    case Op::subtract_product:
      return std::fma(-second, third, first);
    default:
      return of_one(op, first);
  }
}

double fold(Op op, double first, double second, double third) {
  if (op == Op::add) return decimal_sum(first, second);
  if (op == Op::subtract) return decimal_sum(first, -second);
  if (op == Op::multiply) return decimal_product(first, second);
  const double value = apply(op, first, second, third);
  return op == Op::divide || op == Op::sqrt ? without_rounding(value, value) : value;
}

double sample_of(const std::vector<double>& samples, double index) {
  const double last = static_cast<double>(samples.size() - 1);
  return samples[index >= 0 ? static_cast<std::size_t>(std::min(index, last)) : 0];
}

bool is_odd(Op op) { return op == Op::sin || op == Op::tan || op == Op::asin || op == Op::atan || op == Op::tanh; }

}  // namespace mbgen
