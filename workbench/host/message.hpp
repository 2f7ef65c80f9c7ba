#pragma once
// Messages on standard error.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace mbgen {

/// Writes a text to standard error unchanged, including escape sequences for colours and for rewritten lines. Requires:
/// terminal_text for all text from outside. A closed or full standard error is ignored.
void print_styled(std::string_view text);

/// Writes a plain text; control characters of terminals are shown as `?` (terminal_text).
void print_plain(std::string_view text);

/// The first line of a message: the reason, without its hints.
inline std::string first_line(const std::string& message) { return message.substr(0, message.find('\n')); }

/// print_plain of a formatted text.
template <class... Values>
void print_message(fmt::format_string<Values...> format, Values&&... values) {
  print_plain(fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace mbgen
