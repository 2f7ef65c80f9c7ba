#include "compiler/algebra/turns.hpp"

#include <cmath>

namespace mbgen {

Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double kOpposite = 1e-12;  // of the sum: below, it is rounding
  const Eigen::Vector3d a = from.normalized(), b = to.normalized(), sum = a + b;
  const double twice = sum.norm();  // the cosine of half the angle, without the cancellation in 1 + a . b
  if (twice > kOpposite) {
    const Eigen::Vector3d part = a.cross(sum) / twice;
    return Eigen::Quaterniond(twice / 2, part.x(), part.y(), part.z()).normalized();
  }
  const Eigen::Vector3d helper = std::abs(a.y()) < 0.9 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(1, 0, 0);
  const Eigen::Vector3d axis = a.cross(helper).normalized();
  return {0, axis.x(), axis.y(), axis.z()};
}

}  // namespace mbgen
