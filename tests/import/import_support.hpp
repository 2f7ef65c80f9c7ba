#pragma once
// Robots of tests/import, imported and analysed.

#include <fstream>
#include <iterator>

#include "tests/support/mechanism_support.hpp"
#include "workbench/import/import.hpp"

namespace mbgen::testing {

inline std::optional<std::string> content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// A text as if it were a file in tests/import.
inline ImportRequest request_of(const std::string& name, std::string text) {
  return {.file = name,
          .text = std::move(text),
          .loops_file = "loops.json",
          .loops = {},
          .read = [](const std::string& path) { return content_of(source_path("tests/import/" + path)); }};
}

inline ImportedModel imported_text(const ImportRequest& request) {
  Result<ImportedModel> model = import_robot(request);
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

/// A robot of tests/import, with the sidecar of this name where there is one.
inline ImportedModel imported(const std::string& name, const std::string& loops = {}) {
  ImportRequest request = request_of(name, content_of(source_path("tests/import/" + name)).value());
  if (!loops.empty()) request.loops = content_of(source_path("tests/import/" + loops)).value();
  return imported_text(request);
}

inline std::size_t index_of(const Mechanism& m, const std::string& coordinate) {
  for (std::size_t i = 0; i < m.topology.bodies.size(); ++i)
    if (m.topology.bodies[i].coordinate == coordinate) return i;
  throw std::runtime_error("no coordinate " + coordinate);
}

/// Largest difference of the accelerations that two models have at the same states of the first.
inline double difference(const Mechanism& a, const Mechanism& b, const std::vector<GenericState>& states) {
  const GenericSolver one(a.model, a.topology, a.analysis), other(b.model, b.topology, b.analysis);
  double error = 0;
  for (const GenericState& state : states) {
    GenericState moved{.z = state.z, .zd = state.zd, .x = {}, .t = state.t};
    for (std::size_t i = 0; i < state.z.size(); ++i) {
      const std::size_t to = index_of(b, a.topology.bodies[i].coordinate);
      moved.z[to] = state.z[i];
      moved.zd[to] = state.zd[i];
    }
    GenericDerivative first, second;
    EXPECT_TRUE(one.accelerations(state, std::vector<double>(state.z.size()), first).ok());
    EXPECT_TRUE(other.accelerations(moved, std::vector<double>(state.z.size()), second).ok());
    std::vector<double> mapped;
    for (std::size_t i = 0; i < state.z.size(); ++i)
      mapped.push_back(second.zdd[index_of(b, a.topology.bodies[i].coordinate)]);
    error = std::max(error, relative_error(mapped, first.zdd));
  }
  return error;
}

/// Checks that a robot accelerates as models/four_bar.json, whose loop its joint "rocker_tip" closes.
inline void expect_four_bar_of_models(const Mechanism& robot) {
  Model model = *read_model_file(source_path("models/four_bar.json"));
  model.springs.clear();
  model.outputs.clear();
  for (Joint& joint : model.joints)
    if (joint.name == "rocker_tip") joint.cut = CutMark::cut;
  const Mechanism written = analysed(Result<Model>(model));
  const std::vector<GenericState> states = random_states(robot, 5);
  ASSERT_EQ(states.size(), 5u);
  EXPECT_LT(difference(robot, written, states), 1e-11);
}

/// Whether a note of an import contains a text.
inline bool has_note(const ImportedModel& model, const std::string& part) {
  return std::any_of(model.notes.begin(), model.notes.end(),
                     [&](const Diagnostic& note) { return note.message.find(part) != std::string::npos; });
}

}  // namespace mbgen::testing
