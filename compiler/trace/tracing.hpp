#pragma once
// One program in the making: data that the files of this room share.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/formulation/formulation.hpp"
#include "compiler/formulation/recursion/recursion_units.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/trace/annotator.hpp"

namespace mbgen {

/// One program in the making: the formulation's view of the model, on symbols, in the frames of a form.
class Tracing {
 public:
  /// choices: of the recursive form.
  Tracing(Role role, const Model& model, const Topology& topology, const Analysis& analysis, Form form,
          RecursionChoices choices = {}, Spelling spelling = Spelling::fast)
      : role(role),
        builder(name_of(role), spelling),
        annotator{builder},
        form(form),
        recursion(form == Form::recursive ? plan_recursion(model, topology, analysis.driven, choices) : Recursion{}),
        layout(form == Form::recursive ? recursion.layout : choose_layout(model, topology)),
        analysis(analysis),
        system{model, topology, layout, environment(role, model, topology), {}, {}, annotator} {
    builder.set_samples(model.samples);
    const auto step = annotator.step(Step::inertias);
    system.x = inputs(Array::x, auxiliary_state_count(model));
    system.constants = make_constants(model, topology, system.environment);
    name_constants(annotator, model, topology, system.constants);
    drive = drives(system);
  }

  /// Result of `work`, with its values in this step.
  template <class Work>
  auto in(Step step, Work work) {
    const auto scope = annotator.step(step);
    return work();
  }
  /// Step 1.
  Kinematics<Expr> poses() {
    return in(Step::inertias, [&] { return kinematics(system); });
  }

  Expr input(SlotGroup group, int index) { return {builder, builder.input(group, index)}; }
  std::vector<Expr> inputs(SlotGroup group, int count, int first = 0) {
    std::vector<Expr> values;
    for (int i = first; i < first + count; ++i) values.push_back(input(group, i));
    return values;
  }
  void output(SlotGroup group, int index, const Expr& value) { builder.output(group, index, value.value(builder)); }
  void outputs(SlotGroup group, const std::vector<Expr>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) output(group, static_cast<int>(i), values[i]);
  }
  /// The quality of a block's factors; a block of rank zero has none.
  void output_pivot(std::size_t block, const Expr& quality) {
    if (analysis.blocks[block].rank > 0) output(Array::pivot, static_cast<int>(block), quality);
  }
  int size() const { return system.topology.size(); }

  /// Prescribed values of a block's coordinates (zero where not driven); what: member of Drive.
  std::vector<Expr> driven_values(const LoopBlock& block, Expr Drive<Expr>::*what) const {
    std::vector<Expr> values(block.joints.size(), Expr(0.0));
    for (std::size_t c = 0; c < block.joints.size(); ++c)
      for (const Drive<Expr>& d : drive)
        if (d.coordinate == block.joints[c]) values[c] = d.*what;
    return values;
  }

  /// The projection of a block over a partition chosen at run time: inputs of the program.
  GroupProjection<Expr> chosen_projection(std::size_t block) {
    const int free = static_cast<int>(analysis.blocks[block].independent.size());
    const int columns = static_cast<int>(system.topology.blocks[block].joints.size());
    GroupProjection<Expr> chosen{{}, inputs(of_block(Array::zdd_star, block), columns)};
    for (int c = 0; c < columns; ++c) chosen.rz.push_back(inputs(of_block(Array::Rz, block), free, c * free));
    return chosen;
  }

  const Role role;
  ProgramBuilder builder;
  Annotator<Expr> annotator;
  Form form;
  Recursion recursion;  ///< the units of the recursive form, none of the matrix form
  Layout layout;
  const Analysis& analysis;
  System<Expr> system;
  std::vector<Drive<Expr>> drive;

 private:
  /// The programs of every step know the angles of the model alone: states with another chart go by the others.
  static bool takes_charts(Role role) { return role != Role::accelerations && role != Role::closure; }

  Environment<Expr> environment(Role role, const Model& model, const Topology& topology) {
    Environment<Expr> e;
    e.topology = &topology;
    int tunable = 0;
    for (const Parameter& p : model.parameters)
      e.parameters.push_back(p.tunable ? input(Array::par, tunable++) : Expr(p.value));
    e.inputs = inputs(Array::in, static_cast<int>(model.inputs.size()));
    e.t = input(Array::t, 0);
    e.z = inputs(Array::z, topology.size());
    e.zd = inputs(Array::zd, topology.size());
    if (takes_charts(role)) e.charts = inputs(Array::charts, static_cast<int>(topology.balls.size()));
    count_as_the_model(model, e);
    return e;
  }
};

}  // namespace mbgen
