#include "workbench/engines/kept_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "compiler/text/user_error.hpp"
#include "workbench/engines/kept_request.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/own_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLimitFile = "limit";

bool write_limit(const fs::path& cache, std::uintmax_t bytes) {
  std::ofstream file(cache / kLimitFile, std::ios::trunc);
  file << bytes << '\n';
  file.close();
  return !file.fail();
}

}  // namespace

std::vector<KeptObject> kept_objects(const fs::path& cache) {
  std::vector<KeptObject> objects;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, problem)) {
    if (entry.path().extension() != ".so" || !is_own_file(entry.path())) continue;
    KeptObject object{entry.path(), entry.file_size(problem), entry.last_write_time(problem)};
    if (!problem) objects.push_back(std::move(object));
  }
  std::sort(objects.begin(), objects.end(), [](const KeptObject& a, const KeptObject& b) {
    return a.used != b.used ? a.used > b.used : a.file < b.file;
  });
  return objects;
}

void mark_used(const fs::path& object) {
  std::error_code ignored;
  fs::last_write_time(object, std::chrono::file_clock::now(), ignored);
}

std::uintmax_t room_of(const fs::path& cache) {
  std::uintmax_t bytes = 0;
  return std::ifstream(cache / kLimitFile) >> bytes ? bytes : kUsualRoom;
}

void set_room(const fs::path& cache, std::uintmax_t bytes) {
  if (write_limit(cache, bytes)) return;
  throw UserError(fmt::format("{}: cannot write: {}\n", (cache / kLimitFile).string(), std::strerror(errno)));
}

int make_room(const fs::path& cache, std::uintmax_t bytes) {
  std::uintmax_t together = 0;
  int removed = 0;
  std::error_code ignored;
  for (const KeptObject& object : kept_objects(cache)) {
    together += object.bytes;
    if (together > bytes && fs::remove(object.file, ignored)) ++removed;
  }
  if (removed > 0) forget_requests(cache);
  if (bytes == 0) keep_newest(cache, kEndingOfDecisions, 0);
  return removed;
}

void keep_within_room(const fs::path& cache) {
  const std::uintmax_t room = room_of(cache);
  const int removed = make_room(cache, room);
  std::error_code problem;
  if (removed == 0 || fs::exists(cache / kLimitFile, problem)) return;
  write_limit(cache, room);
  print_message(
      "{}: note: the least recently used {} made room: compiled solvers take {} MB at most\n"
      "  hint: mbgen cache lists them, mbgen cache --limit sets another size; this is said once\n",
      cache.string(), removed == 1 ? "solver" : fmt::format("{} solvers", removed), room >> 20);
}

}  // namespace mbgen
