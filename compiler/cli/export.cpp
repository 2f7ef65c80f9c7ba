// mbgen export: a Functional Mock-up Unit.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "compiler/base/assignments.hpp"
#include "compiler/base/depfile.hpp"
#include "compiler/base/files.hpp"
#include "compiler/base/json_text.hpp"
#include "compiler/base/own_directory.hpp"
#include "compiler/base/user_error.hpp"
#include "compiler/base/zip_archive.hpp"
#include "compiler/cli/commands.hpp"
#include "compiler/cli/options.hpp"
#include "compiler/compile.hpp"
#include "compiler/describe/notes.hpp"
#include "compiler/drawing/drawing.hpp"
#include "compiler/emit/fmu_variables.hpp"
#include "compiler/engines/engine_arguments.hpp"
#include "compiler/engines/host_compiler.hpp"
#include "compiler/study/initial_state.hpp"

namespace mbgen::cli {
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

struct ExportOptions {
  std::string model, form, file, depfile;
  std::vector<std::string> platforms, set;
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
  write_sources(scratch / "include", files.headers);
  write_sources(objects, {{exported.filename(), "{ global: fmi[23]*; local: *; };\n"}});
  std::vector<Source> sources;
  for (const EmittedFile& file : files.packed) {
    const std::string name = fs::path(file.path).filename();
    if (std::find(files.sources.begin(), files.sources.end(), name) == files.sources.end()) continue;
    sources.push_back({content / file.path, file.rare_parts, name == files.large});
  }
  const std::string product = fmt::format("the unit of {} for {}", files.identifier, platform.name);
  Command link{compiler.words, objects / "link.log"};
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

/// Libraries for the platforms that are asked for. Result: their entries of the archive.
std::vector<std::string> compile_libraries(const ExportOptions& options, const fs::path& scratch,
                                           const fs::path& content, const FmuFiles& files) {
  std::vector<std::string> entries;
  for (const Platform& platform : kPlatforms) {
    const auto& asked = options.platforms;
    if (std::find(asked.begin(), asked.end(), platform.name) == asked.end()) continue;
    const fs::path binary = fs::path("binaries") / (options.version == 2 ? platform.directory : platform.name) /
                            (files.identifier + platform.suffix);
    fs::create_directories((content / binary).parent_path());
    compile_library(platform, scratch, content, files, content / binary);
    entries.push_back(binary.string());
  }
  return entries;
}

/// Names the variables that an FMU calls otherwise than the model, since names there are of one list.
Diagnostics renamed_notes(const Model& model) {
  Diagnostics notes;
  const auto note = [&](const auto& one, const std::string& name, const char* kind) {
    if (name == one.name) return;
    notes.push_back(
        {one.where,
         fmt::format("{} \"{}\" is \"{}\" in the FMU, where another variable has that name", kind, one.name, name),
         {},
         {}});
  };
  for (const Parameter& one : model.parameters) {
    if (one.tunable || one.at_start) note(one, fmu_parameter_name(one.name), "parameter");
  }
  for (const Input& one : model.inputs) note(one, fmu_input_name(one.name), "input");
  for (const Output& one : model.outputs) note(one, fmu_output_name(model, one.name), "output");
  return notes;
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

/// Importers integrate states that determine each other's rates; where bodies roll, positions and velocities do not
/// pair.
void note_rolling(const Compilation& compilation) {
  const Loop* rolling = rolling_loop(compilation.topology);
  if (!rolling) return;
  print_notes({{where_of(compilation.model, *rolling),
                fmt::format("the FMU has co-simulation alone, without directional derivatives: {} \"{}\" holds "
                            "velocities alone, so that more positions are free than velocities",
                            name_of(rolling->kind), rolling->name),
                {},
                {}}});
}

/// Start values of an FMU are angles and rates of the model, which a joint in their pole has not.
void refuse_pole(const Compilation& compilation, const InitialState& initial) {
  if (initial.charts.empty()) return;
  const InitialTurning& turning = compilation.model.initial.turnings.front();
  const std::string& joint = compilation.model.joints[static_cast<std::size_t>(turning.joint)].name;
  throw UserError(to_text({{turning.where,
                            fmt::format("no FMU is written: its start values are rates of angles, and those of joint "
                                        "\"{}\" start in their pole",
                                        joint),
                            "give the joint another \"sequence\"",
                            {}}}));
}

int run(const ExportOptions& options) {
  if (is_standard_output(options.file))
    throw UserError("--out: an FMU is no text for standard output, name a file\n  hint: a file of this name is ./-\n");
  const Compilation compilation =
      expect(compile(read_set_model(options.model, options.set), {chosen_form(options.form)}));
  require_other_file(options.file, compilation.model.files);
  print_notes(compilation.model.notes);
  print_notes(renamed_notes(compilation.model));
  note_rolling(compilation);
  const FmiVersion version = options.version == 2 ? FmiVersion::two : FmiVersion::three;
  const InitialState initial = default_initial_state(compilation);
  refuse_pole(compilation, initial);
  const FmuFiles files = emit_fmu(compilation, initial, version);

  AtomicFile file(options.file);
  std::optional<AtomicFile> depfile = depfile_of(options.depfile, options.file, compilation.model.files);
  const TemporaryDirectory scratch(temporary_parent());
  const fs::path content = scratch.path() / "content";
  write_sources(content, files.packed);
  std::vector<std::string> entries;
  for (const EmittedFile& packed : files.packed) entries.push_back(packed.path);
  const EmittedFile icon{options.version == 2 ? "model.png" : "terminalsAndIcons/icon.png",
                         icon_png(compilation.model)};
  write_sources(content, {icon});
  entries.push_back(icon.path);
  if (!options.sources_only) {
    for (std::string& binary : compile_libraries(options, scratch.path(), content, files))
      entries.push_back(std::move(binary));
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

void add_export(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<ExportOptions>();
  NamedCommand command = application.add_command("export", "write a Functional Mock-up Unit of a model");
  command.footer(
      "Example: mbgen export models/coach_rig.json --fmi 3 -o coach_rig.fmu\n"
      "         mbgen export models/coach_rig.json --fmi 2 --platform x86_64-linux,x86_64-windows -o coach_rig.fmu\n"
      "The unit has co-simulation and model exchange, a library for this kind of machine or for each --platform, and "
      "its\n"
      "sources.");
  add_model_argument(command, options->model);
  command.add_option("--fmi", options->version, "version of the Functional Mock-up Interface: 2 or 3")
      .required()
      .one_of({"2", "3"});
  command.add_option("-o,--out", options->file, "the FMU").required();
  std::vector<std::string> names;
  for (const Platform& platform : kPlatforms) names.emplace_back(platform.name);
  options->platforms = {kThisPlatform};
  command
      .add_option("--platform", options->platforms,
                  "machines that the unit has libraries for, by default this kind: x86_64-linux, aarch64-linux, "
                  "x86_64-windows")
      .separated_by(',')
      .one_of(names);
  command.add_flag("--sources-only", options->sources_only, "leave the library out; needs no compiler");
  add_set_option(command, options->set);
  add_depfile_option(command, options->depfile);
  add_form_option(command, options->form);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
