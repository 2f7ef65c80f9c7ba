#pragma once
// Inertias that a rigid body may have, for parameters that are set at run time.

#include <cmath>

namespace mbgen {

/// Entries of an inertia, or of another symmetric matrix, kg m^2.
struct BodyInertia {
  double xx, yy, zz, xy, xz, yz;
};

/// No eigenvalue is below -slack, by the principal minors. True for NaN, which has its own status.
inline bool is_semidefinite(const BodyInertia& m, double slack) noexcept {
  const double a = m.xx + slack, b = m.yy + slack, c = m.zz + slack;
  const double ab = a * b - m.xy * m.xy, ac = a * c - m.xz * m.xz, bc = b * c - m.yz * m.yz;
  const double all = c * ab + 2 * m.xy * m.xz * m.yz - a * m.yz * m.yz - b * m.xz * m.xz;
  return !(a < 0 || b < 0 || c < 0 || ab < 0 || ac < 0 || bc < 0 || all < 0);
}

/// kg m^2: inertias typed with few digits pass, wrong ones do not.
inline double inertia_slack(const BodyInertia& m) noexcept { return 1e-9 * std::fabs(m.xx + m.yy + m.zz); }

/// A principal moment exceeds the sum of the others: half the trace less the inertia is negative in its direction.
inline bool breaks_triangle(const BodyInertia& m) noexcept {
  const double half = 0.5 * (m.xx + m.yy + m.zz);
  return !is_semidefinite({half - m.xx, half - m.yy, half - m.zz, -m.xy, -m.xz, -m.yz}, inertia_slack(m));
}

/// Whether a body can have this inertia. as_written: of the model; a violation of the triangle inequality there is
/// accepted.
inline bool is_inertia(const BodyInertia& m, const BodyInertia& as_written) noexcept {
  return is_semidefinite(m, inertia_slack(m)) && (breaks_triangle(as_written) || !breaks_triangle(m));
}

}  // namespace mbgen
