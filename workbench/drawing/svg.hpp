#pragma once
// Pieces of SVG text.

#include <string>
#include <string_view>

namespace mbgen::svg {

/// A number with at most two decimals, none where it is whole: enough for pixels.
std::string number(double value);

/// <text> at a place; attributes: further ones, with a blank in front.
std::string text_at(double x, double y, std::string_view text, std::string_view attributes = {});

/// Width of a text of a sans-serif font, px: an estimate from above for letters as names have them.
double text_width(std::string_view text, double font_size);

}  // namespace mbgen::svg
