#include "workbench/host/message.hpp"

#include <cstdio>

#include "compiler/text/characters.hpp"

namespace mbgen {

void print_plain(std::string_view text) { print_styled(terminal_text(text)); }

void print_styled(std::string_view text) {
  // A failure cannot be reported anywhere.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
  static_cast<void>(std::fflush(stderr));
}

}  // namespace mbgen
