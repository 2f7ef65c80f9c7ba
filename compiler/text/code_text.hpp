#pragma once
// C++ text as its compiler sees it.

#include <string>
#include <string_view>

namespace mbgen {

/// C++ text without comments, and without blanks at the ends of lines and lines of blanks alone. Two texts with the
/// same result compile to the same object, as long as they do not ask for their lines (__LINE__, debugging).
std::string code_without_comments(std::string_view text);

}  // namespace mbgen
