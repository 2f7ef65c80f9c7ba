#include <cmath>
#include <stdexcept>

#include "compiler/program/arithmetic.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

bool is(const Expr& a, double constant) { return a.is_constant() && a.constant() == constant; }

/// A folded number, with the name of its operation in programs for reading.
Expr folded(Op op, const Expr& a, const Expr& b = {}) {
  const Expr value = fold(op, a.constant(), b.constant(), 0);
  ProgramBuilder* builder = a.builder_of_name() ? a.builder_of_name() : b.builder_of_name();
  if (builder == nullptr) return value;
  const auto label = [&](const Expr& e) { return e.builder_of_name() == builder ? e.name() : -1; };
  const std::int32_t name = builder->label_fold(
      value.constant(),
      {.name = "", .op = op, .operands = {a.constant(), b.constant()}, .labels = {label(a), label(b)}});
  return value.named(name, builder);
}

Expr record(Op op, const Expr& a) {
  if (a.is_constant())
    return op == Op::negate ? Expr(-a.constant()).named(a.name(), a.builder_of_name()) : folded(op, a);
  ProgramBuilder& builder = *a.builder();
  return Expr(builder, builder.append(op, a.value(builder)));
}

Expr record(Op op, const Expr& a, const Expr& b) {
  if (a.is_constant() && b.is_constant()) return folded(op, a, b);
  ProgramBuilder& builder = a.is_constant() ? *b.builder() : *a.builder();
  return Expr(builder, builder.append(op, a.value(builder), b.value(builder)));
}

/// Infinities and NaN as values that do not fold: programs have finite constants.
ValueId not_finite(ProgramBuilder& builder, double value) {
  if (std::isnan(value)) return builder.append(Op::log, builder.constant(-1));
  const ValueId infinity = builder.append(Op::log, builder.constant(0));
  return value < 0 ? infinity : builder.append(Op::negate, infinity);
}

}  // namespace

// A recorded value that folded to a constant forgets its builder, so that it goes on folding without one.
Expr::Expr(ProgramBuilder& builder, ValueId value) : builder_(&builder), value_(value) {
  if (!builder.is_constant(value)) return;
  builder_ = nullptr;
  constant_ = builder.node(value).constant;
  name_ = builder.node(value).label;
  if (name_ >= 0 && builder.is_for_reading()) builder_of_name_ = &builder;
}

Expr Expr::named(std::int32_t name, ProgramBuilder* builder) const {
  Expr result = *this;
  result.name_ = name;
  result.builder_of_name_ = name >= 0 && builder != nullptr && builder->is_for_reading() ? builder : nullptr;
  return result;
}

ValueId Expr::value(ProgramBuilder& builder) const {
  const bool is_of_other = builder_of_name_ != nullptr && builder_of_name_ != &builder;
  if (is_constant())
    return std::isfinite(constant_) ? builder.constant(constant_, is_of_other ? -1 : name_)
                                    : not_finite(builder, constant_);
  if (builder_ != &builder) throw std::logic_error("an expression mixes values of two programs");
  return value_;
}

// The cases with 0, 1 and -1 are rules of the builder too; decided here they leave no unused constants behind.

Expr operator+(const Expr& a, const Expr& b) {
  if (is(a, 0)) return b;
  if (is(b, 0)) return a;
  return record(Op::add, a, b);
}

Expr operator-(const Expr& a, const Expr& b) {
  if (is(b, 0)) return a;
  if (is(a, 0)) return -b;
  return record(Op::subtract, a, b);
}

Expr operator*(const Expr& a, const Expr& b) {
  if (is(a, 0) || is(b, 0)) return 0.0;
  if (is(a, 1)) return b;
  if (is(b, 1)) return a;
  if (is(a, -1)) return -b;
  if (is(b, -1)) return -a;
  return record(Op::multiply, a, b);
}

Expr operator/(const Expr& a, const Expr& b) {
  if (is(a, 0) && !b.is_constant()) return 0.0;
  if (is(b, 1)) return a;
  if (is(b, -1)) return -a;
  return record(Op::divide, a, b);
}

Expr operator-(const Expr& a) { return record(Op::negate, a); }
Expr sqrt(const Expr& a) { return record(Op::sqrt, a); }
Expr sin(const Expr& a) { return record(Op::sin, a); }
Expr cos(const Expr& a) { return record(Op::cos, a); }
Expr tan(const Expr& a) { return record(Op::tan, a); }
Expr asin(const Expr& a) { return record(Op::asin, a); }
Expr acos(const Expr& a) { return record(Op::acos, a); }
Expr atan(const Expr& a) { return record(Op::atan, a); }
Expr atan2(const Expr& y, const Expr& x) { return record(Op::atan2, y, x); }
Expr exp(const Expr& a) { return record(Op::exp, a); }
Expr log(const Expr& a) { return record(Op::log, a); }
Expr pow(const Expr& a, const Expr& b) { return record(Op::pow, a, b); }
Expr tanh(const Expr& a) { return record(Op::tanh, a); }
Expr floor(const Expr& a) { return record(Op::floor, a); }
Expr sample(const std::vector<double>& samples, const Expr& index) {
  if (index.is_constant()) return sample_of(samples, index.constant());
  return Expr(*index.builder(), index.builder()->append(Op::sample, index.value(*index.builder())));
}
Expr abs(const Expr& a) { return record(Op::abs, a); }
Expr min(const Expr& a, const Expr& b) { return record(Op::min, a, b); }
Expr max(const Expr& a, const Expr& b) { return record(Op::max, a, b); }

Expr select(const Expr& condition, const Expr& a, const Expr& b) {
  if (condition.is_constant()) return condition.constant() >= 0 ? a : b;
  ProgramBuilder& builder = *condition.builder();
  return Expr(builder, builder.append(Op::select, condition.value(builder), a.value(builder), b.value(builder)));
}

}  // namespace mbgen
