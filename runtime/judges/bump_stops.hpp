#pragma once
// Bump stops in Cartesian coordinates.

#include "runtime/judges/mechanism.hpp"

namespace mbgen::cartesian {

/// A bump stop at one instant.
struct StopAtWork {
  double penetration = 0, rate = 0, force = 0;        ///< m or rad, per second, N or N m
  Eigen::Vector3d on_from = Eigen::Vector3d::Zero();  ///< between points: force on `from`, global axes, N
};

StopAtWork stop_at_work(const BumpStop& stop, const PartStop& part, const std::vector<Moving>& bodies,
                        const Values& value);

/// Adds the loads of all bump stops.
void add_bump_stops(const Model& model, const Parts& parts, const std::vector<Moving>& bodies, const Values& values,
                    Forces& forces);

}  // namespace mbgen::cartesian
