#pragma once
// Outputs of motions, energies and wheels between random bodies and points of a model, and how two lists of their
// values compare.

#include <map>
#include <numbers>
#include <optional>
#include <random>

#include "compiler/model/element_access.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen::testing {

/// The model of a file of the project, not analysed.
inline Model model_at(const std::string& path) {
  Result<Model> model = read_model_file(source_path(path));
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

/// Appends outputs of every quantity of points, bodies, all bodies and wheels, and of the energy of elements.
class MotionOutputs {
 public:
  MotionOutputs(Model& model, std::uint64_t seed) : model_(model), random_(seed) {
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      for (std::size_t p = 0; p < model.bodies[b].points.size(); ++p)
        points_.push_back({static_cast<int>(b), static_cast<int>(p)});
  }

  void add() {
    add_points();
    add_rotations();
    add_momenta();
    add_stored_energies();
    for (std::size_t t = 0; t < model_.tyres.size(); ++t) add_wheel(static_cast<int>(t));
    for (std::size_t j = 0; j < model_.joints.size(); ++j) add_wheel_in(static_cast<int>(j));
  }

 private:
  int below(std::size_t size) { return static_cast<int>(random_() % size); }
  /// A body, ground too, or none.
  int body() { return below(model_.bodies.size() + 1) - 1; }
  int some_body() { return below(model_.bodies.size()); }
  Attachment point() { return points_[below(points_.size())]; }
  bool apart(const Attachment& a, const Attachment& b) const {
    const Vector3 p = reference_position(model_, a), q = reference_position(model_, b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 1e-3;
  }
  /// None where all points are one.
  std::optional<Attachment> point_apart_from(const Attachment& other) {
    for (int attempt = 0; attempt < 100; ++attempt)
      if (const Attachment found = point(); apart(found, other)) return found;
    return {};
  }
  void ask(const decltype(Output::source)& source) {
    model_.outputs.push_back({"motion" + std::to_string(model_.outputs.size()), {}, "", source});
  }

  void add_points() {
    using What = PointOutput::What;
    PointOutput source{.point = point(), .axes = body(), .relative_to = point(), .observer = body()};
    PointOutput plain{.point = point(), .axes = body()};
    for (const What what : {What::position, What::velocity, What::acceleration}) {
      source.what = plain.what = what;
      add_vector(model_, source);
      add_vector(model_, plain);
    }
    const Attachment middle = point();
    const auto first = point_apart_from(middle), last = point_apart_from(middle);
    if (!first) return;
    ask(PointsOutput{{middle, *first}});
    ask(PointsOutput{{*first, middle, *last}});
  }

  void add_rotations() {
    using What = RotationOutput::What;
    RotationOutput source{.body = some_body(), .relative_to = body(), .axes = body(), .observer = body()};
    for (const What what : {What::rotation_vector, What::angular_velocity, What::angular_acceleration}) {
      source.what = what;
      add_vector(model_, source);
    }
    source.what = What::quaternion;
    add_vector(model_, source);
    source.axis = 3;
    ask(source);
    source.what = What::angle;
    const int first = below(3), second = (first + 1 + below(2)) % 3;
    source.sequence = {first, second, (second + 1 + below(2)) % 3};
    for (source.turn = 0; source.turn < 3; ++source.turn) ask(source);
  }

  void add_momenta() {
    using What = MomentumOutput::What;
    for (const int of : {some_body(), kNoBody}) {
      MomentumOutput source{.body = of, .axes = body()};
      for (source.what = What::kinetic_energy; source.what <= What::potential_energy;
           source.what = static_cast<What>(static_cast<int>(source.what) + 1))
        ask(source);
      source.what = What::momentum;
      add_vector(model_, source);
      source.what = What::angular_momentum;
      add_vector(model_, source);
      source.about = point();
      add_vector(model_, source);
    }
  }

  /// No stored energy holds the part that an expression adds to a force.
  void add_stored_energies() {
    const auto has_law = [](const BumpStop& stop) { return stop.stiffness.has_value(); };
    each_kind([&]<class Kind>(KindOf<Kind> kind) {
      if (quantity_index(kind, kPotentialEnergy) < 0) return;
      for (std::size_t i = 0; i < kind.list(model_).size(); ++i) {
        if constexpr (std::is_same_v<Kind, BumpStop>)
          if (!has_law(kind.list(model_)[i])) continue;
        ask(output_of<Kind>(kPotentialEnergy, i));
      }
    });
    if (std::all_of(model_.bump_stops.begin(), model_.bump_stops.end(), has_law)) ask(StoredEnergyOutput{});
  }

  /// A point above another one and to a side of it, none where there is no such: of a steering axis along x or y angles
  /// are noise.
  std::optional<Attachment> point_askew_from(const Attachment& other) {
    const Vector3 p = reference_position(model_, other);
    for (int attempt = 0; attempt < 100; ++attempt) {
      const Attachment found = point();
      const Vector3 q = reference_position(model_, found);
      if (std::min({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])}) > 1e-2) return found;
    }
    return {};
  }

  void add_wheel(int tyre) {
    using What = WheelOutput::What;
    WheelOutput source{
        .tyre = tyre, .vehicle = body(), .side = below(2) == 0 ? 1.0 : -1.0, .lower = point(), .upper = {}};
    const auto upper = point_askew_from(source.lower);
    if (upper) source.upper = *upper;
    for (const What what : {What::toe, What::camber, What::steer_angle, What::caster, What::kingpin_inclination}) {
      source.what = what;
      if (what < What::caster || upper) ask(source);
    }
  }

  /// Of a joint whose axis is far from the vertical, where angles are noise.
  void add_wheel_in(int joint) {
    using What = WheelOutput::What;
    constexpr double kFar = 0.3;
    const Joint& of = model_.joints[static_cast<std::size_t>(joint)];
    if (of.type != JointType::revolute || std::hypot(of.axis[0], of.axis[1]) < kFar) return;
    WheelOutput source;
    source.joint = joint;
    source.axis = of.axis;
    source.side = below(2) == 0 ? 1.0 : -1.0;
    for (const What what : {What::toe, What::camber, What::steer_angle}) {
      source.what = what;
      ask(source);
    }
  }

  Model& model_;
  std::mt19937_64 random_;
  std::vector<Attachment> points_;
};

/// The model with such outputs and no others.
inline Mechanism with_motion_outputs(Model model, std::uint64_t seed, int rounds = 3) {
  model.outputs.clear();
  MotionOutputs outputs(model, seed);
  for (int round = 0; round < rounds; ++round) outputs.add();
  return analysed(std::move(model));
}

/// Whether an orientation is next to one that has two descriptions: half a turn, or the singular position of a
/// sequence.
inline bool is_ambiguous(const Model& model, const std::vector<double>& values, const RotationOutput& asked) {
  using What = RotationOutput::What;
  constexpr double kClose = 1e-4;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto* other = std::get_if<RotationOutput>(&model.outputs[i].source);
    if (!other || other->body != asked.body || other->relative_to != asked.relative_to) continue;
    if (other->what == What::quaternion && other->axis == 3 && std::abs(values[i]) < kClose) return true;
    const bool returns = other->sequence[0] == other->sequence[2];
    const double singular = returns ? std::sin(values[i]) : std::cos(values[i]);
    if (other->what == What::angle && other->turn == 1 && other->sequence == asked.sequence &&
        std::abs(singular) < kClose)
      return true;
  }
  return false;
}

/// Largest difference of values of such outputs, over the largest value of the same kind, at least 1; angles count up
/// to whole turns.
inline double motion_difference(const Model& model, const std::vector<double>& actual,
                                const std::vector<double>& expected) {
  std::map<std::pair<std::size_t, int>, double> scale;
  const auto kind_of = [&](std::size_t i) {
    const auto& source = model.outputs[i].source;
    const auto* point = std::get_if<PointOutput>(&source);
    const auto* rotation = std::get_if<RotationOutput>(&source);
    const auto* momentum = std::get_if<MomentumOutput>(&source);
    const int what = point      ? static_cast<int>(point->what)
                     : rotation ? static_cast<int>(rotation->what)
                     : momentum ? static_cast<int>(momentum->what)
                                : 0;
    return std::pair{source.index(), what};
  };
  for (std::size_t i = 0; i < expected.size(); ++i)
    scale[kind_of(i)] = std::max({scale[kind_of(i)], 1.0, std::abs(expected[i])});
  double largest = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto& source = model.outputs[i].source;
    const auto* rotation = std::get_if<RotationOutput>(&source);
    if (rotation && rotation->what <= RotationOutput::What::quaternion && is_ambiguous(model, expected, *rotation))
      continue;
    double difference = actual[i] - expected[i];
    const bool is_angle =
        (rotation && rotation->what == RotationOutput::What::angle) || std::holds_alternative<WheelOutput>(source);
    if (is_angle) difference = std::remainder(difference, 2 * std::numbers::pi);
    largest = std::max(largest, std::abs(difference) / scale[kind_of(i)]);
    if (std::isnan(difference)) return difference;
  }
  return largest;
}

}  // namespace mbgen::testing
