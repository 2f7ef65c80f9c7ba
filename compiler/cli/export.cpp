// mbgen export: a Functional Mock-up Unit.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "compiler/cli/commands.hpp"
#include "compiler/cli/depfile.hpp"
#include "compiler/cli/files.hpp"
#include "compiler/cli/host_compiler.hpp"
#include "compiler/cli/initial_state.hpp"
#include "compiler/cli/json_text.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/cli/own_directory.hpp"
#include "compiler/cli/user_error.hpp"
#include "compiler/cli/zip_archive.hpp"
#include "compiler/compile.hpp"

namespace mbgen::cli {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
// Of the processors since 2013: with the same rounded products as the solver has on this machine.
constexpr const char* kProcessor = "-march=x86-64-v3";
constexpr const char* kDirectory[] = {"linux64", "x86_64-linux"};
#else
constexpr const char* kProcessor = "";
constexpr const char* kDirectory[] = {"aarch64-linux", "aarch64-linux"};
#endif

struct ExportOptions {
  std::string model, form, file, depfile;
  int version = 0;
  bool sources_only = false, json = false;
};

/// Where every entry of the archive says that it was last changed.
constexpr const char* kTimeOfEntries = "--mtime=2000-01-01 00:00:00 UTC";

/// Permissions of entries, whatever the user's mask is.
constexpr fs::perms kReadable =
    fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read;

void write_sources(const fs::path& directory, const std::vector<EmittedFile>& files) {
  std::vector<NamedText> texts;
  for (const EmittedFile& file : files) texts.push_back({file.path, file.text});
  write_files(directory, texts);
  for (const EmittedFile& file : files) fs::permissions(directory / file.path, kReadable);
}

/// Compiles the sources into a library that exports the functions of FMI and imports none but libm's.
void compile_library(const fs::path& scratch, const fs::path& content, const FmuFiles& files, const fs::path& library) {
  const fs::path exported = scratch / "bare" / "exported";
  HostCompiler compiler = find_compiler(scratch, kProcessor, 0);
  compiler.flags.insert(compiler.flags.end(),
                        {"-fPIC", "-fvisibility=hidden", "-fno-stack-protector", "-DFMI2_OVERRIDE_FUNCTION_PREFIX"});
  write_sources(scratch / "include", files.headers);
  write_sources(scratch / "bare", {files.bare, {exported.filename(), "{ global: fmi[23]*; local: *; };\n"}});
  std::vector<fs::path> sources = {scratch / "bare" / files.bare.path};
  for (const std::string& source : files.sources) sources.push_back(content / "sources" / source);
  std::vector<Command> compilations;
  Command link{compiler.words, scratch / "link.log"};
  link.arguments.insert(link.arguments.end(),
                        {"-shared", "-nostartfiles", "-nodefaultlibs", "-Wl,--no-undefined", "-Wl,--build-id=none",
                         "-Wl,--version-script=" + exported.string(), "-s", "-o", library.string()});
  for (const fs::path& source : sources) {
    const std::string object = (scratch / source.filename()).string() + ".o";
    Command compilation{compilation_of(compiler, {content / "sources", scratch / "include"}), object + ".log"};
    compilation.arguments.insert(compilation.arguments.end(), {"-c", source.string(), "-o", object});
    if (source.filename() == files.large) compilation.arguments.push_back("-O1");
    compilations.push_back(std::move(compilation));
    link.arguments.push_back(object);
  }
  link.arguments.insert(link.arguments.end(), {"-Wl,--as-needed", "-lm", "-lgcc"});
  run_all(compilations);
  run_all({link});
  fs::permissions(library, kReadable | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec);
}

/// A zip archive of these entries: the same bytes for the same files, whenever it is made.
void pack(const fs::path& scratch, const fs::path& content, std::vector<std::string> entries, const fs::path& archive) {
  std::sort(entries.begin(), entries.end());
  Command tar{{"cmake", "-E", "env", "TZ=UTC", "cmake", "-E", "chdir", content.string(), "cmake", "-E", "tar", "cf",
               archive.string(), "--format=zip", kTimeOfEntries, "--"},
              scratch / "zip.log"};
  tar.arguments.insert(tar.arguments.end(), entries.begin(), entries.end());
  if (run_side_by_side({tar})[0] == 0) return;
  throw UserError(fmt::format("export: cmake does not pack the FMU; install it (apt-get install cmake)\n{}",
                              read_text(scratch / "zip.log")));
}

int run(const ExportOptions& options) {
  const Compilation compilation = expect(compile(options.model, chosen_form(options.form)));
  require_other_file(options.file, compilation.model.files);
  const FmiVersion version = options.version == 2 ? FmiVersion::two : FmiVersion::three;
  const FmuFiles files = emit_fmu(compilation, default_initial_state(compilation), version);

  AtomicFile file(options.file);
  std::optional<AtomicFile> depfile = depfile_of(options.depfile, options.file, compilation.model.files);
  const TemporaryDirectory scratch(temporary_parent());
  const fs::path content = scratch.path() / "content";
  write_sources(content, files.packed);
  std::vector<std::string> entries;
  for (const EmittedFile& packed : files.packed) entries.push_back(packed.path);
  if (!options.sources_only) {
    const fs::path binary =
        fs::path("binaries") / kDirectory[options.version == 2 ? 0 : 1] / (files.identifier + ".so");
    fs::create_directories((content / binary).parent_path());
    compile_library(scratch.path(), content, files, content / binary);
    entries.push_back(binary.string());
  }
  pack(scratch.path(), content, entries, scratch.path() / "packed.zip");
  file.write(without_circumstances(read_text(scratch.path() / "packed.zip")));
  file.close();
  if (depfile) depfile->commit();
  file.commit();
  if (options.json) {
    print(json_text({{"model", compilation.model.name}, {"fmi", options.version}, {"file", options.file}}));
  } else {
    print(options.file + "\n");
  }
  return kDone;
}

}  // namespace

void add_export(CLI::App& application, int& exit_code) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = application.add_subcommand("export", "write a Functional Mock-up Unit of a model");
  command->footer(
      "Example: mbgen export models/coach_rig.json --fmi 3 -o coach_rig.fmu\n"
      "The unit has co-simulation and model exchange, a library for this kind of machine, and its sources.");
  add_model_argument(*command, options->model);
  command->add_option("--fmi", options->version, "version of the Functional Mock-up Interface: 2 or 3")
      ->required()
      ->check(CLI::IsMember(std::vector<int>{2, 3}));
  command->add_option("-o,--out", options->file, "the FMU")->required();
  command->add_flag("--sources-only", options->sources_only, "leave the library out; needs no compiler");
  add_depfile_option(*command, options->depfile);
  add_form_option(*command, options->form);
  add_json_option(*command, options->json);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
