#include "workbench/import/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "workbench/import/mjcf.hpp"
#include "workbench/import/sdf.hpp"
#include "workbench/import/urdf.hpp"

namespace mbgen {
namespace {

using importing::Assembly;
using importing::Element;
using importing::Reading;

/// Sorts by file, in the order of opening, then by position; of equal ones the first remains.
void sort_by_place(const Reading& reading, Diagnostics& list) {
  const auto file_index = [&](const std::string& file) {
    const auto found = std::find_if(reading.sources.begin(), reading.sources.end(),
                                    [&](const importing::Source& source) { return source.file == file; });
    return found - reading.sources.begin();
  };
  std::stable_sort(list.begin(), list.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(file_index(a.where.file), a.where.line, a.where.column) <
           std::tuple(file_index(b.where.file), b.where.line, b.where.column);
  });
  const auto is_same = [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.where.file, a.where.line, a.where.column, a.message) ==
           std::tie(b.where.file, b.where.line, b.where.column, b.message);
  };
  list.erase(std::unique(list.begin(), list.end(), is_same), list.end());
}

/// Name of the robot, else of its file. Requires: the robot is translated; an SDF file has given its model's name.
std::string model_name(const ImportRequest& request, const Element& root, const Assembly& assembly) {
  std::string name =
      root.name == "sdf" ? assembly.name : importing::text_of(root, root.name == "robot" ? "name" : "model");
  if (name.empty()) name = std::filesystem::path(request.file).stem().string();
  return importing::valid_name(name);
}

void translate(Reading& reading, const Element& root, Assembly& assembly) {
  if (root.name == "robot") return importing::import_urdf(reading, root, assembly);
  if (reading.request.base && (root.name == "sdf" || root.name == "mujoco"))
    return importing::problem(reading, root.spot, "--base is for a URDF robot alone",
                              root.name == "sdf"
                                  ? "a joint with <parent>world</parent> holds a model, without one it moves"
                                  : "a <freejoint> lets a body move, without joints it is fixed");
  if (root.name == "sdf") return importing::import_sdf(reading, root, assembly);
  if (root.name == "mujocoinclude") {
    importing::problem(reading, root.spot, "<mujocoinclude> is a part of a model",
                       "import the file that includes it, its root element is <mujoco>");
    return;
  }
  if (root.name != "mujoco") {
    importing::problem(reading, root.spot, fmt::format("<{}> is no robot", root.name),
                       "the root element of URDF is <robot>, of SDF <sdf>, of MJCF <mujoco>");
    return;
  }
  if (reading.request.loops) {
    importing::problem(reading, root.spot, "an MJCF model takes no file of loops",
                       "close them by <equality> <connect>");
    return;
  }
  importing::import_mjcf(reading, root, assembly);
}

}  // namespace

Result<ImportedModel> import_robot(const ImportRequest& request, Diagnostics* notes_of_failure) {
  Reading reading{.request = request, .sources = {}, .problems = {}, .notes = {}};
  const std::optional<Element> root = importing::read_xml(reading);
  Assembly assembly;
  if (root) translate(reading, *root, assembly);
  sort_by_place(reading, reading.notes);
  if (!reading.problems.empty()) {
    sort_by_place(reading, reading.problems);
    if (notes_of_failure) *notes_of_failure = std::move(reading.notes);
    return reading.problems;
  }
  ImportedModel model;
  model.name = assembly.name = model_name(request, *root, assembly);
  model.format = root->name == "robot" ? "URDF" : root->name == "sdf" ? "SDF" : "MJCF";
  assembly.comment = fmt::format("Imported by mbgen from {} ({}).",
                                 std::filesystem::path(request.file).filename().string(), model.format);
  model.json = importing::model_text(assembly);
  model.bodies = static_cast<int>(assembly.bodies.size()) - 1;
  model.joints = static_cast<int>(assembly.joints.size());
  model.loops = static_cast<int>(std::count_if(assembly.joints.begin(), assembly.joints.end(),
                                               [](const importing::JointDraft& joint) { return joint.cut; }));
  model.notes = std::move(reading.notes);
  for (const importing::Source& source : reading.sources) model.files.push_back(source.file);
  return model;
}

}  // namespace mbgen
