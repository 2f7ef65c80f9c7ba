#pragma once
// Words for people, on standard error.

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace mbgen {

/// Writes a text to standard error as it is, with its escape sequences, for colours and for lines that are written
/// over. Requires: it has terminal_text of everything that others wrote. A standard error that is closed or full is no
/// fault of the command.
void print_styled(std::string_view text);

/// Writes a plain text: characters that would command a terminal are shown as `?` (terminal_text).
void print_plain(std::string_view text);

/// The same with a format.
template <class... Values>
void print_message(fmt::format_string<Values...> format, Values&&... values) {
  print_plain(fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace mbgen
