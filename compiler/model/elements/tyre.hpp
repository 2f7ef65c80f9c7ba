#pragma once
// Tyres.

#include <optional>
#include <string>
#include <vector>

#include "compiler/model/elements/kind.hpp"

namespace mbgen {

enum class TyreModel { pac89, pac2002, mf61 };

/// Combined slip: by the set's coefficients, or by a friction ellipse, always used for pac89.
enum class CombinedSlip { set, ellipse };

/// An enveloping contact: four cams with the outline of a superellipse, a rear and a front one below the middle of each
/// half of the tyre's width, |s / length|^order + |z / height|^order = 1. Lengths in unloaded radii of the tyre.
struct TyreEnvelope {
  double base = 0;                           ///< distance of front and rear cams, > 0
  double length = 0, height = 0, order = 0;  ///< half axes along and down, > 0; exponent, >= 1
  double width = 0;                          ///< of the tyre on the road, > 0
  double steps = 0;                          ///< sampling intervals from wheel to cam centre, whole, >= 1

  /// The road is sampled at spacing() * i, i = -last_sample() ... last_sample().
  double spacing() const { return 0.5 * base / steps; }
  int last_sample() const;
};

/// "enveloping, base 0.4, ...", for people.
std::string to_text(const TyreEnvelope& envelope);

/// Torsional friction of the contact patch about the road's normal, as in TyreProperties in tyre.hpp.
struct TyrePatch {
  Quantity stiffness;  ///< N m/rad, against turning under `load`, > 0
  Quantity radius;     ///< m, moment of the turning patch over its friction under `load`, > 0
  Quantity load;       ///< N, > 0
};

/// Tyre of a wheel body on a road, or on a flat horizontal one (normal = global z).
struct Tyre {
  std::string name;
  Where where;
  Attachment centre;  ///< wheel centre, a point of the wheel body on its spin axis
  /// unit spin axis, GLOBAL axes at the reference; it points left for positive forward rolling
  Vector3 axis{0, 1, 0};
  TyreModel model = TyreModel::pac2002;
  /// in the order of kPac2002Fields or kMf61Fields, or a0.. b0.. c0.. of pac89 (runtime header tyre.hpp)
  std::vector<Quantity> coefficients;
  /// +1: coefficients used as they are, -1: mirrored (tyre measured on the other side)
  double side = 1;
  double count = 1;                      ///< 2 for twin tyres: all forces times count
  Quantity radius;                       ///< m, unloaded
  Quantity stiffness;                    ///< N/m, vertical, one tyre
  Quantity damping;                      ///< N s/m, vertical, one tyre
  int road = -1;                         ///< index into Model::roads, -1: flat and horizontal
  std::optional<TyreEnvelope> envelope;  ///< none: contact in one point
  Quantity road_height;                  ///< m, global z of the flat road; added to the height of one of Model::roads
  Quantity friction;                     ///< factor of the friction, 1: as measured
  /// 1: moment = -coefficient * load * radius * tanh(speed / low_speed); of mf61 its QSY1
  Quantity rolling_resistance;
  Quantity pressure;                              ///< Pa, of inflation; of mf61 alone
  Quantity relaxation_x, relaxation_y;            ///< m, relaxation lengths of the slips, at nominal load
  bool over_load_x = false, over_load_y = false;  ///< the set gives them as functions of the load
  Quantity low_speed;                             ///< m/s, below it slip is damped so that the wheel comes to rest
  std::optional<TyrePatch> parking;               ///< none: no moment against turning, and no state for it
  CombinedSlip combined_slip = CombinedSlip::set;
  bool turn_slip = false;  ///< turn slip of the set is active; mf61 only, always with `parking`
};

template <>
struct KindOf<Tyre> : KindDefaults {
  using Element = Tyre;
  static constexpr const char *key = "tyre", *section = "tyres", *words = "tyre";
  static constexpr std::array quantities = {ElementQuantity{"load", "N"},
                                            ElementQuantity{"longitudinal_force", "N"},
                                            ElementQuantity{"lateral_force", "N"},
                                            ElementQuantity{"aligning_moment", "N m"},
                                            ElementQuantity{"longitudinal_slip", "1"},
                                            ElementQuantity{"lateral_slip", "rad"}};
  static constexpr const char* shows = "state of a tyre, or angle of its wheel to a vehicle";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.tyres;
  }
  static Connection connection(const Tyre& element) { return OnBody{element.centre}; }
  static constexpr std::array bounds = {FieldBound{"radius", QuantityBound::positive},
                                        FieldBound{"stiffness", QuantityBound::positive},
                                        FieldBound{"damping", QuantityBound::not_negative},
                                        FieldBound{"friction", QuantityBound::not_negative},
                                        FieldBound{"rolling_resistance", QuantityBound::not_negative},
                                        FieldBound{"pressure", QuantityBound::positive},
                                        FieldBound{"relaxation_x", QuantityBound::positive},
                                        FieldBound{"relaxation_y", QuantityBound::positive},
                                        FieldBound{"low_speed", QuantityBound::positive}};
  template <class Use>
  static void fields(const Tyre& element, const Use& use) {
    use("axis", element.axis);
    use("count", element.count);
    use("radius", element.radius);
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    use("road_height", element.road_height);
    use("friction", element.friction);
    use("rolling_resistance", element.rolling_resistance);
    use("pressure", element.pressure);
    use("relaxation_x", element.relaxation_x);
    use("relaxation_y", element.relaxation_y);
    use("low_speed", element.low_speed);
  }
};

}  // namespace mbgen
