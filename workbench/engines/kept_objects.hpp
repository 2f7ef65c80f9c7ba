#pragma once
// Everything that the cache of compiled solvers holds, and the room that it may take.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mbgen {

/// Bytes that kept solvers may take together unless the user sets another limit.
constexpr std::uintmax_t kUsualRoom = std::uintmax_t{1} << 30;

/// A compiled solver of the cache.
struct KeptObject {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  std::chrono::file_clock::time_point used;  ///< last time that it was made or loaded
};

/// All of them, the one that was used last first.
std::vector<KeptObject> kept_objects(const std::filesystem::path& cache);

/// Marks one as used now.
void mark_used(const std::filesystem::path& object);

/// The limit in bytes, and another one from now on. Fails: UserError where the disk does not take it.
std::uintmax_t room_of(const std::filesystem::path& cache);
void set_room(const std::filesystem::path& cache, std::uintmax_t bytes);

/// Removes the least recently used ones until the others fit `bytes`, with their requests; for no bytes decisions
/// about models, too. Result: how many.
int make_room(const std::filesystem::path& cache, std::uintmax_t bytes);

/// make_room for the limit of the cache; the first time that this removes solvers, a note on standard error says so.
void keep_within_room(const std::filesystem::path& cache);

}  // namespace mbgen
