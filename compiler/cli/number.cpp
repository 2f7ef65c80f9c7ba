#include "compiler/cli/number.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "compiler/cli/user_error.hpp"

namespace mbgen::cli {

double parse_number(const std::string& text, const std::string& what) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw UserError(fmt::format("{}: \"{}\" is not a finite number\n", what, text));
  }
  return value;
}

}  // namespace mbgen::cli
