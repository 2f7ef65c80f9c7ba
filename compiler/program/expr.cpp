#include "compiler/program/operations.hpp"

#include <cmath>

namespace mbgen {
namespace {

Expr unary(Op op, const Expr& a) {
  if (!a.builder()) return Expr(apply(op, a.constant(), 0, 0));
  return {*a.builder(), a.builder()->append(op, a.value(*a.builder()))};
}

bool is(const Expr& a, double constant) { return !a.builder() && a.constant() == constant; }

Expr binary(Op op, const Expr& a, const Expr& b) {
  ProgramBuilder* builder = a.builder() ? a.builder() : b.builder();
  if (!builder) return Expr(apply(op, a.constant(), b.constant(), 0));
  return {*builder, builder->append(op, a.value(*builder), b.value(*builder))};
}

}  // namespace

// A recorded value that folded to a constant forgets its builder, so that constants stay cheap and recognisable.
Expr::Expr(ProgramBuilder& builder, ValueId value) : builder_(&builder), value_(value) {
  if (builder.node(value).op == Op::constant) {
    builder_ = nullptr;
    constant_ = builder.node(value).constant;
  }
}

bool Expr::is_constant() const { return builder_ == nullptr; }
double Expr::constant() const { return constant_; }
ValueId Expr::value(ProgramBuilder& builder) const { return builder_ ? value_ : builder.constant(constant_); }

Expr operator+(const Expr& a, const Expr& b) { return is(a, 0) ? b : is(b, 0) ? a : binary(Op::add, a, b); }
Expr operator-(const Expr& a, const Expr& b) { return is(b, 0) ? a : binary(Op::subtract, a, b); }
Expr operator*(const Expr& a, const Expr& b) {
  if (is(a, 0) || is(b, 0)) return Expr(0.0);
  return is(a, 1) ? b : is(b, 1) ? a : binary(Op::multiply, a, b);
}
Expr operator/(const Expr& a, const Expr& b) { return is(b, 1) ? a : binary(Op::divide, a, b); }
Expr operator-(const Expr& a) { return unary(Op::negate, a); }
Expr sqrt(const Expr& a) { return unary(Op::sqrt, a); }
Expr sin(const Expr& a) { return unary(Op::sin, a); }
Expr cos(const Expr& a) { return unary(Op::cos, a); }
Expr tan(const Expr& a) { return unary(Op::tan, a); }
Expr asin(const Expr& a) { return unary(Op::asin, a); }
Expr acos(const Expr& a) { return unary(Op::acos, a); }
Expr atan(const Expr& a) { return unary(Op::atan, a); }
Expr atan2(const Expr& y, const Expr& x) { return binary(Op::atan2, y, x); }
Expr exp(const Expr& a) { return unary(Op::exp, a); }
Expr log(const Expr& a) { return unary(Op::log, a); }
Expr pow(const Expr& a, const Expr& b) { return binary(Op::pow, a, b); }
Expr tanh(const Expr& a) { return unary(Op::tanh, a); }
Expr abs(const Expr& a) { return unary(Op::abs, a); }
Expr min(const Expr& a, const Expr& b) { return binary(Op::min, a, b); }
Expr max(const Expr& a, const Expr& b) { return binary(Op::max, a, b); }
Expr select(const Expr& condition, const Expr& a, const Expr& b) {
  if (condition.is_constant()) return condition.constant() >= 0 ? a : b;
  ProgramBuilder& builder = *condition.builder();
  return {builder, builder.append(Op::select, condition.value(builder), a.value(builder), b.value(builder))};
}

}  // namespace mbgen
