#include "workbench/engines/kept_request.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

#include "compiler/text/hash.hpp"
#include "workbench/describe/dump_model.hpp"
#include "workbench/host/own_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".request", kRegular = "_regular";
constexpr std::size_t kLongestName = 255;
constexpr std::size_t kMostRequests = 4096;  // of a block of the disk each: a long sweep has one for every case

/// The object that a file of a request names, nothing where it names none of the cache.
std::optional<fs::path> object_in(const fs::path& cache, const fs::path& file) {
  if (!is_own_file(file)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::string name(kLongestName, '\0');
  stream.read(name.data(), static_cast<std::streamsize>(name.size()));
  name.resize(static_cast<std::size_t>(stream.gcount()));
  const fs::path object = cache / name;
  if (name.empty() || object.parent_path() != cache || object.extension() != ".so") return std::nullopt;
  return object;
}

fs::path file_of(const fs::path& cache, const std::string& request) { return cache / (request + std::string(kEnding)); }

}  // namespace

std::string this_program() {
  struct stat facts {};
  if (::stat("/proc/self/exe", &facts) != 0) return "";
  return fmt::format("{} {}.{:09}", facts.st_size, facts.st_mtim.tv_sec, facts.st_mtim.tv_nsec);
}

void keep_newest(const fs::path& cache, std::string_view ending, std::size_t most) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, problem))
    if (entry.path().extension() == ending) files.emplace_back(entry.last_write_time(problem), entry.path());
  if (files.size() <= most) return;
  std::sort(files.begin(), files.end(), std::greater());
  for (std::size_t i = most; i < files.size(); ++i) fs::remove(files[i].second, problem);
}

std::string request_of(const Compilation& decided, const EngineChoice& choice, const HostCompiler& compiler) {
  const Model& model = decided.model;
  const bool is_regular = choice.use == SolverUse::regular;
  const SolverUse use = is_regular ? SolverUse::running : choice.use;
  Hash hash;
  for (const std::string& text :
       {this_program(), model.name, model.hash, dump_model(model),
        std::string(name_of(written_form(decided, choice.form))),
        fmt::format("{} {} {}", static_cast<int>(model.solver.integrator), choice.lanes, static_cast<int>(use)),
        key_of(compiler)})
    hash.add(text);
  return is_regular ? hash.text() + std::string(kRegular) : hash.text();
}

std::string request_of_whole(const std::string& request) {
  return request.ends_with(kRegular) ? request.substr(0, request.size() - kRegular.size()) : request;
}

std::optional<fs::path> object_of_request(const fs::path& cache, const std::string& request) {
  return object_in(cache, file_of(cache, request));
}

void remember_request(const fs::path& cache, const fs::path& scratch, const std::string& request,
                      const fs::path& object) {
  const fs::path written = scratch / "request";
  std::ofstream stream(written, std::ios::binary);
  stream << object.filename().string();
  stream.close();
  std::error_code problem;
  if (!stream) return;
  fs::permissions(written, fs::perms::owner_read | fs::perms::owner_write, problem);
  fs::rename(written, file_of(cache, request), problem);
  keep_newest(cache, kEnding, kMostRequests);
}

void forget_requests(const fs::path& cache) {
  std::vector<fs::path> forgotten;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, problem)) {
    if (entry.path().extension() != kEnding) continue;
    const std::optional<fs::path> object = object_in(cache, entry.path());
    if (!object || !fs::exists(*object, problem)) forgotten.push_back(entry.path());
  }
  for (const fs::path& file : forgotten) fs::remove(file, problem);
}

}  // namespace mbgen
