#pragma once
// Pieces of text that every emitted file is made of.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/emit/scalar.hpp"

namespace mbgen {

/// Width that emitted lines keep to.
constexpr std::size_t kLineWidth = 100;

/// Shortest C++ literal that reads back as the same double, always with a decimal point or an exponent: 1.0, 0.1,
/// 1e-07. Negative ones without parentheses. Infinities and NaN become <cmath> expressions.
std::string number_text(double value);

/// The same as a literal of a scalar type: of floats the shortest that reads back as the nearest float, 0.1f, else as
/// above.
std::string number_text(double value, Scalar scalar);

/// A number, "" for none.
std::string number_or_none(const std::optional<double>& number);

/// Size of a member array: C++ has no empty ones.
std::string size_text(int size);

/// String literal with everything escaped that C++ would read otherwise, or people: bytes that are no UTF-8, trigraphs,
/// controls of the direction of writing.
std::string string_literal(std::string_view text);

/// Text on one line for a comment: control characters and bytes that are no UTF-8 become spaces, and a backslash at the
/// end is followed by a full stop.
std::string comment_text(std::string_view text);

/// All texts, with a separator between them.
std::string joined(const std::vector<std::string>& texts, std::string_view separator);

/// Lines of `indent` spaces and items joined by ", ", broken before kLineWidth. Ends without a newline.
std::string wrapped_list(const std::vector<std::string>& items, std::size_t indent);

/// `head`, the items in braces and `tail`: on one line where it fits, else the items on lines of their own.
std::string braced_list(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

/// Declaration of an array: `head[] = {items};`, no newline. The filler where there are none: C++ has no arrays of size
/// zero.
std::string array_text(const std::string& head, std::vector<std::string> items, const std::string& filler);

/// Numbers as literals of a scalar type.
std::vector<std::string> number_texts(const std::vector<double>& values, Scalar scalar = Scalar::doubles);

/// Places of the members of a struct, for an array of pointers to them: "&Inputs::torque".
std::vector<std::string> member_places(const std::string& structure, const std::vector<std::string>& members);

/// One statement broken at commas and spaces so that lines keep to kLineWidth where they can; later lines are indented
/// by four more.
std::string wrapped_statement(const std::string& line);

/// Words on lines that each begin with `margin` and keep to kLineWidth: "/// " for comments, spaces for lists.
std::string wrapped_words(const std::string& words, const std::string& margin);

}  // namespace mbgen
