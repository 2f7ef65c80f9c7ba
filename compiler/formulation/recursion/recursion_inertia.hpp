#pragma once
// Inertias of the recursive form: rigid ones by their pseudo-inertia, articulated ones by the terms that elimination
// adds.

#include <optional>
#include <utility>
#include <vector>

#include "compiler/formulation/kinematics.hpp"

namespace mbgen {

template <class T>
T trace(const Symmetric<T>& s) {
  return s.xx + s.yy + s.zz;
}

/// Ten parameters about an origin: mass, first moment s (integral of r dm), K (integral of r r' dm), kg m^2; and the
/// trace of K, which turning does not change.
template <class T>
struct PseudoInertia {
  T mass{0.0};
  Vector<T> moment;
  Symmetric<T> second;
  T trace{0.0};
};

template <class T>
PseudoInertia<T> pseudo_inertia(const T& mass, const Vector<T>& moment, const Symmetric<T>& second) {
  return {mass, moment, second, trace(second)};
}

/// Traces that are known when the equations are written stay known; of others nothing is kept but the entries.
template <class T>
T summed_trace(const T& a, const T& b, const Symmetric<T>& sum) {
  const auto is_known = [](const T& value) { return is_zero(value) || known_size(value) > 0; };
  return is_known(a) && is_known(b) ? a + b : trace(sum);
}

template <class T>
PseudoInertia<T> operator+(const PseudoInertia<T>& a, const PseudoInertia<T>& b) {
  const Symmetric<T> second = a.second + b.second;
  return {a.mass + b.mass, a.moment + b.moment, second, summed_trace(a.trace, b.trace, second)};
}

/// scale a b' + b a', symmetric.
template <class T>
Symmetric<T> symmetric_product(const Vector<T>& a, const Vector<T>& b) {
  const Vector<T> twice = b + b;
  return {a.x * twice.x,         a.y * twice.y,         a.z * twice.z,
          a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, a.y * b.z + a.z * b.y};
}

/// scale a a'.
template <class T>
Symmetric<T> square(const T& scale, const Vector<T>& a) {
  const Vector<T> s = scale * a;
  return {s.x * a.x, s.y * a.y, s.z * a.z, s.x * a.y, s.x * a.z, s.y * a.z};
}

/// About a new origin; place: of the old one, seen from the new one.
template <class T>
PseudoInertia<T> shifted(const Vector<T>& place, const PseudoInertia<T>& m) {
  const Vector<T> half = T(0.5) * m.mass * place;
  return pseudo_inertia(m.mass, m.moment + m.mass * place, m.second + symmetric_product(m.moment + half, place));
}

/// Whether a unit vector is known to lie along a coordinate axis.
template <class T>
bool is_coordinate_axis(const Vector<T>& a) {
  return known_size(a.x) == 1.0 || known_size(a.y) == 1.0 || known_size(a.z) == 1.0;
}

/// r k r', one entry of the diagonal by the trace: the last one that r turns.
template <class T>
Symmetric<T> rotated_second(const Matrix<T>& r, const Symmetric<T>& k, const T& trace) {
  const Vector<T> row_x{r.x.x, r.y.x, r.z.x}, row_y{r.x.y, r.y.y, r.z.y}, row_z{r.x.z, r.y.z, r.z.z};
  const Vector<T> x = k * row_x, y = k * row_y;
  const T xx = dot(row_x, x), xy = dot(row_y, x), xz = dot(row_z, x), yz = dot(row_z, y);
  if (!is_coordinate_axis(row_z)) {
    const T yy = dot(row_y, y);
    return {xx, yy, trace - xx - yy, xy, xz, yz};
  }
  const T zz = dot(row_z, k * row_z);
  return {xx, (trace - zz) - xx, zz, xy, xz, yz};
}

template <class T>
PseudoInertia<T> rotated(const Matrix<T>& r, const PseudoInertia<T>& m) {
  return {m.mass, r * m.moment, rotated_second(r, m.second, m.trace), m.trace};
}

/// Entries that cancelled but for rounding become zero.
template <class T>
Symmetric<T> entries_without_noise(const Symmetric<T>& s, const T& size) {
  const auto entry = [&](const T& value) { return without_noise(value, known_size(size)); };
  return {entry(s.xx), entry(s.yy), entry(s.zz), entry(s.xy), entry(s.xz), entry(s.yz)};
}

/// From a central inertia: J = tr(K) I - K.
template <class T>
PseudoInertia<T> from_central(const T& mass, const Vector<T>& com, const Symmetric<T>& central) {
  const T half = T(0.5) * (central.xx + central.yy + central.zz);
  const Symmetric<T> own{half - central.xx, half - central.yy, half - central.zz,
                         -central.xy,       -central.xz,       -central.yz};
  return pseudo_inertia(mass, mass * com, own + square(mass, com));
}

/// The same about the centre of mass, with no first moment. Requires: mass.
template <class T>
PseudoInertia<T> centred(const PseudoInertia<T>& m) {
  const Vector<T> com = (T(1.0) / m.mass) * m.moment;
  return pseudo_inertia(m.mass, Vector<T>{}, entries_without_noise(m.second + square(-m.mass, com), m.trace));
}

/// J about the origin: tr(K) I - K by a trace that is a constant, else by sums of two entries.
template <class T>
Symmetric<T> inertia_matrix(const PseudoInertia<T>& m) {
  const Symmetric<T>& k = m.second;
  if (known_size(m.trace) > 0) return {m.trace - k.xx, m.trace - k.yy, m.trace - k.zz, -k.xy, -k.xz, -k.yz};
  return {k.yy + k.zz, k.xx + k.zz, k.xx + k.yy, -k.xy, -k.xz, -k.yz};
}

/// Names the entries of a rigid inertia in programs for reading: first moments, second moments, and J.
template <class T, class... Parts>
void detail_inertia(Annotator<T>& annotator, const PseudoInertia<T>& m, const char* h, const char* k, const char* j,
                    const Parts&... parts) {
  if (!annotator.has_details()) return;
  detail_name(annotator, m.moment, h, parts...);
  detail_name(annotator, m.second, k, parts...);
  detail_name(annotator, inertia_matrix(m), j, parts...);
}

/// lambda 1 + delta u u', the second moments about the centre of mass of a body that is symmetric about u.
template <class T>
struct AxialMoments {
  T lambda{0.0}, delta{0.0};
};

/// The second moments by that form, where a is an axis of symmetry as far as is known when the equations are written.
template <class T>
std::optional<AxialMoments<T>> axial_moments(const PseudoInertia<T>& central, const Vector<T>& a) {
  const Symmetric<T>& k = central.second;
  const T along = dot(a, k * a), across = T(0.5) * (central.trace - along);
  const AxialMoments<T> form{across, along - across};
  const Symmetric<T> turned = square(-form.delta, a);
  const T minus = -across;
  const Symmetric<T> rest =
      entries_without_noise(k + turned + Symmetric<T>{minus, minus, minus, T(0.0), T(0.0), T(0.0)}, central.trace);
  for (const T& entry : {rest.xx, rest.yy, rest.zz, rest.xy, rest.xz, rest.yz})
    if (!is_zero(entry)) return std::nullopt;
  return form;
}

/// Whether r is known to turn about a coordinate axis.
template <class T>
bool turns_in_a_plane(const Matrix<T>& r) {
  const Matrix<T> rows = transpose(r);
  return is_coordinate_axis(rows.x) || is_coordinate_axis(rows.y) || is_coordinate_axis(rows.z);
}

/// No names for the moments of a symmetric body.
struct UnnamedMoments {
  template <class... Anything>
  void operator()(const Anything&...) const {}
};

/// A constant inertia rotated by r. For a body with an axis of symmetry through its centre of mass only this axis and
/// the centre are rotated: K = lambda 1 + delta u u' + m c c'. axis: of the body's joint, in the body and at present; a
/// rotation in a plane takes fewer operations on K if the axis of symmetry is another one.
template <class T, class Names = UnnamedMoments>
PseudoInertia<T> turned(const Matrix<T>& r, const Vector3& axis, const Vector<T>& axis_now, const PseudoInertia<T>& m,
                        const Names& name_moments = {}) {
  if (is_zero(m.mass) || !(known_size(m.trace) > 0)) return rotated(r, m);
  const PseudoInertia<T> central = centred(m);
  const Matrix<T> e = identity<T>();
  std::vector<std::pair<Vector<T>, Vector<T>>> candidates{{constant<T>(axis), axis_now}};
  if (!turns_in_a_plane(r)) candidates.insert(candidates.end(), {{e.x, r.x}, {e.y, r.y}, {e.z, r.z}});
  for (const auto& [own, u] : candidates) {
    const std::optional<AxialMoments<T>> form = axial_moments(central, own);
    if (!form) continue;
    const T reciprocal = T(1.0) / m.mass;
    name_moments(form->lambda, form->delta, reciprocal);
    const Vector<T> moment = r * m.moment, com = reciprocal * moment, scaled = form->delta * u;
    const T xx = form->lambda + scaled.x * u.x + moment.x * com.x;
    const T xy = scaled.x * u.y + moment.x * com.y, xz = scaled.x * u.z + moment.x * com.z,
            yz = scaled.y * u.z + moment.y * com.z;
    if (!is_coordinate_axis(transpose(r).z)) {
      const T yy = form->lambda + scaled.y * u.y + moment.y * com.y;
      return {m.mass, moment, {xx, yy, m.trace - xx - yy, xy, xz, yz}, m.trace};
    }
    const T zz = form->lambda + scaled.z * u.z + moment.z * com.z;
    return {m.mass, moment, {xx, (m.trace - zz) - xx, zz, xy, xz, yz}, m.trace};
  }
  return rotated(r, m);
}

/// Momentum about the origin of a motion about the origin.
template <class T>
Spatial<T> operator*(const PseudoInertia<T>& m, const Spatial<T>& motion) {
  return {m.mass * motion.linear + cross(motion.angular, m.moment),
          cross(m.moment, motion.linear) + inertia_matrix(m) * motion.angular};
}

/// Force and moment for an acceleration field a + g r. If two entries across an axis are known to be opposite, the
/// moment about it is due to an angular acceleration alone, by J.
template <class T>
Spatial<T> field_force(const PseudoInertia<T>& m, const Vector<T>& a, const Matrix<T>& g) {
  const Symmetric<T>&k = m.second, j = inertia_matrix(m);
  const auto across = [](const T& g_ab, const T& g_ba, const T& k_a, const T& k_b, const T& about) {
    return is_zero(g_ab + g_ba) ? g_ab * about : g_ab * k_b - g_ba * k_a;
  };
  const Vector<T> moment{across(g.y.z, g.z.y, k.zz, k.yy, j.xx) + (g.z.z - g.y.y) * k.yz + g.x.z * k.xy - g.x.y * k.xz,
                         across(g.z.x, g.x.z, k.xx, k.zz, j.yy) + (g.x.x - g.z.z) * k.xz + g.y.x * k.yz - g.y.z * k.xy,
                         across(g.x.y, g.y.x, k.yy, k.xx, j.zz) + (g.y.y - g.x.x) * k.xy + g.z.y * k.xz - g.z.x * k.yz};
  return {m.mass * a + g * m.moment, cross(m.moment, a) + moment};
}

/// Symmetric 6x6 operator from acceleration to force about an origin: force = linear a + coupling alpha,
/// moment = coupling' a + angular alpha.
template <class T>
struct ArticulatedInertia {
  Symmetric<T> linear, angular;
  Matrix<T> coupling{};
};

template <class T>
Matrix<T> operator+(const Matrix<T>& a, const Matrix<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T>
ArticulatedInertia<T> operator+(const ArticulatedInertia<T>& a, const ArticulatedInertia<T>& b) {
  return {a.linear + b.linear, a.angular + b.angular, a.coupling + b.coupling};
}

/// A rigid inertia as an operator.
template <class T>
ArticulatedInertia<T> articulated(const PseudoInertia<T>& m) {
  const Vector<T>& s = m.moment;
  const T zero(0.0);
  return {{m.mass, m.mass, m.mass, zero, zero, zero},
          inertia_matrix(m),
          {{zero, -s.z, s.y}, {s.z, zero, -s.x}, {-s.y, s.x, zero}}};
}

template <class T>
Spatial<T> operator*(const ArticulatedInertia<T>& m, const Spatial<T>& a) {
  return {m.linear * a.linear + m.coupling * a.angular, transposed_times(m.coupling, a.linear) + m.angular * a.angular};
}

template <class T>
ArticulatedInertia<T> rotated(const Matrix<T>& r, const ArticulatedInertia<T>& m) {
  return {rotated(r, m.linear), rotated(r, m.angular), r * (m.coupling * transpose(r))};
}

/// d x each column.
template <class T>
Matrix<T> crossed(const Vector<T>& d, const Matrix<T>& m) {
  return {cross(d, m.x), cross(d, m.y), cross(d, m.z)};
}

/// About a new origin; place: of the old one, seen from the new one.
template <class T>
ArticulatedInertia<T> shifted(const Vector<T>& place, const ArticulatedInertia<T>& m) {
  const Symmetric<T>& l = m.linear;
  const Matrix<T> linear{{l.xx, l.xy, l.xz}, {l.xy, l.yy, l.yz}, {l.xz, l.yz, l.zz}};
  const Matrix<T> turned = crossed(place, linear);  // place~ L = -(L place~)'
  const Matrix<T> coupling = m.coupling + transpose(turned);
  const Matrix<T> near = crossed(place, coupling), far = crossed(place, m.coupling);
  const Symmetric<T>& a = m.angular;
  return {l,
          {a.xx + (near.x.x + far.x.x), a.yy + (near.y.y + far.y.y), a.zz + (near.z.z + far.z.z),
           a.xy + (near.y.x + far.x.y), a.xz + (near.z.x + far.x.z), a.yz + (near.z.y + far.y.z)},
          coupling};
}

/// Less a dyad: m - (scaled) f' for scaled a multiple of f.
template <class T>
ArticulatedInertia<T> less_dyad(const ArticulatedInertia<T>& m, const Spatial<T>& scaled, const Spatial<T>& f) {
  const auto less = [](const Symmetric<T>& s, const Vector<T>& a, const Vector<T>& b) {
    return Symmetric<T>{s.xx - a.x * b.x, s.yy - a.y * b.y, s.zz - a.z * b.z,
                        s.xy - a.x * b.y, s.xz - a.x * b.z, s.yz - a.y * b.z};
  };
  const Vector<T>&l = scaled.linear, &n = f.angular;
  return {less(m.linear, scaled.linear, f.linear), less(m.angular, scaled.angular, f.angular),
          m.coupling - Matrix<T>{n.x * l, n.y * l, n.z * l}};
}

/// The same wrench about an origin from which the old one is seen at `place`.
template <class T>
Spatial<T> shifted(const Vector<T>& place, const Spatial<T>& wrench) {
  return {wrench.linear, wrench.angular + cross(place, wrench.linear)};
}

template <class T>
Spatial<T> rotated(const Matrix<T>& r, const Spatial<T>& s) {
  return {r * s.linear, r * s.angular};
}

}  // namespace mbgen
