#include "compiler/program/operations.hpp"

#include "mbgen/scalar.hpp"

#include <cmath>

namespace mbgen {

int arity(Op op) {
  switch (op) {
    case Op::constant: case Op::input: return 0;
    case Op::add: case Op::subtract: case Op::multiply: case Op::divide: return 2;
    case Op::atan2: case Op::pow: case Op::min: case Op::max: return 2;
    case Op::select: return 3;
    default: return 1;
  }
}

const char* op_name(Op op) {
  static const char* const kNames[] = {"const", "input", "add", "sub", "mul", "div", "neg", "sqrt", "sin", "cos", "tan", "asin",
                                       "acos", "atan", "atan2", "exp", "log", "pow", "tanh", "abs", "min", "max", "select"};
  return kNames[static_cast<int>(op)];
}

bool commutes(Op op) { return op == Op::add || op == Op::multiply; }

double apply(Op op, double a, double b, double c) {
  switch (op) {
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return a / b;
    case Op::negate: return -a;
    case Op::sqrt: return std::sqrt(a);
    case Op::sin: return std::sin(a);
    case Op::cos: return std::cos(a);
    case Op::tan: return std::tan(a);
    case Op::asin: return std::asin(a);
    case Op::acos: return std::acos(a);
    case Op::atan: return std::atan(a);
    case Op::atan2: return std::atan2(a, b);
    case Op::exp: return std::exp(a);
    case Op::log: return std::log(a);
    case Op::pow: return std::pow(a, b);
    case Op::tanh: return std::tanh(a);
    case Op::abs: return mbgen::abs(a);
    case Op::min: return mbgen::min(a, b);
    case Op::max: return mbgen::max(a, b);
    case Op::select: return mbgen::select(a, b, c);
    case Op::constant: case Op::input: break;
  }
  return 0;
}

}  // namespace mbgen
