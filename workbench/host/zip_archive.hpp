#pragma once
// Zip archives that are the same bytes whenever and by whomever they are made.

#include <string>

namespace mbgen {

/// The archive with nothing in the heads of its entries that tells of the circumstances: times of access and creation
/// become that of modification, owners become 0. `cmake -E tar --mtime` settles the time of modification alone.
/// archive: as cmake writes it, without a comment at its end. Fails: std::runtime_error when it is no such archive.
std::string without_circumstances(std::string archive);

}  // namespace mbgen
