#pragma once
// Text helpers of all emitted files.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/emit/scalar.hpp"

namespace mbgen {

/// A member as one word: "zdd_crank_pin" of "zdd[Coordinate::crank_pin]".
std::string word_of_member(const std::string& member);

/// Width of emitted lines.
constexpr std::size_t kLineWidth = 100;

/// Shortest C++ literal that reads back as the same double, always with a decimal point or an exponent: 1.0, 0.1,
/// 1e-07. Negative ones without parentheses. Infinities and NaN become <cmath> expressions.
std::string number_text(double value);

/// The same as a literal of a scalar type: of floats the shortest that reads back as the nearest float, 0.1f.
std::string number_text(double value, Scalar scalar);

/// A number, "" for none.
std::string number_or_none(const std::optional<double>& number);

/// Size of a member array: at least 1, since C++ has no empty arrays.
std::string size_text(int size);

/// String literal that escapes everything that C++, or people, could misread: bytes that are not UTF-8, trigraphs,
/// controls of the writing direction.
std::string string_literal(std::string_view text);

/// Text on one line for a comment: control characters and bytes that are not UTF-8 become spaces, and a full stop
/// follows a final backslash.
std::string comment_text(std::string_view text);

/// All texts, with a separator between them.
std::string joined(const std::vector<std::string>& texts, std::string_view separator);

/// Lines of `indent` spaces and items joined by ", ", broken before kLineWidth. Ends without a newline.
std::string wrapped_list(const std::vector<std::string>& items, std::size_t indent);

/// `head`, the items in braces and `tail`: on one line if it fits, else with the items on separate lines.
std::string braced_list(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

/// Declaration of an array: `head[] = {items};`, no newline. Without items it has the filler: C++ has no arrays of size
/// zero.
std::string array_text(const std::string& head, std::vector<std::string> items, const std::string& filler);

/// Numbers as literals of a scalar type.
std::vector<std::string> number_texts(const std::vector<double>& values, Scalar scalar = Scalar::doubles);

/// Places of the members of a struct, for an array of pointers to them: "&Inputs::torque".
std::vector<std::string> member_places(const std::string& structure, const std::vector<std::string>& members);

/// One statement broken at commas and spaces to lines of at most kLineWidth where possible; later lines are indented by
/// four more.
std::string wrapped_statement(const std::string& line);

/// Words on lines that begin with `margin` and have at most kLineWidth: "/// " for comments, spaces for lists.
std::string wrapped_words(const std::string& words, const std::string& margin);

}  // namespace mbgen
