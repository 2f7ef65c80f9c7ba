// `mbgen cache`: compiled solvers that are kept.

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/engines/kept_objects.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/own_directory.hpp"

namespace mbgen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMegabyte = 1 << 20;
constexpr double kLargestLimit = 1 << 30;  // MB

struct CacheOptions {
  bool clean = false;
  std::optional<double> limit;  ///< MB
  bool json = false;
};

struct CacheContents {
  std::filesystem::path directory;
  std::vector<KeptObject> objects;
  std::uintmax_t bytes = 0, room = 0;
};

CacheContents contents_of(const std::filesystem::path& cache) {
  CacheContents contents{cache, kept_objects(cache), 0, room_of(cache)};
  for (const KeptObject& object : contents.objects) contents.bytes += object.bytes;
  return contents;
}

/// Local time to the minute.
std::string minute_of(std::chrono::file_clock::time_point time) {
  const auto at = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(time));
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::chrono::system_clock::to_time_t(at)));
}

Json contents_json(const CacheContents& contents) {
  Json solvers = Json::array();
  for (const KeptObject& object : contents.objects)
    solvers.push_back(
        {{"file", object.file.filename().string()}, {"bytes", object.bytes}, {"used", minute_of(object.used)}});
  return {{"directory", contents.directory.string()},
          {"limit", contents.room},
          {"bytes", contents.bytes},
          {"solvers", solvers}};
}

std::string contents_text(const CacheContents& contents) {
  std::string text =
      fmt::format("{}: {} solver{}, {:.1f} MB of at most {:.0f} MB\n", contents.directory.string(),
                  contents.objects.size(), contents.objects.size() == 1 ? "" : "s",
                  static_cast<double>(contents.bytes) / kMegabyte, static_cast<double>(contents.room) / kMegabyte);
  for (const KeptObject& object : contents.objects)
    text += fmt::format("  {}  {:8.2f} MB  {}\n", minute_of(object.used), static_cast<double>(object.bytes) / kMegabyte,
                        object.file.filename().string());
  return text;
}

int run(const CacheOptions& options) {
  if (options.limit && !(*options.limit >= 0 && *options.limit <= kLargestLimit))
    throw UserError(fmt::format("--limit: must be from 0 to {:.0f} MB, found {}\n", kLargestLimit, *options.limit));
  const std::filesystem::path cache = own_cache();
  if (cache.empty()) throw UserError("mbgen cache: no directory is kept; name one in XDG_CACHE_HOME or HOME\n");
  if (options.limit) set_room(cache, static_cast<std::uintmax_t>(*options.limit * kMegabyte));
  make_room(cache, options.clean ? 0 : room_of(cache));
  const CacheContents contents = contents_of(cache);
  print(options.json ? json_text(contents_json(contents)) : contents_text(contents));
  return kDone;
}

}  // namespace

void add_cache(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<CacheOptions>();
  NamedCommand command = application.add_command("cache", "list, limit or remove the compiled solvers that are kept");
  command.footer(
      "Example: mbgen cache --limit 500\n"
      "simulate, sweep, fit, optimise, evaluate and bench keep the solvers that they compile, and load them again as\n"
      "long as the equations stay the same. Beyond the limit the least recently used ones are removed.");
  command.add_option("--limit", options->limit, "megabytes that they may take together from now on (default 1024)");
  command.add_flag("--clean", options->clean, "remove them all");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
