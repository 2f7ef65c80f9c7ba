#include "workbench/engines/fmu_libraries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "workbench/engines/host_compiler.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

// Of the processors since 2013: with the same rounded products as the solver has on this machine.
constexpr const char* kProcessor = "-march=x86-64-v3";

/// Where a library runs. name: FMI 3's, directory: FMI 2's.
struct Platform {
  const char *name, *directory, *suffix, *processor, *compiler, *variable, *package;
};
constexpr Platform kPlatforms[] = {
    {"x86_64-linux", "linux64", ".so", kProcessor, "x86_64-linux-gnu-g++", "CXX_x86_64_linux", "g++-x86-64-linux-gnu"},
    {"aarch64-linux", "aarch64-linux", ".so", "", "aarch64-linux-gnu-g++", "CXX_aarch64_linux",
     "g++-aarch64-linux-gnu"},
    {"x86_64-windows", "win64", ".dll", kProcessor, "x86_64-w64-mingw32-g++", "CXX_x86_64_windows",
     "g++-mingw-w64-x86-64"}};
#if defined(__x86_64__)
constexpr const char* kThisPlatform = "x86_64-linux";
#else
constexpr const char* kThisPlatform = "aarch64-linux";
#endif

/// Permissions of entries, whatever the user's mask is.
constexpr fs::perms kReadable =
    fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read;

HostCompiler compiler_for(const Platform& platform, const fs::path& scratch) {
  if (platform.name == std::string_view(kThisPlatform)) return find_compiler(scratch, platform.processor, 0);
  HostCompiler compiler =
      find_cross_compiler(scratch, {platform.name, platform.compiler, platform.variable, platform.package,
                                    fmt::format("or leave {} out of --platform", platform.name)});
  if (*platform.processor != 0) compiler.flags.emplace_back(platform.processor);
  return compiler;
}

/// Flags that link a library that exports the functions of FMI and imports the functions of the C library alone; of
/// Windows, those of msvcrt.dll and kernel32.dll.
std::vector<std::string> link_flags(const Platform& platform, const fs::path& exported) {
  if (platform.suffix == std::string_view(".dll")) return {"-shared", "-static", "-Wl,--no-insert-timestamp", "-s"};
  return {"-shared",
          "-nostartfiles",
          "-nodefaultlibs",
          "-Wl,--no-undefined",
          "-Wl,--build-id=none",
          "-Wl,--version-script=" + exported.string(),
          "-s"};
}

/// Compiles the sources into a library.
void compile_library(const Platform& platform, const fs::path& scratch, const fs::path& content, const FmuFiles& files,
                     const fs::path& library) {
  const bool is_windows = platform.suffix == std::string_view(".dll");
  const fs::path objects = scratch / platform.name, exported = objects / "exported";
  fs::create_directories(objects);
  HostCompiler compiler = compiler_for(platform, objects);
  compiler.flags.insert(compiler.flags.end(),
                        {"-fvisibility=hidden", "-fno-stack-protector", "-DFMI2_OVERRIDE_FUNCTION_PREFIX"});
  if (!is_windows) compiler.flags.emplace_back("-fPIC");
  write_entries(scratch / "include", files.headers);
  write_entries(objects, {{exported.filename(), "{ global: fmi[23]*; local: *; };\n"}});
  std::vector<Source> sources;
  for (const EmittedFile& file : files.packed) {
    const std::string name = fs::path(file.path).filename();
    if (std::find(files.sources.begin(), files.sources.end(), name) == files.sources.end()) continue;
    sources.push_back({content / file.path, file.rare_parts, name == files.large});
  }
  const std::string product = fmt::format("the unit of {} for {}", files.identifier, platform.name);
  Command link{compiler.words, objects / "link.log", library};
  const std::vector<std::string> flags = link_flags(platform, exported);
  link.arguments.insert(link.arguments.end(), flags.begin(), flags.end());
  link.arguments.insert(link.arguments.end(), {"-o", library.string()});
  for (std::string& object :
       compile_sources(compiler, {content / "sources", scratch / "include"}, sources, objects, product)) {
    link.arguments.push_back(std::move(object));
  }
  if (!is_windows) link.arguments.insert(link.arguments.end(), {"-Wl,--as-needed", "-lm", "-lc", "-lgcc"});
  run_all({link}, product);
  fs::permissions(library, kReadable | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec);
}

}  // namespace

std::vector<std::string> fmu_platforms() {
  std::vector<std::string> names;
  for (const Platform& platform : kPlatforms) names.emplace_back(platform.name);
  return names;
}

std::string fmu_platform_of_this_machine() { return kThisPlatform; }

void write_entries(const fs::path& directory, const std::vector<EmittedFile>& files) {
  std::vector<NamedText> texts;
  for (const EmittedFile& file : files) texts.push_back({file.path, file.text});
  write_files(directory, texts, {});
  for (const EmittedFile& file : files) fs::permissions(directory / file.path, kReadable);
}

std::vector<std::string> compile_fmu_libraries(const FmuFiles& files, FmiVersion version,
                                               const std::vector<std::string>& platforms, const fs::path& content,
                                               const fs::path& scratch) {
  std::vector<std::string> entries;
  for (const Platform& platform : kPlatforms) {
    if (std::find(platforms.begin(), platforms.end(), platform.name) == platforms.end()) continue;
    const fs::path binary = fs::path("binaries") / (version == FmiVersion::two ? platform.directory : platform.name) /
                            (files.identifier + platform.suffix);
    fs::create_directories((content / binary).parent_path());
    compile_library(platform, scratch, content, files, content / binary);
    entries.push_back(binary.string());
  }
  return entries;
}

}  // namespace mbgen
