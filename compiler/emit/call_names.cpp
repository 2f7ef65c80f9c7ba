#include "compiler/emit/call_names.hpp"

namespace mbgen {

CallNames names_of_call(Op op) {
  switch (op) {
    case Op::atan:
      return {"mbgen::arc_tangents", "tangents", "", {"arcs"}, "", {}};
    case Op::exp:
      return {"mbgen::exponentials", "exponents", "", {"exponentials"}, "", {}};
    case Op::tanh:
      return {"mbgen::hyperbolic_tangents", "arguments", "", {"hyperbolic_tangents"}, "", {}};
    case Op::pow:
      return {"mbgen::powers", "bases", "exponents", {"powers"}, "", {}};
    default:
      return {"mbgen::sincos", "angles", "", {"sines", "cosines"}, "", {}};
  }
}

}  // namespace mbgen
