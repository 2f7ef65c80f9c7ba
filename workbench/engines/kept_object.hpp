#pragma once
// Shared objects that are kept and loaded again by later runs.

#include <filesystem>
#include <optional>
#include <string>

namespace mbgen {

/// Appends size and hash of a shared object to it (the loader maps segments and never reads what lies behind them), and
/// waits until the disk has it. Fails: UserError when the disk does not take it.
void seal(const std::filesystem::path& object);

/// Whether a file is as `seal` left it: a mapped object that a full disk or a crash cut short ends the process by
/// SIGBUS, so it must not reach the loader.
bool is_sealed(const std::filesystem::path& object);

/// A content with the same behind it, for a file.
std::string sealed(std::string content);

/// The content of a file that is whole, nothing of another one.
std::optional<std::string> content_of_sealed(const std::filesystem::path& file);

/// Gives a sealed object its name in the cache, in the place of a damaged one. Result: false, after a note on standard
/// error, where something else has the name.
bool keep(const std::filesystem::path& object, const std::filesystem::path& kept);

}  // namespace mbgen
