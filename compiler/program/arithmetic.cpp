#include "compiler/program/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compiler/decimal/decimal.hpp"

namespace mbgen {

int arity(Op op) {
  switch (op) {
    case Op::constant:
    case Op::input:
      return 0;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::atan2:
    case Op::pow:
    case Op::min:
    case Op::max:
    case Op::pack:
      return 2;
    case Op::select:
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return 3;
    default:
      return 1;
  }
}

const char* op_name(Op op) {
  switch (op) {
    case Op::constant:
      return "constant";
    case Op::input:
      return "input";
    case Op::add:
      return "add";
    case Op::subtract:
      return "sub";
    case Op::multiply:
      return "mul";
    case Op::divide:
      return "div";
    case Op::negate:
      return "neg";
    case Op::sqrt:
      return "sqrt";
    case Op::sin:
      return "sin";
    case Op::cos:
      return "cos";
    case Op::tan:
      return "tan";
    case Op::asin:
      return "asin";
    case Op::acos:
      return "acos";
    case Op::atan:
      return "atan";
    case Op::atan2:
      return "atan2";
    case Op::exp:
      return "exp";
    case Op::log:
      return "log";
    case Op::pow:
      return "pow";
    case Op::tanh:
      return "tanh";
    case Op::abs:
      return "abs";
    case Op::min:
      return "min";
    case Op::max:
      return "max";
    case Op::select:
      return "select";
    case Op::multiply_add:
      return "muladd";
    case Op::multiply_subtract:
      return "mulsub";
    case Op::subtract_product:
      return "submul";
    case Op::floor:
      return "floor";
    case Op::sample:
      return "sample";
    case Op::pack:
      return "pack";
    case Op::first_lane:
      return "first_lane";
    case Op::second_lane:
      return "second_lane";
  }
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
    case Op::negate:
      return -first;
    case Op::sqrt:
      return std::sqrt(first);
    case Op::sin:
      return std::sin(first);
    case Op::cos:
      return std::cos(first);
    case Op::tan:
      return std::tan(first);
    case Op::asin:
      return std::asin(first);
    case Op::acos:
      return std::acos(first);
    case Op::atan:
      return std::atan(first);
    case Op::atan2:
      return std::atan2(first, second);
    case Op::exp:
      return std::exp(first);
    case Op::log:
      return std::log(first);
    case Op::pow:
      return std::pow(first, second);
    case Op::tanh:
      return std::tanh(first);
    case Op::abs:
      return std::abs(first);
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
    case Op::floor:
      return std::floor(first);
    case Op::sample:
    case Op::constant:
    case Op::input:
    case Op::pack:
    case Op::first_lane:
    case Op::second_lane:
      break;
  }
  throw std::logic_error("constants, inputs, samples and lanes compute nothing");
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

bool is_commutative(Op op) { return op == Op::add || op == Op::multiply || op == Op::min || op == Op::max; }

bool is_odd(Op op) { return op == Op::sin || op == Op::tan || op == Op::asin || op == Op::atan || op == Op::tanh; }

}  // namespace mbgen
