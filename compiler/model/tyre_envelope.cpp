// Enveloping contacts of tyres: how many places their cams look at, and their words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/elements/tyre.hpp"

namespace mbgen {

int TyreEnvelope::last_sample() const {
  constexpr double kAtEnd = 1e-9;  // a cam does not reach below its own end, but below its middle always
  return static_cast<int>(std::max(std::ceil((0.5 * base + length) / spacing() - kAtEnd) - 1, steps));
}

std::string to_text(const TyreEnvelope& envelope) {
  return fmt::format(
      "enveloping, cams {:.6g} apart, half axes {:.6g} along and {:.6g} up, order {:.6g}, width {:.6g} of "
      "the radius, {} places across two rows",
      envelope.base, envelope.length, envelope.height, envelope.order, envelope.width,
      2 * (2 * envelope.last_sample() + 1));
}

}  // namespace mbgen
