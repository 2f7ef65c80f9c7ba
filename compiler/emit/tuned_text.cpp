#include "compiler/emit/tuned_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/layout.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {

std::string tuned_type_text(const Programs& programs, const std::string& scalar) {
  const int count = derived_constant_count(programs);
  if (count == 0)
    return "/// What functions take: no constants follow from the parameters.\nusing Tuned = Parameters;\n";
  const std::string comment = wrapped_words(
      fmt::format("Tunable parameters with the {} constants that follow from them. Functions take plain Parameters as "
                  "well, and then work these out each time: keep one of these, and assign Parameters to it where they "
                  "change, at the boundary of a step.",
                  count),
      "/// ");
  return fmt::format(
      "{}\nstruct Tuned : Parameters {{\n  {} derived[{}];\n  Tuned() noexcept : Tuned(Parameters{{}}) {{}}\n"
      "  Tuned(const Parameters& parameters) noexcept;\n}};\n",
      comment, scalar, count);
}

std::string tuned_constructor_text(const Programs& programs) {
  if (derived_constant_count(programs) == 0) return "";
  return "Tuned::Tuned(const Parameters& parameters) noexcept : Parameters(parameters) {\n"
         "  compute_derived_constants(parameters, *this);\n}\n\n";
}

}  // namespace mbgen
