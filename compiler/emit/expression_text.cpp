#include "compiler/emit/expression_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/layout.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// The text, in parentheses when it binds less tightly than `needed`.
std::string operand(const Phrase& phrase, Binding needed) {
  return phrase.binding >= needed ? phrase.text : fmt::format("({})", phrase.text);
}

/// Right operand of + and -: a sign there would read as `a - -b`.
std::string right_term(const Phrase& phrase) {
  return operand(phrase, phrase.binding == Binding::sign ? Binding::primary : Binding::product);
}

std::string call(const std::string& function, const Phrase& first) { return function + "(" + first.text + ")"; }

std::string call(const std::string& function, const Phrase& first, const Phrase& second) {
  return function + "(" + first.text + ", " + second.text + ")";
}

std::string call(const std::string& function, const Phrase& first, const Phrase& second, const Phrase& third) {
  return function + "(" + first.text + ", " + second.text + ", " + third.text + ")";
}

}  // namespace

Phrase constant_phrase(const std::string& text) {
  return {text, text.front() == '-' ? Binding::sign : Binding::primary};
}

Phrase operation_phrase(const std::string& scalar, Op op, const Phrase& a, const Phrase& b, const Phrase& c) {
  const std::string library = is_number(scalar) ? "std::" : "mbgen::";
  switch (op) {
    case Op::add:
      return {a.text + " + " + right_term(b), Binding::sum};
    case Op::subtract:
      return {a.text + " - " + right_term(b), Binding::sum};
    case Op::multiply:
      return {operand(a, Binding::product) + "*" + operand(b, Binding::primary), Binding::product};
    case Op::divide:
      return {operand(a, Binding::product) + "/" + operand(b, Binding::primary), Binding::product};
    case Op::negate:
      return {fmt::format("-{}", operand(a, Binding::primary)), Binding::sign};
    case Op::sqrt:
      return {call(library + "sqrt", a), Binding::primary};
    case Op::sin:
      return {call("mbgen::sine", a), Binding::primary};
    case Op::cos:
      return {call("mbgen::cosine", a), Binding::primary};
    case Op::tan:
      return {call("mbgen::tangent", a), Binding::primary};
    case Op::asin:
      return {call("mbgen::arc_sine", a), Binding::primary};
    case Op::acos:
      return {call("mbgen::arc_cosine", a), Binding::primary};
    case Op::atan:
      return {call("mbgen::arc_tangent", a), Binding::primary};
    case Op::atan2:
      return {call("mbgen::arc_tangent", a, b), Binding::primary};
    case Op::exp:
      return {call("mbgen::exponential", a), Binding::primary};
    case Op::log:
      return {call("mbgen::logarithm", a), Binding::primary};
    case Op::pow:
      return {call("mbgen::power", a, b), Binding::primary};
    case Op::tanh:
      return {call("mbgen::hyperbolic_tangent", a), Binding::primary};
    case Op::abs:
      return {call(library + "abs", a), Binding::primary};
    case Op::min:
      return {call("mbgen::min", a, b), Binding::primary};
    case Op::max:
      return {call("mbgen::max", a, b), Binding::primary};
    case Op::select:
      if (!is_number(scalar)) return {call("mbgen::select", a, b, c), Binding::primary};
      return {fmt::format("({} >= {} ? {} : {})", a.text, number_text(0, scalar), b.text, c.text), Binding::primary};
    case Op::multiply_add:
      return {call("fma", a, b, c), Binding::primary};
    case Op::multiply_subtract:
      return {call("fms", a, b, c), Binding::primary};
    case Op::subtract_product:
      return {call("fnma", b, c, a), Binding::primary};
    case Op::constant:
    case Op::input:
      break;
  }
  return a;
}

}  // namespace mbgen
