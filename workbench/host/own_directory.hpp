#pragma once
// Directories whose files are linked, loaded or run: only the user may put something there.

#include <filesystem>
#include <string>

namespace mbgen {

/// Why somebody else could put files into a directory or put another in its place; "" when nobody can but the user and
/// the administrator. Every directory and symbolic link on the way from / has to belong to one of them; a directory
/// that others may write has to be sticky, and below one that is, only what the user owns counts.
/// may_be_shared: whether the directory itself may be one that others write, as /tmp is, for the sake of a new
/// directory in it; else it has to be the user's own. Requires: it exists.
std::string foreign_hand(const std::filesystem::path& directory, bool may_be_shared);

/// ${XDG_CACHE_HOME:-~/.cache}/mbgen, made with mode 0700: files that mbgen makes once and loads again. "" when it
/// cannot be used; unless no such place is named, a line on standard error says why and what to do, if `tells`.
std::filesystem::path own_cache(bool tells = true);

/// Whether a file of the cache is a plain file of the user that nobody else can write.
bool is_own_file(const std::filesystem::path& file);

/// Where temporary directories are made: $TMPDIR, or /tmp. Fails: UserError when there is no such directory.
std::filesystem::path temporary_parent();

}  // namespace mbgen
