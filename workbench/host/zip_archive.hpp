#pragma once
// Zip archives that are the same bytes whenever and by whomever they are made.

#include <string>

namespace mbgen {

/// The archive without traces of its making in the heads of its entries: times of access and creation become the time
/// of modification, owners become 0. `cmake -E tar --mtime` sets only the time of modification. archive: as cmake
/// writes it, without a comment at its end. Fails: std::runtime_error for anything else.
std::string without_circumstances(std::string archive);

}  // namespace mbgen
