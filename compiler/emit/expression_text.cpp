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

/// An operation in the making.
struct Operation {
  Op op;
  Phrase a, b, c;
};

/// The same value to the bit, with signs of operands as signs of terms where an operation has them: a - (-p) is a + p,
/// and fnma(-p, a, c) is fma(p, a, c).
Operation with_signs_taken_in(Operation o) {
  const auto sheds_sign = [](Phrase& phrase) {
    if (phrase.binding != Binding::sign) return false;
    phrase = {phrase.text.substr(1), Binding::primary};
    return true;
  };
  const auto product_sheds_sign = [&](Phrase& x, Phrase& y) {
    const bool first = sheds_sign(x), second = sheds_sign(y);
    return first != second;
  };
  switch (o.op) {
    case Op::add:
      if (sheds_sign(o.b)) return {Op::subtract, o.a, o.b, {}};
      if (sheds_sign(o.a)) return {Op::subtract, o.b, o.a, {}};
      return o;
    case Op::subtract:
      if (sheds_sign(o.b)) o.op = Op::add;
      return o;
    case Op::multiply_add:
      if (product_sheds_sign(o.a, o.b)) return {Op::subtract_product, o.c, o.a, o.b};
      if (sheds_sign(o.c)) o.op = Op::multiply_subtract;
      return o;
    case Op::multiply_subtract:
      if (sheds_sign(o.c)) o.op = Op::multiply_add;
      return o;
    case Op::subtract_product:
      if (product_sheds_sign(o.b, o.c)) return {Op::multiply_add, o.b, o.c, o.a};
      return o;
    default:
      return o;
  }
}

}  // namespace

Phrase constant_phrase(const std::string& text) {
  return {text, text.front() == '-' ? Binding::sign : Binding::primary};
}

Phrase operation_phrase(const std::string& scalar, Op wanted, const Phrase& first, const Phrase& second,
                        const Phrase& third) {
  const auto [op, a, b, c] = with_signs_taken_in({wanted, first, second, third});
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
