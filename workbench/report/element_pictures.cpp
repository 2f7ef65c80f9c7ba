#include "workbench/report/element_pictures.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/model/vectors.hpp"
#include "workbench/report/places.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kArcStep = 0.4;  // rad by one line

/// Canvas of draw_shapes.
struct ShapesOnBodies {
  const Model& model;
  double point;
  std::vector<Json>& shapes;
  std::set<std::pair<int, Vector3>> drawn = {};

  bool is_new(const Attachment& at) { return drawn.emplace(at.body, place_of(model, at)).second; }

  Vector3 axis_on(const Attachment& at, const Matrix3& axes, std::size_t k) const {
    return to_body_axes(model.bodies[at.body].pose, {axes[k], axes[3 + k], axes[6 + k]});
  }

  void ball(const Attachment& at, double radius) {
    if (is_new(at))
      shapes[at.body].push_back(
          {{"kind", "sphere"}, {"at", place_of(model, at)}, {"radius", radius > 0 ? radius : point}});
  }

  /// About `at`, where its edges are along the axes of its body. axes: columns, GLOBAL axes at the reference.
  void box(const Attachment& at, const Matrix3& axes, const Vector3Quantity& size) {
    const bool is_along = std::abs(axis_on(at, axes, 0)[0]) >= 1 && std::abs(axis_on(at, axes, 2)[2]) >= 1;
    if (is_new(at) && is_along)
      shapes[at.body].push_back({{"kind", "box"}, {"at", place_of(model, at)}, {"size", values(size)}});
  }

  /// About `at` along the third axis; without length not drawn.
  void cylinder(const Attachment& at, const Matrix3& axes, const std::optional<Quantity>& length, double radius) {
    if (!is_new(at) || !length) return;
    const Vector3 centre = place_of(model, at), axis = axis_on(at, axes, 2);
    const Vector3 low = sum(centre, axis, -length->value / 2), high = sum(centre, axis, length->value / 2);
    shapes[at.body].push_back({{"kind", "tube"}, {"from", low}, {"to", high}, {"radius", radius}});
  }
};

/// Canvas of draw_lines: places in GLOBAL axes at the reference, m, on the bodies that carry them.
template <class Element>
struct LinesBetweenBodies {
  const Model& model;
  const Element& element;
  double radius;
  Json& links;

  Json end(int body, const Vector3& global) const { return {body, to_local(model.bodies[body].pose, global)}; }

  void line(int from_body, const Vector3& from, int to_body, const Vector3& to) {
    links.push_back({{"name", element.name},
                     {"kind", KindOf<Element>::key},
                     {"from", end(from_body, from)},
                     {"to", end(to_body, to)},
                     {"radius", radius}});
  }

  /// About a centre from `first` on, by an angle with the sign of the axis, whole turns left out.
  void arc(int body, const Attachment& about, const Vector3& axis, const Vector3& first, double angle) {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const Vector3 centre = reference_position(model, about), arm = from_to(centre, first), side = cross(axis, arm);
    const int steps = static_cast<int>(std::ceil(std::fmod(std::abs(angle), kTurn) / kArcStep));
    const auto at = [&](int k) {
      const double turn = angle * k / std::max(steps, 1);
      return sum(sum(centre, arm, std::cos(turn)), side, std::sin(turn));
    };
    for (int k = 0; k < steps; ++k) line(body, at(k), body, at(k + 1));
  }
};

}  // namespace

void add_element_shapes(const Model& model, double point, std::vector<Json>& shapes) {
  ShapesOnBodies canvas{model, point, shapes};
  each_element(model, [&]<class Element>(const Element& element) {
    if constexpr (requires { KindOf<Element>::draw_shapes(canvas, element); })
      KindOf<Element>::draw_shapes(canvas, element);
  });
}

void add_element_lines(const Model& model, double radius, Json& links) {
  each_element(model, [&]<class Element>(const Element& element) {
    LinesBetweenBodies<Element> canvas{model, element, radius, links};
    if constexpr (requires { KindOf<Element>::draw_lines(canvas, element); })
      KindOf<Element>::draw_lines(canvas, element);
  });
}

}  // namespace mbgen
