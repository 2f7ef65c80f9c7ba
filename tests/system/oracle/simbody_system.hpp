#pragma once
// Contents of a Simbody system of a mechanism. Only simbody_*.cpp include this.

#include <Simbody.h>

#include <deque>
#include <vector>

#include "tests/system/oracle/simbody_mechanism.hpp"

namespace mbgen::foreign {

inline SimTK::Vec3 vec(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

/// Where Simbody keeps a coordinate of the mechanism.
struct SimbodyCoordinate {
  int body = -1;    ///< mobilizer, in the order they were made
  int place = 0;    ///< of its q and u
  double sign = 1;  ///< q = sign z
};

/// A rod with mass, and where its universal joint stands on the `from` body.
struct SimbodyRod {
  const ReferenceClosure* closure;
  SimTK::Transform frame;  ///< of the joint on the `from` body: z along the rod at the reference
  SimTK::Vec3 far_end;     ///< on the `to` body
  int body;                ///< mobilizer
};

/// A state in Simbody's own coordinates.
struct SimbodyState {
  SimTK::Vector q, u, force;
  double t = 0;
};

struct SimbodySystem {
  ReferenceMechanism mechanism;
  ForceElements elements;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::DiscreteForces tau{forces, matter};
  std::deque<SimTK::MobilizedBody> mobilizers;              ///< ground is not one of them
  std::vector<int> mobilizer_of;                            ///< per tree body
  std::vector<Eigen::Vector3d> origin;                      ///< of a tree body's frame, global at the reference
  std::vector<SimbodyCoordinate> coordinates;               ///< per tree body
  std::vector<SimbodyRod> rods;                             ///< with mass
  std::vector<std::vector<SimTK::Constraint>> constraints;  ///< per closure
  std::vector<SimTK::Constraint> drives;                    ///< per motion
  SimTK::State state;
  std::vector<SimbodyState> loaded;

  SimTK::MobilizedBody& body(int tree) {
    return tree == kGround ? static_cast<SimTK::MobilizedBody&>(matter.updGround()) : mobilizers[mobilizer_of[tree]];
  }
  const SimTK::MobilizedBody& body(int tree) const {
    return tree == kGround ? static_cast<const SimTK::MobilizedBody&>(matter.getGround())
                           : mobilizers[mobilizer_of[tree]];
  }
  /// A place that is given at the reference, on its Simbody body.
  SimTK::Vec3 local(int tree, const Eigen::Vector3d& place) const {
    const Eigen::Vector3d v = tree == kGround ? place : Eigen::Vector3d(place - origin[tree]);
    return {v[0], v[1], v[2]};
  }
};

/// Adds the force elements and the motions to a system that has its tree.
void add_elements(SimbodySystem& s);

/// A state with the rods with mass laid to their far ends.
SimbodyState native_state(SimbodySystem& s, const ForeignState& at);

/// Sets a state. stage: up to which it is realised.
void set_state(SimbodySystem& s, const SimbodyState& at, SimTK::Stage stage);

/// Coordinates and velocities of the mechanism. Requires: realised to velocity.
ForeignState foreign_state(const SimbodySystem& s, const SimTK::State& at);

}  // namespace mbgen::foreign
