// Pieces of the text: numbers, names, lines, expressions.

#include "compiler/emit/text.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <limits>

#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/names.hpp"
#include "tests/emit/emit_support.hpp"

namespace mbgen::test {
namespace {

TEST(EmittedNumbers, areShortestAndReadBackExactly) {
  EXPECT_EQ(number_text(1), "1.0");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(0.1, Scalar::floats), "0.1f");
  EXPECT_EQ(number_text(-3.0, Scalar::floats), "-3.0f");
  EXPECT_EQ(number_text(-9.81), "-9.81");
  EXPECT_EQ(number_text(1e22), "1e+22");
  EXPECT_EQ(number_text(0.0), "0.0");
  EXPECT_EQ(number_text(-0.0), "-0.0");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "INFINITY");
  for (const double value :
       {1.0 / 3, 2.2250738585072014e-308, std::numeric_limits<double>::max(), 123456789.0, 0.1 + 0.2}) {
    EXPECT_EQ(std::stod(number_text(value)), value);
  }
}

TEST(EmittedNames, areIdentifiersAndUnique) {
  UniqueNames unique;
  const std::pair<const char*, const char*> expected[] = {
      {"crank", "crank"},  {"crank", "crank_2"}, {"crank", "crank_3"}, {"crank_2", "crank_2_2"},
      {"class", "class_"}, {"class", "class_2"}, {"4bar", "n_4bar"},   {"Rüder", "R_der"},
      {"", "unnamed"},     {"__x", "x"},         {"a__b-c", "a_b_c"},  {"M_PI", "M_PI_"},
      {"gamma", "gamma_"}, {"std", "std_"},      {"_", "unnamed_2"},   {"Index", "Index_"}};
  for (const auto& [name, result] : expected) EXPECT_EQ(unique.identifier(name), result) << name;
}

TEST(EmittedNames, ofOutputsLeaveRoomForTheEnergies) {
  Model model;
  model.name = "double";
  model.outputs.resize(2);
  model.outputs[0].name = "kinetic_energy";
  model.outputs[1].name = "x";
  const SolverNames names = model_names(model);
  EXPECT_EQ(names.solver, "double_");
  EXPECT_EQ(names.outputs, (std::vector<std::string>{"kinetic_energy_2", "x"}));
}

TEST(EmittedLines, areBrokenAtSpaces) {
  const std::string word(40, 'x');
  EXPECT_EQ(wrapped_statement("  a = " + word + " + " + word + " + " + word + ";"),
            "  a = " + word + " + " + word + " +\n      " + word + ";");
  EXPECT_EQ(wrapped_list({word, word, word}, 2), "  " + word + ", " + word + ",\n  " + word);
  EXPECT_EQ(braced_list("  int a[] = ", {"1", "2"}, ";"), "  int a[] = {1, 2};");
  EXPECT_EQ(braced_list("  int a[] = ", {word, word, word}, ";"),
            "  int a[] = {\n      " + word + ", " + word + ",\n      " + word + "};");
  EXPECT_EQ(wrapped_words(word + " " + word + "  " + word, "/// "), "/// " + word + " " + word + "\n/// " + word);
  const std::string endless(200, 'y');
  EXPECT_EQ(wrapped_statement("  " + endless + " z"), "  " + endless + "\n      z");
}

TEST(EmittedLiterals, areEscaped) {
  EXPECT_EQ(string_literal("N m \"x\" \\ \n1"), "\"N m \\\"x\\\" \\\\ \\0121\"");
  EXPECT_EQ(comment_text("a\nb\\"), "a b\\.");
  // Trigraphs, controls of the direction of writing, ends of lines, bytes that are no UTF-8; what people write stays.
  EXPECT_EQ(string_literal("?\?/"), "\"?\\?/\"");
  EXPECT_EQ(string_literal("m\u00b2\u202e\xff"), "\"m\u00b2\\342\\200\\256\\377\"");
  EXPECT_EQ(comment_text("m\u00b2\u202e\u2028\xed\xa0\x80 ?\?/"), "m\u00b2      ?\?/.");
}

TEST(EmittedNames, ofSolversLeaveTheGlobalNamespaceAlone) {
  const std::pair<const char*, const char*> expected[] = {
      {"main", "main_"}, {"index", "index_"}, {"sinf", "sinf_"},  {"uint8_t", "uint8_t_"}, {"test", "test_"},
      {"all", "all_"},   {"lanes", "lanes_"}, {"coach", "coach"}, {"ball", "ball"},        {"A_B", "A_B_"}};
  for (const auto& [name, result] : expected) {
    Model model;
    model.name = name;
    EXPECT_EQ(solver_name(model), result);
  }
}

/// Text of the expression that `build` makes of three inputs.
template <class Build>
std::string expression(Build build) {
  const Phrase a{"a"}, b{"b"}, c{"c"};
  return build(a, b, c).text;
}

TEST(EmittedExpressions, haveTheParenthesesTheyNeed) {
  const auto op = [](Op o, const Phrase& x, const Phrase& y = {}, const Phrase& z = {}) {
    return operation_phrase(Scalar::doubles, o, x, y, z);
  };
  using P = const Phrase&;
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::add, op(Op::add, a, b), c); }), "a + b + c");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::add, a, op(Op::add, b, c)); }), "a + (b + c)");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::subtract, a, op(Op::subtract, b, c)); }), "a - (b - c)");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::subtract, a, op(Op::multiply, b, c)); }), "a - b*c");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::multiply, op(Op::add, a, b), c); }), "(a + b)*c");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::divide, op(Op::divide, a, b), c); }), "a/b/c");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::divide, a, op(Op::multiply, b, c)); }), "a/(b*c)");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::multiply, a, op(Op::divide, b, c)); }), "a*(b/c)");
  EXPECT_EQ(expression([&](P a, P b, P) { return op(Op::subtract, a, op(Op::negate, b)); }), "a + b");
  EXPECT_EQ(expression([&](P a, P b, P) { return op(Op::negate, op(Op::multiply, a, b)); }), "-(a*b)");
  EXPECT_EQ(expression([&](P a, P, P) { return op(Op::negate, op(Op::negate, a)); }), "-(-a)");
  EXPECT_EQ(expression([&](P a, P b, P) { return op(Op::multiply, op(Op::negate, a), b); }), "-a*b");
  EXPECT_EQ(expression([&](P a, P, P) { return op(Op::multiply, a, constant_phrase("-2.5")); }), "a*(-2.5)");
  EXPECT_EQ(expression([&](P a, P, P) { return op(Op::add, constant_phrase("-2.5"), a); }), "a - 2.5");
  EXPECT_EQ(expression([&](P, P, P) { return constant_phrase("-2.5"); }), "-2.5");
  EXPECT_EQ(expression([&](P a, P b, P c) { return op(Op::select, op(Op::subtract, a, b), b, c); }),
            "(a - b >= 0.0 ? b : c)");
  EXPECT_EQ(expression([&](P a, P b, P) { return op(Op::sqrt, op(Op::min, a, b)); }), "std::sqrt(mbgen::min(a, b))");
  EXPECT_EQ(expression([&](P a, P, P) { return op(Op::subtract, a, constant_phrase("-2.5")); }), "a + 2.5");
  const auto on = [](Scalar scalar, Op o) { return operation_phrase(scalar, o, {"a"}, {"b"}, {"c"}).text; };
  EXPECT_EQ(on(Scalar::floats, Op::select), "(a >= 0.0f ? b : c)");
  EXPECT_EQ(on(Scalar::lanes, Op::select), "mbgen::select(a, b, c)");
  EXPECT_EQ(on(Scalar::lanes, Op::sqrt), "mbgen::sqrt(a)");
}

// The reading copy has one sign a term; the values are the same to the bit.
TEST(EmittedExpressions, haveOneSignATermForPeople) {
  const auto text = [](Op op, const Phrase& x, const Phrase& y) {
    return phrase_for_people(Scalar::doubles, op, x, y, {});
  };
  const Phrase p = constant_phrase("-p"), q = constant_phrase("-q"), a{"a"}, c{"c"};
  const Phrase minus_pa = text(Op::multiply, p, a), minus_qc = text(Op::multiply, q, c);
  EXPECT_EQ(minus_pa.text, "-p*a");
  EXPECT_EQ(text(Op::multiply, a, p).text, "-a*p");
  EXPECT_EQ(text(Op::multiply, p, q).text, "p*q");
  EXPECT_EQ(text(Op::multiply, minus_pa, q).text, "p*a*q");
  EXPECT_EQ(text(Op::multiply, text(Op::add, a, c), p).text, "-(a + c)*p");
  EXPECT_EQ(text(Op::subtract, c, minus_pa).text, "c + p*a");
  EXPECT_EQ(text(Op::add, c, minus_pa).text, "c - p*a");
  EXPECT_EQ(text(Op::add, minus_pa, c).text, "c - p*a");
  EXPECT_EQ(text(Op::subtract, minus_pa, minus_qc).text, "q*c - p*a");
  EXPECT_EQ(text(Op::add, minus_pa, minus_qc).text, "-p*a - q*c");
  EXPECT_EQ(text(Op::subtract, minus_pa, c).text, "-p*a - c");
}

TEST(EmittedNames, OfMembersAreWords) {
  EXPECT_EQ(word_of_member("zdd[Coordinate::crank_pin]"), "zdd_crank_pin");
  EXPECT_EQ(word_of_member("Jz[12]"), "Jz_12");
  EXPECT_EQ(word_of_member("kinetic_energy"), "kinetic_energy");
}

TEST(EmittedExpressions, takeSignsOfOperandsIn) {
  const auto text = [](Op op, const Phrase& x, const Phrase& y, const Phrase& z = {}) {
    return operation_phrase(Scalar::doubles, op, x, y, z).text;
  };
  const Phrase p = constant_phrase("-p"), q = constant_phrase("-q"), a{"a"}, c{"c"};
  EXPECT_EQ(text(Op::add, a, p), "a - p");
  EXPECT_EQ(text(Op::add, p, a), "a - p");
  EXPECT_EQ(text(Op::add, p, q), "-p - q");
  EXPECT_EQ(text(Op::subtract, p, a), "-p - a");
  EXPECT_EQ(text(Op::multiply_add, p, a, c), "fnma(p, a, c)");
  EXPECT_EQ(text(Op::multiply_add, a, p, q), "fnma(a, p, -q)");
  EXPECT_EQ(text(Op::multiply_add, p, q, c), "fma(p, q, c)");
  EXPECT_EQ(text(Op::multiply_add, a, c, q), "fms(a, c, q)");
  EXPECT_EQ(text(Op::multiply_subtract, p, a, q), "fma(-p, a, q)");
  EXPECT_EQ(text(Op::subtract_product, c, p, a), "fma(p, a, c)");
  EXPECT_EQ(text(Op::subtract_product, q, p, a), "fma(p, a, -q)");
}

}  // namespace
}  // namespace mbgen::test
