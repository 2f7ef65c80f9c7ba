// mbgen export: a Functional Mock-up Unit.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "compiler/compile.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/engines/engine_arguments.hpp"
#include "workbench/engines/fmu_libraries.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/depfile.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/temporary_directory.hpp"
#include "workbench/host/zip_archive.hpp"
#include "workbench/motion/path_forces.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::cli {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string model, form, file, depfile;
  std::vector<std::string> platforms, set;
  int version = 0;
  bool sources_only = false, json = false;
};

/// Time of modification of all entries of the archive.
constexpr const char* kTimeOfEntries = "--mtime=2000-01-01 00:00:00 UTC";

/// Notes on variables with other names in the FMU, where all names form one list.
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

/// Packs a zip archive of these entries, reproducibly.
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

/// Model exchange needs pairs of a position and its rate; rolling bodies have more positions than velocities.
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

/// Start values of an FMU are angles and their rates, which are singular at the pole of a joint.
void refuse_pole(const Compilation& compilation, const InitialState& initial) {
  if (initial.charts.empty()) return;
  const InitialTurning& turning = compilation.model.initial.turnings.front();
  const std::string& joint = compilation.model.joints[static_cast<std::size_t>(turning.joint)].name;
  throw UserError(
      to_text({{turning.where,
                fmt::format("no FMU is written: its start values are rates of angles, and the angles of joint "
                            "\"{}\" start in their pole",
                            joint),
                "give the joint another \"sequence\"",
                {}}}));
}

int run(const ExportOptions& options) {
  if (is_standard_output(options.file))
    throw UserError("--out: an FMU is no text for standard output, name a file\n  hint: a file of this name is ./-\n");
  Model model = read_set_model(options.model, options.set);
  add_actuator_outputs(model);
  const Compilation compilation = compiled(std::move(model), {.form = chosen_form(options.form)});
  print_notes(compilation.model.notes);
  print_notes(renamed_notes(compilation.model));
  note_rolling(compilation);
  const FmiVersion version = options.version == 2 ? FmiVersion::two : FmiVersion::three;
  const InitialState initial = default_initial_state(compilation);
  refuse_pole(compilation, initial);
  const FmuFiles files = emit_fmu(compilation, initial, version);

  AtomicFile file(options.file, compilation.model.files);
  std::optional<AtomicFile> depfile = depfile_of(options.depfile, options.file, compilation.model.files);
  const TemporaryDirectory scratch(temporary_parent());
  const fs::path content = scratch.path() / "content";
  write_entries(content, files.packed);
  std::vector<std::string> entries;
  for (const EmittedFile& packed : files.packed) entries.push_back(packed.path);
  const EmittedFile icon{options.version == 2 ? "model.png" : "terminalsAndIcons/icon.png",
                         icon_png(compilation.model)};
  write_entries(content, {icon});
  entries.push_back(icon.path);
  if (!options.sources_only) {
    for (std::string& binary : compile_fmu_libraries(files, version, options.platforms, content, scratch.path()))
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
  options->platforms = {fmu_platform_of_this_machine()};
  command
      .add_option("--platform", options->platforms,
                  "machines that the unit has libraries for, by default this kind: x86_64-linux, aarch64-linux, "
                  "x86_64-windows")
      .separated_by(',')
      .one_of(fmu_platforms());
  command.add_flag("--sources-only", options->sources_only, "leave the library out; needs no compiler");
  add_set_option(command, options->set);
  add_depfile_option(command, options->depfile);
  add_form_option(command, options->form);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
