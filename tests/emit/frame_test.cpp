// Frames: names, sections, rows, lines of tags, and what is refused.

#include "compiler/emit/frame.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "compiler/emit/mapped.hpp"

namespace mbgen::test {
namespace {

std::string error_of(std::string_view frame, const FrameValues& values) {
  try {
    fill_frame("frame", frame, values);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

TEST(Frames, fillEveryNameAndNothingElse) {
  EXPECT_EQ(fill_frame("frame", "{{a}}-{{b}}{{a}}{}", {{"a", "1"}, {"b", "{{c}}"}}), "1-{{c}}1{}");
  EXPECT_EQ(error_of("x {{a}}", {}), "frame: no value for {{a}}");
  EXPECT_EQ(error_of("x", {{"b", ""}}), "frame: {{b}} is not used");
  EXPECT_EQ(error_of("x {{a", {{"a", ""}}), "frame: {{ without }}");
}

TEST(Frames, keepSectionsByTheirValues) {
  const std::string frame = "a{{#b}}-{{b}}{{^c}}!{{/c}}{{/b}}{{^b}}+{{c}}{{/b}}.";
  EXPECT_EQ(fill_frame("frame", frame, {{"b", "1"}, {"c", ""}}), "a-1!.");
  EXPECT_EQ(fill_frame("frame", frame, {{"b", "1"}, {"c", "2"}}), "a-1.");
  EXPECT_EQ(fill_frame("frame", frame, {{"b", ""}, {"c", "2"}}), "a+2.");
  EXPECT_EQ(error_of("{{#b}}x", {{"b", "1"}}), "frame: {{#b}} without its end");
  EXPECT_EQ(error_of("x{{/b}}", {{"b", "1"}}), "frame: {{/b}} ends no section");
  EXPECT_EQ(error_of("{{#b}}{{c}}{{/b}}", {{"b", ""}}), "frame: no value for {{c}}");
}

TEST(Frames, repeatSectionsForTheirRows) {
  const FrameRows bodies = {{{"name", "rod"}, {"points", FrameRows{{{"at", 1}}, {{"at", 2}}}}},
                            {{"name", "bob"}, {"points", FrameRows{}}}};
  const std::string frame =
      "{{#bodies}}{{name}} of {{model}}:{{#points}} {{at}}{{/points}}{{^points}} -{{/points}}. {{/bodies}}";
  EXPECT_EQ(fill_frame("frame", frame, {{"bodies", bodies}, {"model", "swing"}}),
            "rod of swing: 1 2. bob of swing: -. ");
  EXPECT_EQ(fill_frame("frame", frame, {{"bodies", FrameRows{}}, {"model", "swing"}}), "");
}

TEST(Frames, showTheNameOfARowBeforeOneAroundIt) {
  const FrameRows rows = mapped(std::vector<int>{1, 2}, [](int number) { return FrameValues{{"name", number}}; });
  EXPECT_EQ(fill_frame("frame", "{{name}}{{#rows}}{{name}}{{/rows}}", {{"name", "a"}, {"rows", rows}}), "a12");
}

TEST(Frames, breakStatementsThatAreTooLong) {
  const std::string name(60, 'x');
  EXPECT_EQ(fill_frame("frame", "{{~rows}}\n  a.{{x}} = b.{{x}};\n{{/rows}}\n",
                       {{"rows", FrameRows{{{"x", name}}, {{"x", "y"}}}}}),
            "  a." + name + " =\n      b." + name + ";\n  a.y = b.y;\n");
}

TEST(Frames, refuseRowsThatDoNotFit) {
  const FrameRows rows = {{{"a", "1"}, {"b", "2"}}};
  EXPECT_EQ(error_of("{{#rows}}{{a}}{{/rows}}", {{"rows", rows}}), "frame: {{b}} is not used");
  EXPECT_EQ(error_of("{{#rows}}{{a}}{{/rows}}{{#rows}}{{b}}{{/rows}}", {{"rows", rows}}), "");
  EXPECT_EQ(error_of("{{#rows}}{{a}}{{b}}{{c}}{{/rows}}", {{"rows", rows}}), "frame: no value for {{c}}");
  EXPECT_EQ(error_of("{{rows}}", {{"rows", rows}}), "frame: {{rows}} is no text");
  EXPECT_EQ(error_of("{{#rows}}{{#a}}{{/rows}}{{/a}}", {{"rows", rows}}), "frame: {{#a}} without its end");
}

TEST(Frames, dropLinesThatHoldTagsOfSectionsAlone) {
  const std::string frame = "{{#b}}\n{{#c}}{{^d}}\nx {{d}}\n{{/d}}{{/c}}\n{{/b}}\n{{#c}}y{{/c}}\n{{d}}\n";
  EXPECT_EQ(fill_frame("frame", frame, {{"b", true}, {"c", true}, {"d", ""}}), "x \ny\n\n");
  EXPECT_EQ(fill_frame("frame", frame, {{"b", false}, {"c", true}, {"d", "z"}}), "y\nz\n");
}

TEST(Frames, holdOtherFrames) {
  EXPECT_EQ(
      fill_frame("frame", "a\n{{>tuned.in}}\nb",
                 {{"derived", ""}, {"constructs", false}, {"tuned_comment", ""}, {"scalar", "double"}}),
      "a\n/// Argument type of the functions: no constants follow from the parameters.\nusing Tuned = Parameters;\nb");
  EXPECT_EQ(error_of("{{>no_such.in}}", {}), "templates/no_such.in: not embedded");
}

}  // namespace
}  // namespace mbgen::test
