#include "workbench/results/faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace mbgen {

Diagnostic table_fault(const std::string& file, int line, std::string message, std::string hint) {
  Diagnostic diagnostic;
  diagnostic.where.file = file;
  diagnostic.where.line = line;
  diagnostic.where.column = line > 0 ? 1 : 0;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  return diagnostic;
}

std::optional<Diagnostic> no_text(std::string_view bytes, const std::string& file, const char* kind) {
  const auto is_control = [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code == 0x7f || (code < ' ' && letter != '\t' && letter != '\n' && letter != '\r');
  };
  const auto first = std::find_if(bytes.begin(), bytes.end(), is_control);
  if (first == bytes.end()) return std::nullopt;
  Diagnostic diagnostic;
  const auto before = std::find(std::make_reverse_iterator(first), bytes.rend(), '\n');
  diagnostic.where.file = file;
  diagnostic.where.line = static_cast<int>(std::count(bytes.begin(), first, '\n')) + 1;
  diagnostic.where.column = static_cast<int>(std::distance(before.base(), first)) + 1;
  diagnostic.message = fmt::format("must be text, found a byte {:#04x}", static_cast<unsigned char>(*first));
  diagnostic.hint = kind;
  return diagnostic;
}

}  // namespace mbgen
