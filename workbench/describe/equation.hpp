#pragma once
// Quantities in the reading copy of a solver by name, by part of the model and by words.

#include <map>
#include <string>
#include <vector>

namespace mbgen {

/// The lines of a quantity with the meaning of its name; for the name of a body, coordinate, loop or element: its
/// quantities; for other words: the quantities that fit them. file: name of the text; parts: see part_words. Fails:
/// UserError with the nearest name for a quantity that the text does not have.
std::string equation_text(const std::string& file, const std::string& text, const std::string& wanted,
                          const std::map<std::string, std::string>& parts = {});

}  // namespace mbgen
