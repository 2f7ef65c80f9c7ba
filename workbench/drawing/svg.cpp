#include "workbench/drawing/svg.hpp"

#include <fmt/format.h>

#include "compiler/text/characters.hpp"

namespace mbgen::svg {

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string text_at(double x, double y, std::string_view text, std::string_view attributes) {
  return fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", number(x), number(y), attributes, xml_text(text));
}

double text_width(std::string_view text, double font_size) {
  constexpr double kLetter = 0.58;  // of the font's size, mean of names in DejaVu Sans and Arial
  return kLetter * font_size * static_cast<double>(text.size());
}

}  // namespace mbgen::svg
