#pragma once
// Titles and names for the values that the formulation makes: nothing for numbers, sections and labels for symbols.

#include <string>

#include "compiler/formulation/vector.hpp"

namespace mbgen {

/// The nine steps of the paper's tables 1 and 2, in order.
enum class Step {
  inertias = 1,
  jacobian,
  projection,
  velocities,
  forces,
  closure_bias,
  accelerations,
  reduced_system,
  solution
};

/// Receives step, place and name of the values in the making. This one, for numbers, ignores them.
template <class T>
struct Scribe {
  void step(Step) {}
  /// A step of one part of the mechanism.
  void step(Step, const std::string&) {}
  void place(const std::string&) {}
  /// parts: of the name; where nobody reads it, nobody puts it together.
  template <class... Parts>
  void name(const T&, const Parts&...) {}
};

/// Whether a value is known to be zero when the equations are written: then work on it is not done at all.
inline bool is_zero(double value) { return value == 0.0; }

/// Size of a value that is known when the equations are written, 0 of any other.
inline double known_size(double value) { return std::abs(value); }

template <class T, class... Parts>
void name(Scribe<T>& scribe, const Vector<T>& v, const Parts&... parts) {
  scribe.name(v.x, parts..., "_x");
  scribe.name(v.y, parts..., "_y");
  scribe.name(v.z, parts..., "_z");
}
template <class T, class... Parts>
void name(Scribe<T>& scribe, const Matrix<T>& m, const Parts&... parts) {
  name(scribe, Vector<T>{m.x.x, m.y.x, m.z.x}, parts..., "_x");
  name(scribe, Vector<T>{m.x.y, m.y.y, m.z.y}, parts..., "_y");
  name(scribe, Vector<T>{m.x.z, m.y.z, m.z.z}, parts..., "_z");
}
template <class T>
void name(Scribe<T>& scribe, const Spatial<T>& s, const char* linear, const char* angular, const std::string& of) {
  name(scribe, s.linear, linear, "_", of);
  name(scribe, s.angular, angular, "_", of);
}

}  // namespace mbgen
