#include "compiler/text/code_text.hpp"

#include <gtest/gtest.h>

namespace mbgen {
namespace {

TEST(CodeText, LosesCommentsAndBlankLines) {
  EXPECT_EQ(code_without_comments("// head\n\nint a;  // one\n/* two\nlines */int b;\t\n\n\n"), "int a;\n int b;\n");
  EXPECT_EQ(code_without_comments("int a;"), code_without_comments("int a; // no end of line"));
}

TEST(CodeText, KeepsWordsThatLookLikeComments) {
  for (const char* code : {"f(\"// no /* comment\");\n", "f(\"\\\" // \");\n", "f('\"', '//');\n", "f(1'000'000);\n",
                           "f(R\"x(\" // )\" /* )x\");\n"})
    EXPECT_EQ(code_without_comments(code), code);
}

TEST(CodeText, TellsCodesApart) {
  EXPECT_NE(code_without_comments("a = b /**/ c;"), code_without_comments("a = bc;"));
  EXPECT_NE(code_without_comments("f(\"a  b\");"), code_without_comments("f(\"a b\");"));
}

TEST(CodeText, EndsWithTheTextWhereSomethingIsLeftOpen) {
  for (const char* code : {"/* open", "\"open", "R\"open", "R\"x(open", "'", "\""})
    EXPECT_NO_THROW(static_cast<void>(code_without_comments(code))) << code;
}

}  // namespace
}  // namespace mbgen
