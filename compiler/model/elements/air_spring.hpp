#pragma once
// Air springs.

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Polytropic air spring between two points: p V^n = const; the force (p - p_ambient) A(l) pushes the points apart.
struct AirSpring {
  std::string name;
  Where where;
  Attachment from, to;
  Quantity pressure;               ///< Pa absolute, at the reference length
  Quantity ambient;                ///< Pa absolute
  Quantity exponent;               ///< polytropic exponent
  std::optional<Quantity> length;  ///< m, reference length; without it the reference distance
  Law area;                        ///< m^2: constant, or a table over length (m)
  /// m^3 over length (m); without it volume0 + area(length0) * (l - length0)
  std::optional<Table> volume;
  Quantity volume0;  ///< m^3 at the reference length (used without `volume`)
};

template <>
struct KindOf<AirSpring> : KindDefaults {
  using Element = AirSpring;
  static constexpr const char *key = "air_spring", *section = "air_springs", *words = "air spring";
  static constexpr const char* source = "spring";
  static constexpr bool is_elastic = true, has_length = true;
  static constexpr std::array quantities = {ElementQuantity{"force", "N"}, ElementQuantity{"length", "m"},
                                            ElementQuantity{"rate", "m/s"}};
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.air_springs;
  }
  static Connection connection(const AirSpring& element) { return BetweenPoints{element.from, element.to}; }
  static constexpr std::array bounds = {
      FieldBound{"pressure", QuantityBound::positive}, FieldBound{"ambient", QuantityBound::not_negative},
      FieldBound{"exponent", QuantityBound::positive}, FieldBound{"length", QuantityBound::positive},
      FieldBound{"area", QuantityBound::positive},     FieldBound{"volume0", QuantityBound::positive}};
  template <class Use>
  static void fields(const AirSpring& element, const Use& use) {
    use("pressure", element.pressure);
    use("ambient", element.ambient);
    use("exponent", element.exponent);
    use("length", element.length);
    use("area", element.area);
    use("volume", element.volume);
    use("volume0", element.volume0);
  }
  /// A rig takes it away: it stays, without force.
  static void silence(AirSpring& element) {
    element.area = Quantity(0.0);
    element.volume.reset();
  }
};

}  // namespace mbgen
