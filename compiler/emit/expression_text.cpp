#include "compiler/emit/expression_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

/// Functions by operation. For vectors, namespace mbgen has the functions of std.
struct NamedFunction {
  Op op;
  const char* of_numbers;
  const char* of_vectors = of_numbers;
};
constexpr NamedFunction kFunctions[] = {{Op::sqrt, "std::sqrt", "mbgen::sqrt"},
                                        {Op::sin, "mbgen::sine"},
                                        {Op::cos, "mbgen::cosine"},
                                        {Op::tan, "mbgen::tangent"},
                                        {Op::asin, "mbgen::arc_sine"},
                                        {Op::acos, "mbgen::arc_cosine"},
                                        {Op::atan, "mbgen::arc_tangent"},
                                        {Op::atan2, "mbgen::arc_tangent"},
                                        {Op::exp, "mbgen::exponential"},
                                        {Op::log, "mbgen::logarithm"},
                                        {Op::pow, "mbgen::power"},
                                        {Op::tanh, "mbgen::hyperbolic_tangent"},
                                        {Op::floor, "std::floor", "mbgen::floor"},
                                        {Op::abs, "std::abs", "mbgen::abs"},
                                        {Op::min, "mbgen::min"},
                                        {Op::max, "mbgen::max"},
                                        {Op::select, "mbgen::select"},
                                        {Op::multiply_add, "fma"},
                                        {Op::multiply_subtract, "fms"}};

/// An operation under construction.
struct Operation {
  Op op;
  Phrase a, b, c;
};

/// The same value to the bit, with signs of operands absorbed by the signs of terms where possible: a - (-p) becomes a
/// + p, and fnma(-p, a, c) becomes fma(p, a, c).
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

Phrase operation_phrase(Scalar scalar, Op wanted, const Phrase& first, const Phrase& second, const Phrase& third) {
  const auto [op, a, b, c] = with_signs_taken_in({wanted, first, second, third});
  switch (op) {
    case Op::constant:
    case Op::input:
      return a;
    case Op::add:
      return {a.text + " + " + right_term(b), Binding::sum};
    case Op::subtract:
      return {a.text + " - " + right_term(b), Binding::sum};
    case Op::multiply:
      return {operand(a, Binding::product) + "*" + operand(b, Binding::primary), Binding::product};
    case Op::divide:
      return {operand(a, Binding::product) + "/" + operand(b, Binding::primary), Binding::product};
    case Op::negate:
      return {"-" + operand(a, Binding::primary), Binding::sign};
    case Op::sample:
      return {fmt::format("mbgen::sample(kSamples, {})", a.text), Binding::primary};
    case Op::subtract_product:
      return {fmt::format("fnma({}, {}, {})", b.text, c.text, a.text), Binding::primary};
    case Op::pack:
      return {fmt::format("{}{{{}, {}}}", name_of(Scalar::pairs), a.text, b.text), Binding::primary};
    case Op::first_lane:
      return {operand(a, Binding::primary) + "[0]", Binding::primary};
    case Op::second_lane:
      return {operand(a, Binding::primary) + "[1]", Binding::primary};
    default:
      break;
  }
  if (op == Op::select && is_number(scalar))
    return {fmt::format("({} >= {} ? {} : {})", a.text, number_text(0, scalar), b.text, c.text), Binding::primary};
  const NamedFunction& function = *std::ranges::find(kFunctions, op, &NamedFunction::op);
  const bool is_plain = is_number(scalar) && scalar != Scalar::tangents;
  std::string text = is_plain ? function.of_numbers : function.of_vectors;
  text += "(" + a.text;
  if (arity(op) > 1) text += ", " + b.text;
  if (arity(op) > 2) text += ", " + c.text;
  return {text + ")", Binding::primary};
}

Phrase phrase_for_people(Scalar scalar, Op op, Phrase first, Phrase second, const Phrase& third) {
  const auto has_sign = [](const Phrase& phrase) {
    return phrase.text.front() == '-' && (phrase.binding == Binding::product || phrase.binding == Binding::sign);
  };
  const auto change_sign = [&](Phrase& phrase) {
    if (has_sign(phrase)) {
      phrase = {phrase.text.substr(1), phrase.binding == Binding::sign ? Binding::primary : Binding::product};
    } else {
      const bool is_product = phrase.binding == Binding::product;
      phrase = {"-" + operand(phrase, Binding::product), is_product ? Binding::product : Binding::sign};
    }
  };
  if (op == Op::multiply && has_sign(second)) {
    change_sign(second);
    change_sign(first);
  }
  const bool is_sum = op == Op::add || op == Op::subtract;
  if (is_sum && has_sign(second)) {
    change_sign(second);
    op = op == Op::add ? Op::subtract : Op::add;
  }
  if (op == Op::add && has_sign(first)) {
    change_sign(first);
    std::swap(first, second);
    op = Op::subtract;
  }
  return operation_phrase(scalar, op, first, second, third);
}

}  // namespace mbgen
