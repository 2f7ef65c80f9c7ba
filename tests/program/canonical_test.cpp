// The order of a traced program, whatever order its expressions were evaluated in.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// Order of evaluation of `a() o b()` by a compiler: the left operand first, or the right one.
using Evaluate = std::function<Expr(Op, const std::function<Expr()>&, const std::function<Expr()>&)>;

Expr applied(Op op, const Expr& a, const Expr& b) {
  return op == Op::add ? a + b : op == Op::subtract ? a - b : op == Op::multiply ? a * b : a / b;
}

Expr left_first(Op op, const std::function<Expr()>& left, const std::function<Expr()>& right) {
  const Expr a = left(), b = right();
  return applied(op, a, b);
}

Expr right_first(Op op, const std::function<Expr()>& left, const std::function<Expr()>& right) {
  const Expr b = right(), a = left();
  return applied(op, a, b);
}

/// Two named statements and an output: p = x0 x1 + 3 sin x2, q = p / x3 - x1 x0, y0 = q - cos x4 x5.
Program traced(const Evaluate& evaluate) {
  ProgramBuilder builder("f");
  const auto x = [&](int i) { return Expr(builder, builder.input(Array::x, i)); };
  const auto product = [&](int i, int k) {
    return evaluate(
        Op::multiply, [&, i] { return x(i); }, [&, k] { return x(k); });
  };
  builder.set_section({Step::inertias});
  const Expr p = evaluate(
      Op::add, [&] { return product(0, 1); },
      [&] {
        return evaluate(
            Op::multiply, [] { return Expr(3); }, [&] { return sin(x(2)); });
      });
  builder.label(p.value(builder), "p");
  builder.set_section({Step::jacobian});
  const Expr q = evaluate(
      Op::subtract,
      [&] {
        return evaluate(
            Op::divide, [&] { return p; }, [&] { return x(3); });
      },
      [&] { return product(1, 0); });
  builder.label(q.value(builder), "q");
  const Expr y = evaluate(
      Op::subtract, [&] { return q; },
      [&] {
        return evaluate(
            Op::multiply, [&] { return cos(x(4)); }, [&] { return x(5); });
      });
  builder.output(Array::y, 0, y.value(builder));
  return builder.finish_in_canonical_order();
}

TEST(CanonicalOrder, IsThatOfEveryOrderOfEvaluation) { EXPECT_EQ(dump(traced(left_first)), dump(traced(right_first))); }

TEST(CanonicalOrder, KeepsStatementsAndPutsOperandsBeforeTheirUser) {
  EXPECT_EQ(dump(traced(right_first)),
            "program f\n"
            "%0 = input x[0]\n"
            "%1 = input x[1]\n"
            "; section step 1\n"
            "%2 = mul %0 %1\n"
            "%3 = constant 3\n"
            "%4 = input x[2]\n"
            "%5 = sin %4\n"
            "%6 = mul %3 %5\n"
            "%7 = add %2 %6  ; p\n"
            "%8 = input x[3]\n"
            "; section step 2\n"
            "%9 = div %7 %8\n"
            "%10 = sub %9 %2  ; q\n"
            "%11 = input x[5]\n"
            "%12 = input x[4]\n"
            "%13 = cos %12\n"
            "%14 = mul %11 %13\n"
            "%15 = sub %10 %14\n"
            "out y[0] = %15\n");
}

TEST(CanonicalOrder, KeepsWhatIsComputed) {
  const std::vector<double> inputs = {0.3, -1.5, 2.25, 0.7, 1.1, -0.4};
  const Program program = traced(right_first);
  std::vector<double> values;
  for (const Slot& slot : program.inputs) values.push_back(inputs[static_cast<std::size_t>(slot.index)]);
  const double p = 0.3 * -1.5 + 3 * std::sin(2.25);
  EXPECT_EQ(interpret(program, values), std::vector<double>{p / 0.7 - -1.5 * 0.3 - std::cos(1.1) * -0.4});
}

}  // namespace
}  // namespace mbgen
