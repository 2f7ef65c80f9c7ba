#pragma once
// C++ text as its compiler sees it.

#include <cstddef>
#include <string>
#include <string_view>

namespace mbgen {

/// Position behind the comment that begins at `at`, the end of its line excluded; `at` where none begins there.
std::size_t end_of_comment(std::string_view text, std::size_t at);

/// Position behind the literal whose quotation mark is at `at`; `at` where none begins there.
std::size_t end_of_literal(std::string_view text, std::size_t at);

/// C++ text without comments, and without blanks at the ends of lines and lines of blanks alone. Two texts with the
/// same result compile to the same object, as long as they do not ask for their lines (__LINE__, debugging).
std::string code_without_comments(std::string_view text);

}  // namespace mbgen
