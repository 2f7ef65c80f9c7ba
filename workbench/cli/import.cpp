// mbgen import: conversion of a robot in URDF, SDF or MJCF to a model.

#include "workbench/import/import.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/files.hpp"

namespace mbgen::cli {
namespace {

struct ImportOptions {
  std::string robot, loops, file, base;
  std::optional<double> stops;
  bool json = false;
};

ImportRequest import_request(const ImportOptions& options) {
  ImportRequest request{.file = options.robot, .text = read_text(options.robot, reading::kMostBytesOfTree)};
  if (!options.loops.empty()) {
    request.loops_file = options.loops;
    request.loops = read_text(options.loops, reading::kMostBytesOfTree);
  }
  if (!options.base.empty()) request.base = options.base == "floating" ? RobotBase::floating : RobotBase::fixed;
  if (options.stops && !(*options.stops > 0 && *options.stops <= 1e15))
    throw UserError("--stops: a stiffness above zero, in N m/rad and N/m\n");
  request.stop_stiffness = options.stops.value_or(0);
  request.read = [](const std::string& path) -> std::optional<std::string> {
    if (is_special(path)) return std::nullopt;
    try {
      return read_text(path);
    } catch (const UserError&) {
      return std::nullopt;
    }
  };
  return request;
}

nlohmann::ordered_json import_json(const ImportOptions& options, const ImportedModel& model) {
  return {{"robot", options.robot}, {"format", model.format},
          {"model", model.name},    {"file", options.file},
          {"bodies", model.bodies}, {"joints", model.joints},
          {"loops", model.loops},   {"notes", diagnostics_json(model.notes)}};
}

int run(const ImportOptions& options) {
  if (options.json && (options.file.empty() || is_standard_output(options.file)))
    throw UserError("--json: the report takes standard output, give the model a file with --out\n");
  Diagnostics notes_of_failure;
  Result<ImportedModel> imported = import_robot(import_request(options), &notes_of_failure);
  print_notes(notes_of_failure);
  const ImportedModel model = expect(std::move(imported));
  const std::string file = options.file.empty() ? model.name + ".json" : options.file;
  // The text must be a valid model; otherwise the translation is at fault.
  if (const Result<Model> read = read_model(model.json, file); !read) {
    throw std::logic_error("the imported model cannot be read:\n" + to_text(read.problems()));
  }
  if (!options.file.empty()) {
    std::vector<std::string> read = model.files;
    read.push_back(options.loops);
    write_file(options.file, model.json, read);
  }
  if (options.json) {
    print(json_text(import_json(options, model)));
    return kDone;
  }
  print_notes(model.notes);
  if (options.file.empty()) {
    print(model.json);
    return kDone;
  }
  print_beside(options.file,
               fmt::format("{}: bodies {}, joints {}, of them closing loops {}, notes {}\n", shown_name(options.file),
                           model.bodies, model.joints, model.loops, model.notes.size()));
  return kDone;
}

}  // namespace

void add_import(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<ImportOptions>();
  NamedCommand command = application.add_command("import", "make a model of a robot in URDF, SDF or MJCF");
  command.footer(
      "Example: mbgen import robot.urdf --out robot.json\n"
      "Standard error names each element that is not carried over, with its line. Without --out the model "
      "is\n"
      "printed. The treatment of each element, and the file of --loops: docs/use/import.md.");
  command.add_option("ROBOT", options->robot, "URDF (<robot>), SDF (<sdf>) or MJCF (<mujoco>) file").required();
  command.add_option("-o,--out", options->file, "write the model to this file");
  command.add_option("--loops", options->loops,
                     "JSON file with loops that a URDF has no word for, and positions where they close");
  command
      .add_option("--base", options->base,
                  "of a URDF robot: fixed, or floating where its root link moves freely (default fixed)")
      .one_of({"fixed", "floating"});
  command.add_option("--stops", options->stops,
                     "stiffness of stops at the ends of joints' ranges, N m/rad and N/m (default: no stops)");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
