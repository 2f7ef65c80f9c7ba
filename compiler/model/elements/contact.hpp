#pragma once
// Contacts: a sphere or a point of a body on a plane, a road, or a sphere, cylinder or box of another body.

#include <array>
#include <optional>
#include <string>

#include "compiler/model/elements/bump_stop.hpp"

namespace mbgen {

/// A sphere of a body that presses on a surface of another body, or on a road. The normal force on both is the force of
/// a bump stop without clearance over the penetration p; nothing pulls. Friction acts against the sliding of the
/// contact point, in the middle between both surfaces, by two bristles: see mbgen::detail::contact_friction.
struct SurfaceContact {
  enum class Shape { plane, road, sphere, cylinder, box };
  std::string name;
  Where where;
  Attachment from;  ///< centre of the sphere
  Quantity radius;  ///< m, of the sphere, >= 0; 0: a point
  Attachment to;    ///< a point of the plane, else the centre of the other shape; no body for a road
  Shape shape = Shape::plane;
  /// columns, GLOBAL axes at the reference, fixed to the body of `to`: z is the normal of the plane, out of its body,
  /// or the axis of the cylinder; the edges of the box are along x, y, z
  Matrix3 axes{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Quantity other_radius;           ///< m, of the other sphere or cylinder, > 0
  std::optional<Quantity> length;  ///< m, of the cylinder between its flat ends, > 0; none: infinite
  Vector3Quantity size;            ///< m, edges of the box, > 0
  int road = -1;                   ///< index into Model::roads
  BumpStop push;                   ///< the law along the normal; its place has no meaning
  Quantity friction;               ///< coefficient of sliding friction; on a road times its own factor
  Quantity stiction;               ///< likewise at the start of sliding; the reader sets it to friction when absent
  Quantity stribeck_velocity;      ///< m/s, > 0: speed over which stiction fades
  Quantity bristle;                ///< m, > 0: deflection of the bristles under the largest friction
  Quantity bristle_damping;        ///< s: damping of the bristles over their stiffness
  Quantity elastic;                ///< share of this deflection up to which bristles bend without sliding
  std::optional<double> lag;  ///< s: least time constant of the bristles; the reader sets it to the step of the solver

  /// Whether it has friction, and the states of two bristles.
  bool has_friction() const {
    return friction.expression >= 0 || friction.value > 0 || stiction.expression >= 0 || stiction.value > 0;
  }
  /// Whether friction at the start of sliding differs from sliding friction.
  bool has_stiction() const { return stiction.expression != friction.expression || stiction.value != friction.value; }
};

/// Names of the shapes in the model format, in their order.
inline constexpr std::array kContactShapes = {"plane", "road", "sphere", "cylinder", "box"};

template <>
struct KindOf<SurfaceContact> : KindDefaults {
  using Element = SurfaceContact;
  static constexpr const char *key = "contact", *section = "contacts", *words = "contact";
  static constexpr bool is_elastic = true;
  static constexpr Drawing drawing = Drawing::pad;
  /// load: along the normal, lateral_force: across it; force: on the body of `from`, global axes; deflection:
  /// penetration, negative before the contact; velocity: of sliding
  static constexpr std::array quantities = {
      ElementQuantity{"load", "N"},          ElementQuantity{"lateral_force", "N"}, ElementQuantity{"deflection", "m"},
      ElementQuantity{"rate", "m/s"},        ElementQuantity{"velocity", "m/s"},    ElementQuantity{"force", "N", 3},
      ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows =
      "contact; the output is its load along the normal, its lateral force by friction, its force on the body of "
      "`from` "
      "in global axes, its deflection (penetration, negative before contact), the rate of that, its velocity of "
      "sliding "
      "or its potential energy";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.contacts;
  }
  static Connection connection(const SurfaceContact& element) {
    if (element.shape == SurfaceContact::Shape::road) return OnBody{element.from};
    return BetweenPoints{element.from, element.to};
  }
  template <class Words>
  static std::string sentence(const Words& words, const SurfaceContact& element) {
    const bool on_road = element.shape == SurfaceContact::Shape::road;
    const bool is_point = element.radius.expression < 0 && element.radius.value == 0;
    const std::string surface = on_road ? "the road " + words.road(element.road)
                                        : std::string("a ") + kContactShapes[static_cast<std::size_t>(element.shape)] +
                                              " of " + words.body(element.to);
    std::string text = element.name + " pushes " + words.body(element.from) + " away from " + surface + " where " +
                       (is_point ? "a point" : "a sphere of radius " + words.number(element.radius) + " m") +
                       " of it goes in; it never pulls.";
    if (element.has_friction())
      text += " It sticks and slides with a friction of " + words.number(element.friction) +
              ", by two bristles whose deflections are the states x." + element.name + "_bristle1 and x." +
              element.name + "_bristle2.";
    return text;
  }
  /// The sphere, and the surface that it touches.
  template <class Canvas>
  static void draw_shapes(Canvas& canvas, const SurfaceContact& element) {
    using enum SurfaceContact::Shape;
    canvas.ball(element.from, element.radius.value);
    if (element.shape == box) canvas.box(element.to, element.axes, element.size);
    if (element.shape == sphere) canvas.ball(element.to, element.other_radius.value);
    if (element.shape == cylinder)
      canvas.cylinder(element.to, element.axes, element.length, element.other_radius.value);
  }
  static constexpr StateNature nature = StateNature::bristle;
  template <class Use>
  static void states(const SurfaceContact& element, const Use& use) {
    if (!element.has_friction()) return;
    use(HiddenState{"_bristle1"});
    use(HiddenState{"_bristle2"});
  }
  static void silence(SurfaceContact& element) {
    element.push.stiffness = Quantity{};
    smooth(element);
  }
  static void smooth(SurfaceContact& element) { element.friction = element.stiction = Quantity{}; }
  static constexpr std::array bounds = {FieldBound{"radius", QuantityBound::not_negative},
                                        FieldBound{"to_radius", QuantityBound::positive},
                                        FieldBound{"length", QuantityBound::positive},
                                        FieldBound{"size", QuantityBound::positive},
                                        FieldBound{"stiffness", QuantityBound::not_negative},
                                        FieldBound{"damping", QuantityBound::not_negative},
                                        FieldBound{"friction", QuantityBound::not_negative},
                                        FieldBound{"stiction", QuantityBound::not_negative},
                                        FieldBound{"stribeck_velocity", QuantityBound::positive},
                                        FieldBound{"bristle", QuantityBound::positive},
                                        FieldBound{"bristle_damping", QuantityBound::not_negative},
                                        FieldBound{"elastic", QuantityBound::share}};
  template <class Use>
  static void fields(const SurfaceContact& element, const Use& use) {
    use("shape", kContactShapes[static_cast<std::size_t>(element.shape)]);
    use("radius", element.radius);
    use("axes", element.axes);
    use("to_radius", element.other_radius);
    use("length", element.length);
    use("size", element.size);
    use("stiffness", element.push.stiffness);
    use("exponent", element.push.exponent);
    use("damping", element.push.damping);
    use("friction", element.friction);
    use("stiction", element.stiction);
    use("stribeck_velocity", element.stribeck_velocity);
    use("bristle", element.bristle);
    use("bristle_damping", element.bristle_damping);
    use("elastic", element.elastic);
  }
};

}  // namespace mbgen
