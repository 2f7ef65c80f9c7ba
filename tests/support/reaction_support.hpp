#pragma once
// Reactions of a model's joints and rods by its outputs, and the forces and motions of its bodies to hold them against.

#include <array>
#include <map>
#include <set>

#include "compiler/formulation/vector.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

using Force = Vector<double>;

/// Analyses a model that is written down or was changed; a failure stops the test with its diagnostics.
inline Mechanism analysed(Model model) {
  Result<Topology> topology = build_topology(model);
  if (!topology) throw std::runtime_error(to_text(topology.problems()));
  Result<Analysis> analysis = analyse(model, *topology);
  if (!analysis) throw std::runtime_error(to_text(analysis.problems()));
  return {std::move(model), *topology, *analysis};
}

/// The model of a text.
inline Model model_of(const std::string& text) {
  Result<Model> model = read_model(text, "test.json");
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

/// Index of a named element.
template <class Elements>
int index_of(const Elements& elements, const std::string& name) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i].name == name) return static_cast<int>(i);
  throw std::runtime_error("no " + name);
}

/// Appends the three components of an output and returns the index of the first.
template <class Source>
int add_vector(Model& model, Source source) {
  const int first = static_cast<int>(model.outputs.size());
  for (source.axis = 0; source.axis < 3; ++source.axis)
    model.outputs.push_back({"probe" + std::to_string(model.outputs.size()), {}, "", source});
  return first;
}

/// Appends position, velocity or acceleration of a point.
inline int add_motion(Model& model, const Attachment& point, PointOutput::What what) {
  PointOutput source;
  source.point = point;
  source.what = what;
  return add_vector(model, source);
}

/// Appends the force or moment of a joint or rod (the other -1) at one end, global axes.
inline int add_reaction(Model& model, int joint, int rod, ReactionOutput::What what, ReactionOutput::End end) {
  ReactionOutput source;
  source.joint = joint;
  source.rod = rod;
  source.what = what;
  source.end = end;
  return add_vector(model, source);
}

inline Force vector_at(const std::vector<double>& y, int first) { return {y[first], y[first + 1], y[first + 2]}; }

/// A new point of a body.
inline Attachment add_point(Model& model, int body, const Vector3& place) {
  Body& b = model.bodies[body];
  b.points.push_back({"probe" + std::to_string(b.points.size()), {place[0], place[1], place[2]}});
  return {body, static_cast<int>(b.points.size()) - 1};
}

/// Outputs of a state, after a check that it has accelerations.
inline std::vector<double> outputs_at(const GenericSolver& solver, const GenericState& state,
                                      const std::vector<double>& tau) {
  GenericDerivative derivative;
  if (!solver.accelerations(state, tau, derivative).ok()) throw std::runtime_error("no accelerations");
  return solver.outputs(state, tau, derivative).y;
}

/// The reference configuration at rest, closed and driven.
inline GenericState start_state(const Mechanism& m) {
  GenericState state{std::vector<double>(m.topology.size()), std::vector<double>(m.topology.size()),
                     initial_auxiliary_states(m.model), 0};
  const GenericSolver solver(m.model, m.topology, m.analysis);
  EXPECT_TRUE(solver.project(state).ok());
  return state;
}

/// Reactions of a small model at one state, by name.
struct Reading {
  std::map<std::string, Force> force, moment, force_from, moment_from;
};

inline Reading read_reactions(Model model, const std::map<std::string, std::pair<double, double>>& position_and_rate) {
  using What = ReactionOutput::What;
  using End = ReactionOutput::End;
  std::map<std::string, std::array<int, 4>> place;
  const auto add = [&](const std::string& name, int joint, int rod) {
    place[name] = {add_reaction(model, joint, rod, What::force, End::to),
                   add_reaction(model, joint, rod, What::moment, End::to),
                   add_reaction(model, joint, rod, What::force, End::from),
                   add_reaction(model, joint, rod, What::moment, End::from)};
  };
  for (std::size_t j = 0; j < model.joints.size(); ++j) add(model.joints[j].name, static_cast<int>(j), -1);
  for (std::size_t r = 0; r < model.rods.size(); ++r) add(model.rods[r].name, -1, static_cast<int>(r));
  const Mechanism m = analysed(std::move(model));
  GenericState state = start_state(m);
  for (const auto& [name, values] : position_and_rate) {
    const int i = find_coordinate(m.topology, name);
    EXPECT_GE(i, 0) << name;
    state.z[i] = values.first;
    state.zd[i] = values.second;
  }
  const GenericSolver solver(m.model, m.topology, m.analysis);
  EXPECT_TRUE(solver.project(state).ok());
  const std::vector<double> y = outputs_at(solver, state, std::vector<double>(state.z.size(), 0.0));
  Reading reading;
  for (const auto& [name, first] : place) {
    reading.force[name] = vector_at(y, first[0]);
    reading.moment[name] = vector_at(y, first[1]);
    reading.force_from[name] = vector_at(y, first[2]);
    reading.moment_from[name] = vector_at(y, first[3]);
  }
  return reading;
}

inline void expect_vector(const Force& actual, const Force& expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(actual.x, expected.x, tolerance) << what << " x";
  EXPECT_NEAR(actual.y, expected.y, tolerance) << what << " y";
  EXPECT_NEAR(actual.z, expected.z, tolerance) << what << " z";
}

}  // namespace mbgen::testing
