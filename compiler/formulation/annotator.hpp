#pragma once
// Origins and names of the values that the formulation makes: nothing for numbers, sections, owners and labels for
// symbols.

#include <string>
#include <vector>

#include "compiler/formulation/vector.hpp"
#include "compiler/origin/origin.hpp"

namespace mbgen {

/// Receives step, owner and name of the values in the making. This one, for numbers, ignores them, and counts owners.
template <class T>
struct Annotator {
  unsigned parts = 0;  ///< parts of the mechanism that were entered: tells the element in hand from the others
  struct Scope {
    ~Scope() {}  // NOLINT: a destructor that does something, so that no compiler calls a scope unused
  };
  /// Values made while the result lives belong to this step; block: index of the loop block that is taken through it,
  /// -1 for the whole mechanism.
  [[nodiscard]] Scope step(Step, int /*block*/ = -1) { return {}; }
  /// Values made while the result lives belong to this part of the mechanism.
  [[nodiscard]] Scope within(OwnerKind, std::size_t /*index*/) {
    ++parts;
    return {};
  }
  /// parts: of the name; where nobody reads it, nobody puts it together.
  template <class... Parts>
  void name(const T&, const Parts&...) {}
  /// Names a number of the model. parts: as in `name`.
  template <class... Parts>
  void constant(T&, const Parts&...) {}
  /// Names a value or a number of programs for reading, where everything has a name; no other program changes by it.
  template <class... Parts>
  void detail(const T&, const Parts&...) {}
  /// The same of a number that has a shorter form of equal value: its definition.
  template <class... Parts>
  void detail_by(const T& /*number*/, const T& /*form*/, const Parts&...) {}
  /// Whether `detail` names anything: else whoever computes for names alone computes nothing.
  static constexpr bool has_details() { return false; }
  /// The same as `detail` of a number that bounds something. note: says what it bounds.
  template <class... Parts>
  void bound(T&, const char* /*note*/, const Parts&...) {}
  /// The same as `within`, in programs for reading.
  [[nodiscard]] Scope detail_within(OwnerKind, std::size_t /*index*/) { return {}; }
};

/// Values made while the result lives belong to a body of the tree with its coordinate, a loop, or a loop block; index:
/// into the list of the topology.
template <class Annotator, class Index>
[[nodiscard]] auto within_body(Annotator& annotator, Index index) {
  return annotator.within(OwnerKind::tree_body, static_cast<std::size_t>(index));
}
template <class Annotator, class Index>
[[nodiscard]] auto within_loop(Annotator& annotator, Index index) {
  return annotator.within(OwnerKind::loop, static_cast<std::size_t>(index));
}
template <class Annotator, class Index>
[[nodiscard]] auto within_block(Annotator& annotator, Index index) {
  return annotator.within(OwnerKind::loop_block, static_cast<std::size_t>(index));
}
/// The same of a loop block, in programs for reading.
template <class Annotator, class Index>
[[nodiscard]] auto detail_within_block(Annotator& annotator, Index index) {
  return annotator.detail_within(OwnerKind::loop_block, static_cast<std::size_t>(index));
}

/// Index of an item of a list.
template <class Item>
std::size_t index_in(const std::vector<Item>& list, const Item& item) {
  return static_cast<std::size_t>(&item - list.data());
}

/// Whether a value is known to be zero when the equations are written: then work on it is not done at all.
inline bool is_zero(double value) { return value == 0.0; }

/// Size of a value that is known when the equations are written, 0 of any other.
inline double known_size(double value) { return std::abs(value); }

template <class T, class... Parts>
void name(Annotator<T>& annotator, const Vector<T>& v, const Parts&... parts) {
  annotator.name(v.x, parts..., "_x");
  annotator.name(v.y, parts..., "_y");
  annotator.name(v.z, parts..., "_z");
}
template <class T, class... Parts>
void name(Annotator<T>& annotator, const Matrix<T>& m, const Parts&... parts) {
  name(annotator, Vector<T>{m.x.x, m.y.x, m.z.x}, parts..., "_x");
  name(annotator, Vector<T>{m.x.y, m.y.y, m.z.y}, parts..., "_y");
  name(annotator, Vector<T>{m.x.z, m.y.z, m.z.z}, parts..., "_z");
}
/// Names of programs for reading, see Annotator::detail.
template <class T, class... Parts>
void detail_name(Annotator<T>& annotator, const Vector<T>& v, const Parts&... parts) {
  annotator.detail(v.x, parts..., "_x");
  annotator.detail(v.y, parts..., "_y");
  annotator.detail(v.z, parts..., "_z");
}
template <class T, class... Parts>
void detail_name(Annotator<T>& annotator, const Symmetric<T>& s, const Parts&... parts) {
  annotator.detail(s.xx, parts..., "_xx");
  annotator.detail(s.yy, parts..., "_yy");
  annotator.detail(s.zz, parts..., "_zz");
  annotator.detail(s.xy, parts..., "_xy");
  annotator.detail(s.xz, parts..., "_xz");
  annotator.detail(s.yz, parts..., "_yz");
}
template <class T, class... Parts>
void detail_name(Annotator<T>& annotator, const Matrix<T>& m, const Parts&... parts) {
  detail_name(annotator, Vector<T>{m.x.x, m.y.x, m.z.x}, parts..., "_x");
  detail_name(annotator, Vector<T>{m.x.y, m.y.y, m.z.y}, parts..., "_y");
  detail_name(annotator, Vector<T>{m.x.z, m.y.z, m.z.z}, parts..., "_z");
}
template <class T, class... Parts>
void detail_name(Annotator<T>& annotator, const Spatial<T>& s, const char* linear, const char* angular,
                 const Parts&... parts) {
  detail_name(annotator, s.linear, linear, "_", parts...);
  detail_name(annotator, s.angular, angular, "_", parts...);
}

template <class T, class... Parts>
void name_constant(Annotator<T>& annotator, Vector<T>& v, const Parts&... parts) {
  annotator.constant(v.x, parts..., "_x");
  annotator.constant(v.y, parts..., "_y");
  annotator.constant(v.z, parts..., "_z");
}
template <class T, class... Parts>
void name_constant(Annotator<T>& annotator, Symmetric<T>& s, const Parts&... parts) {
  annotator.constant(s.xx, parts..., "_xx");
  annotator.constant(s.yy, parts..., "_yy");
  annotator.constant(s.zz, parts..., "_zz");
  annotator.constant(s.xy, parts..., "_xy");
  annotator.constant(s.xz, parts..., "_xz");
  annotator.constant(s.yz, parts..., "_yz");
}
template <class T>
void name(Annotator<T>& annotator, const Spatial<T>& s, const char* linear, const char* angular,
          const std::string& of) {
  name(annotator, s.linear, linear, "_", of);
  name(annotator, s.angular, angular, "_", of);
}

}  // namespace mbgen
