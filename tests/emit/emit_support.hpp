#pragma once
// A bead on a circle, by hand: two sliders x and y, closed by x^2 + y^2 = area. Small enough to know every answer.

#include <string>
#include <vector>

#include "compiler/emit/emit.hpp"

namespace mbgen::test {

/// Everything that emit needs.
struct Example {
  Model model;
  Topology topology;
  Analysis analysis;
  Programs programs;
};

inline Freedom slider(const std::string& name, const Vector3& axis) { return {name, FreedomKind::prismatic, axis}; }

/// Two sliders in a chain without forces or loops; its programs are empty but for zdd = tau.
inline Example two_sliders() {
  Example example;
  Model& model = example.model;
  model.name = "bead";
  model.file = "somewhere/bead.json";
  model.hash = "0123456789abcdef";
  model.bodies.resize(2);
  model.bodies[0].name = "carriage";
  model.bodies[1].name = "bead";
  model.joints.resize(2);
  model.joints[0].name = "x";
  model.joints[0].freedoms = {slider("x", {1, 0, 0})};
  model.joints[1].name = "y";
  model.joints[1].freedoms = {slider("y", {0, 1, 0})};

  Topology& topology = example.topology;
  topology.bodies.resize(2);
  for (int i = 0; i < 2; ++i) {
    TreeBody& body = topology.bodies[i];
    body.name = model.bodies[i].name;
    body.coordinate = model.joints[i].name;
    body.parent = i - 1;
    body.model_body = body.joint = i;
    body.kind = FreedomKind::prismatic;
    topology.groups.push_back({-1, {i}, i - 1, i - 1});
    topology.group_of.push_back(i);
  }
  topology.roots = {0};
  topology.children = {{1}, {}};
  topology.tree_body = {0, 1};

  example.analysis.driven = {false, false};
  example.analysis.motion_of = {-1, -1};
  example.analysis.degrees_of_freedom = 2;
  ProgramBuilder builder("accelerations");
  for (int i = 0; i < 2; ++i) {
    builder.output(Array::zdd, i, builder.input(Array::tau, i));
    builder.output(Array::inertia, i, builder.constant(1));
  }
  example.programs.accelerations = builder.finish_in_canonical_order();
  return example;
}

/// The sliders with xdd = push, an input whose derivatives `rate` and `jerk` are inputs too.
inline Example pushed_slider() {
  Example example = two_sliders();
  const auto input = [](const std::string& name, int derivative) {
    Input result;
    result.name = name;
    result.derivative = derivative;
    return result;
  };
  example.model.inputs = {input("jerk", -1), input("push", 2), input("rate", 0)};
  ProgramBuilder builder("accelerations");
  builder.output(Array::zdd, 0, builder.input(Array::in, 1));
  builder.output(Array::zdd, 1, builder.constant(0));
  for (int i = 0; i < 2; ++i) builder.output(Array::inertia, i, builder.constant(1));
  example.programs.accelerations = builder.finish_in_canonical_order();
  return example;
}

/// Inputs of the bead's programs, and what several of them need.
struct Symbols {
  explicit Symbols(ProgramBuilder& b)
      : x(b, b.input(Array::z, 0)),
        y(b, b.input(Array::z, 1)),
        xd(b, b.input(Array::zd, 0)),
        yd(b, b.input(Array::zd, 1)) {}
  Expr x, y, xd, yd;
  Expr residual(const Expr& area) const { return x * x + y * y - area; }
  Expr c() const { return -2.0 * (xd * xd + yd * yd); }
};

inline void output(ProgramBuilder& builder, SlotGroup group, int index, const Expr& value) {
  builder.output(group, index, value.value(builder));
}

/// Frozen: x is dependent, y is free. mass (xdd, ydd) = (tau_x + push, tau_y - mass g) + lambda (2 x, 2 y).
inline Program bead_accelerations() {
  ProgramBuilder builder("accelerations");
  builder.set_section({Step::inertias});
  const Symbols s(builder);
  const Expr mass(builder, builder.input(Array::par, 0));
  const Expr force_x = Expr(builder, builder.input(Array::tau, 0)) + Expr(builder, builder.input(Array::in, 0));
  const Expr force_y = Expr(builder, builder.input(Array::tau, 1)) - 9.81 * mass;
  builder.label(force_x.value(builder), "force x");
  builder.set_section({Step::jacobian});
  builder.set_owner({OwnerKind::tree_body, 0});
  const Expr rz = -(s.y / s.x);
  builder.label(rz.value(builder), "Rz_x");
  const Expr star = s.c() / (2.0 * s.x);
  builder.set_section({Step::projection});
  builder.set_owner({OwnerKind::tree_body, 1});
  const Expr inertia = mass * (rz * rz + 1.0);
  const Expr ydd = (rz * (force_x - mass * star) + force_y) / inertia;
  output(builder, Array::zdd, 1, ydd);
  output(builder, Array::zdd, 0, rz * ydd + star);
  output(builder, Array::pivot, 0, abs(s.x));
  output(builder, Array::inertia, 0, inertia);
  return builder.finish_in_canonical_order();
}

inline Program bead_accelerations_chosen() {
  ProgramBuilder builder("accelerations_chosen");
  const Expr mass(builder, builder.input(Array::par, 0));
  const Expr force[2] = {Expr(builder, builder.input(Array::tau, 0)) + Expr(builder, builder.input(Array::in, 0)),
                         Expr(builder, builder.input(Array::tau, 1)) - 9.81 * mass};
  Expr inertia = 0.0, right_hand_side = 0.0;
  Expr rz[2], star[2];
  for (int i = 0; i < 2; ++i) {
    rz[i] = Expr(builder, builder.input({Array::Rz, 0}, i));
    star[i] = Expr(builder, builder.input({Array::zdd_star, 0}, i));
    inertia += mass * rz[i] * rz[i];
    right_hand_side += rz[i] * (force[i] - mass * star[i]);
  }
  const Expr free = right_hand_side / inertia;
  for (int i = 0; i < 2; ++i) output(builder, Array::zdd, i, rz[i] * free + star[i]);
  output(builder, Array::inertia, 0, inertia);
  return builder.finish_in_canonical_order();
}

inline Program bead_closure() {
  ProgramBuilder builder("closure");
  const Symbols s(builder);
  const Expr residual = s.residual(Expr(builder, builder.input(Array::par, 1)));
  output(builder, Array::residual, 0, residual);
  output(builder, Array::dz, 0, -residual / (2.0 * s.x));
  output(builder, Array::zd, 0, -(s.y / s.x) * s.yd);
  output(builder, Array::zd, 1, s.yd);
  output(builder, Array::pivot, 0, abs(s.x));
  output(builder, {Array::Rz, 0}, 0, -(s.y / s.x));
  output(builder, {Array::Rz, 0}, 1, Expr(1.0));
  return builder.finish_in_canonical_order();
}

inline Program bead_closure_terms() {
  ProgramBuilder builder("closure_terms");
  const Symbols s(builder);
  output(builder, {Array::Phi, 0}, 0, s.residual(Expr(builder, builder.input(Array::par, 1))));
  output(builder, {Array::Jz, 0}, 0, 2.0 * s.x);
  output(builder, {Array::Jz, 0}, 1, 2.0 * s.y);
  output(builder, {Array::c, 0}, 0, s.c());
  return builder.finish_in_canonical_order();
}

/// The frozen multiplier, from x; `motions` is 1 when y is driven.
inline Program bead_multipliers(int motions = 0) {
  ProgramBuilder builder("multipliers");
  const Symbols s(builder);
  const Expr mass(builder, builder.input(Array::par, 0));
  const auto missing = [&](int i, const Expr& force) {
    return Expr(builder, builder.input(Array::tau, i)) + force - mass * Expr(builder, builder.input(Array::zdd, i));
  };
  const Expr missing_x = missing(0, Expr(builder, builder.input(Array::in, 0))), missing_y = missing(1, -9.81 * mass);
  const Expr lambda = missing_x / (2.0 * s.x);
  output(builder, Array::lambda, 0, lambda);
  for (int g = 0; g < motions; ++g) output(builder, Array::drive, g, 2.0 * s.y * lambda - missing_y);
  output(builder, {Array::missing, 0}, 0, missing_x);
  output(builder, {Array::missing, 0}, 1, missing_y);
  output(builder, Array::pivot, 0, abs(s.x));
  return builder.finish_in_canonical_order();
}

inline Program bead_outputs() {
  ProgramBuilder builder("outputs");
  const Symbols s(builder);
  const Expr mass(builder, builder.input(Array::par, 0));
  output(builder, Array::y, 0, sqrt(s.x * s.x + s.y * s.y));
  output(builder, Array::energy, 0, 0.5 * mass * (s.xd * s.xd + s.yd * s.yd));
  output(builder, Array::energy, 1, 9.81 * mass * s.y);
  output(builder, Array::power, 0, Expr(builder, builder.input(Array::in, 0)) * s.xd);
  return builder.finish_in_canonical_order();
}

/// The bead on its circle. Tunable parameters `mass` (2 kg) and `area` (1 m^2), input `push` (0 N along x), output
/// `radius`.
inline Example bead_on_circle() {
  Example example = two_sliders();
  Parameter mass, folded, area;
  mass.name = "mass";
  mass.value = 2;
  mass.unit = "kg";
  mass.tunable = true;
  folded.name = "folded";
  area.name = "area";
  area.value = 1;
  area.unit = "m^2";
  area.tunable = true;
  example.model.parameters = {mass, folded, area};
  Input push;
  push.name = "push";
  push.unit = "N";
  example.model.inputs = {push};
  Output radius;
  radius.name = "radius";
  radius.unit = "m";
  example.model.outputs = {radius};

  Topology& topology = example.topology;
  Loop loop;
  loop.name = "circle";
  loop.kind = ClosureKind::rod;
  loop.joints = {0, 1};
  loop.equations = 1;
  topology.loops = {loop};
  topology.blocks = {{{0}, {0, 1}, kGround, 1}};
  topology.groups = {{0, {0, 1}, kGround, -1}};
  topology.group_of = {0, 0};
  example.analysis.blocks.resize(1);
  example.analysis.blocks[0].rank = 1;
  example.analysis.blocks[0].dependent = {0};
  example.analysis.blocks[0].independent = {1};
  example.analysis.independent_equations = 1;
  example.analysis.degrees_of_freedom = 1;

  Programs& programs = example.programs;
  programs.accelerations = bead_accelerations();
  programs.accelerations_chosen = bead_accelerations_chosen();
  programs.closure = bead_closure();
  programs.closure_terms = bead_closure_terms();
  programs.multipliers = bead_multipliers();
  programs.outputs = bead_outputs();
  return example;
}

/// The bead with its multiplier as a second output, `pull`.
inline Example bead_with_pull() {
  Example example = bead_on_circle();
  Output pull;
  pull.name = "pull";
  pull.unit = "N";
  pull.source = MultiplierOutput{-1, 0, 0};
  example.model.outputs.push_back(pull);
  ProgramBuilder builder("outputs");
  const Symbols s(builder);
  output(builder, Array::y, 0, sqrt(s.x * s.x + s.y * s.y));
  builder.output(Array::y, 1, builder.input(Array::lambda, 0));
  example.programs.outputs = builder.finish_in_canonical_order();
  return example;
}

/// The bead with its equation written twice, the second time with another radius: area + gap.
inline Example redundant_bead(double gap) {
  Example example = bead_on_circle();
  example.topology.loops[0].equations = example.topology.blocks[0].equations = 2;
  example.analysis.blocks[0].redundant_equations = {1};
  ProgramBuilder closure("closure");
  {
    const Symbols s(closure);
    const Expr residual = s.residual(Expr(closure, closure.input(Array::par, 1)));
    output(closure, Array::residual, 0, residual);
    output(closure, Array::residual, 1, residual - gap);
    output(closure, Array::dz, 0, -residual / (2.0 * s.x));
    output(closure, Array::zd, 0, -(s.y / s.x) * s.yd);
    output(closure, Array::zd, 1, s.yd);
    output(closure, Array::pivot, 0, abs(s.x));
    output(closure, {Array::Rz, 0}, 0, -(s.y / s.x));
    output(closure, {Array::Rz, 0}, 1, Expr(1.0));
  }
  ProgramBuilder terms("closure_terms");
  const Symbols s(terms);
  for (int e = 0; e < 2; ++e) {
    output(terms, {Array::Phi, 0}, e, s.residual(Expr(terms, terms.input(Array::par, 1))) - e * gap);
    output(terms, {Array::Jz, 0}, 2 * e, 2.0 * s.x);
    output(terms, {Array::Jz, 0}, 2 * e + 1, 2.0 * s.y);
    output(terms, {Array::c, 0}, e, s.c());
  }
  example.programs.closure = closure.finish();
  example.programs.closure_terms = terms.finish();
  return example;
}

/// The bead with y driven: y = 0.3 t + 0.1 t^2. No direction is free.
inline Example driven_bead() {
  Example example = bead_on_circle();
  example.model.motions.resize(1);
  example.model.motions[0].joint = {1, 0};
  example.analysis.driven = {false, true};
  example.analysis.motion_of = {-1, 0};
  example.analysis.blocks[0].independent = {};
  example.analysis.blocks[0].driven = {1};
  const auto time = [](ProgramBuilder& builder) { return Expr(builder, builder.input(Array::t, 0)); };
  const auto position = [](const Expr& t) { return 0.3 * t + 0.1 * (t * t); };
  const auto velocity = [](const Expr& t) { return 0.3 + 0.2 * t; };
  constexpr double kAcceleration = 0.2;

  ProgramBuilder accelerations("accelerations"), chosen("accelerations_chosen"), closure("closure"),
      terms("closure_terms");
  {
    const Symbols s(accelerations);
    output(accelerations, Array::zdd, 0, (s.c() - 2.0 * kAcceleration * s.y) / (2.0 * s.x));
    output(accelerations, Array::zdd, 1, kAcceleration);
    output(accelerations, Array::pivot, 0, abs(s.x));
  }
  for (int i = 0; i < 2; ++i) chosen.output(Array::zdd, i, chosen.input({Array::zdd_star, 0}, i));
  {
    const Symbols s(closure);
    const Expr residual = s.residual(Expr(closure, closure.input(Array::par, 1)));
    const Expr dy = position(time(closure)) - s.y, yd = velocity(time(closure));
    const Expr dx = -(residual + 2.0 * s.y * dy) / (2.0 * s.x);
    output(closure, Array::residual, 0, residual);
    output(closure, Array::residual, 1, dy);
    output(closure, Array::dz, 0, dx);
    output(closure, Array::dz, 1, dy);
    output(closure, Array::zd, 0, -(s.y / s.x) * yd);
    output(closure, Array::zd, 1, yd);
    output(closure, Array::pivot, 0, abs(s.x));
  }
  {
    const Symbols s(terms);
    output(terms, {Array::Phi, 0}, 0, s.residual(Expr(terms, terms.input(Array::par, 1))));
    output(terms, {Array::Jz, 0}, 0, 2.0 * s.x);
    output(terms, {Array::Jz, 0}, 1, 2.0 * s.y);
    output(terms, {Array::c, 0}, 0, s.c());
    output(terms, Array::driven_acceleration, 1, kAcceleration);
  }
  example.programs.accelerations = accelerations.finish();
  example.programs.accelerations_chosen = chosen.finish();
  example.programs.closure = closure.finish();
  example.programs.closure_terms = terms.finish();
  example.programs.multipliers = bead_multipliers(1);
  return example;
}

inline std::vector<EmittedFile> emit(const Example& example, const EmitOptions& options = {}) {
  return mbgen::emit({example.programs}, example.model, example.topology, example.analysis, options);
}

/// Text of one of the files, "" when it is not there.
inline std::string text_of(const std::vector<EmittedFile>& files, const std::string& path) {
  for (const EmittedFile& file : files) {
    if (file.path == path) return file.text;
  }
  return "";
}

}  // namespace mbgen::test
