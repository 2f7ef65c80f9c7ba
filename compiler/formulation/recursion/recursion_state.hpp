#pragma once
// Data that the passes of the recursive form share, and their results.

#include <string>
#include <variant>

#include "compiler/formulation/driven.hpp"
#include "compiler/formulation/elements/applied_forces.hpp"
#include "compiler/formulation/loop_solution.hpp"
#include "compiler/formulation/recursion/recursion_closure.hpp"
#include "compiler/formulation/recursion/recursion_elimination.hpp"

namespace mbgen {

/// How much inertia a free direction moves.
template <class T>
struct DirectionInertia {
  int block = -1;  ///< index into Topology::blocks, -1 outside
  int place = 0;   ///< of the direction in its block, outside blocks its coordinate
  T value{0.0};    ///< not positive: none
};

/// Result of the recursive form.
template <class T>
struct RecursiveSolution {
  std::vector<T> zdd;      ///< per coordinate
  std::vector<T> quality;  ///< per block: smallest |pivot| / reference
  std::vector<DirectionInertia<T>> inertia;
};

/// How a loop block follows its free directions: by its frozen partition over (quasi-)velocities, or by a projection
/// over joint rates that was chosen at run time.
template <class T>
using BlockProjection = std::variant<LoopPartition, GroupProjection<T>>;

namespace detail {

/// Inertias that move with a body and their forces, about the body's origin in the frame that carries it (own frame, or
/// its block's base frame).
template <class T>
struct CompositeBody {
  PseudoInertia<T> rigid;         ///< of the body itself and of arms on it: its angular velocity acts on it as a whole
  PseudoInertia<T> above;         ///< of the blocks' bodies on it, whose velocities `needed` has taken in already
  ArticulatedInertia<T> reduced;  ///< the change of it by eliminated units
  Spatial<T> needed;              ///< force that must be given at zero acceleration, applied forces taken off
};

/// A joint of an opened block: zdd = (force - momentum . a - closure . lambda) / mass, with a the acceleration of its
/// body by the joints before it and lambda the multipliers of the block's loops.
template <class T>
struct OpenedJoint {
  UnitEquations<T> motion;  ///< of its one direction, about the body's origin; none where it is driven
  std::vector<T> closure;   ///< per multiplier
};

/// Values of a block that its solution needs on the way back.
template <class T>
struct BlockParts {
  std::vector<std::string> directions;         ///< names of the free directions, in programs for reading
  const GroupProjection<T>* chosen = nullptr;  ///< the projection over joint rates, where it was chosen at run time
  FrozenFactors<T> factors;
  std::vector<std::vector<T>> rz;
  std::vector<T> zdd_star;                   ///< per local column: accelerations at zero free ones
  PerBody<Spatial<T>> velocity;              ///< against the base
  PerBody<BodyAcceleration<T>> bias;         ///< at zero accelerations
  std::vector<PerBody<Spatial<T>>> partial;  ///< per free direction: motion of the bodies
  PerBody<Spatial<T>> zdd_star_motion;       ///< motion for `zdd_star`
  // of an opened block alone, whose equations are those of its multipliers:
  const LoopPartition* partition = nullptr;
  PerBody<OpenedJoint<T>> opened;
  std::vector<T> compliance;  ///< per multiplier: of its row alone
};

/// Values of a run that its solution needs on the way back.
template <class T>
struct RunParts {
  std::vector<Spatial<T>> directions;  ///< motion of the end per free (quasi-)velocity
  std::vector<int> columns;            ///< their tree joints
  Vector<T> before;                    ///< angular velocity of the base, end's axes
  Vector<T> carried;                   ///< acceleration of the end's place as a point of the base, by its velocities
  Spatial<T> bias;                     ///< acceleration of the end at zero (quasi-)accelerations, less that
};

/// The recursion in the making: the passes of recursive_accelerations share it.
template <class T>
struct RecursionState {
  const RecursionWork<T>& work;
  const std::vector<Drive<T>>& drives;
  std::vector<PseudoInertia<T>> constant;   ///< per tree body in its axes: with rotors and rods' ends
  std::vector<T> polar;                     ///< per tree body: a rotor's inertia about its axis
  std::vector<T> velocity;                  ///< per joint: (quasi-)velocities
  std::vector<Vector<T>> omega;             ///< per tree body: angular velocity in the frame that carries it
  std::vector<CompositeBody<T>> composite;  ///< per tree body
  std::vector<BlockParts<T>> blocks;        ///< per Recursion::units, empty where not a block
  std::vector<RunParts<T>> runs;            ///< likewise
  std::vector<UnitEquations<T>> equations;  ///< per unit
  std::vector<Spatial<T>> acceleration;     ///< per tree body about its origin in its carrying frame
  std::vector<T> force;                     ///< per joint: of the (quasi-)velocities
  double rounding = 0;                      ///< of the inertias of a block, see inertia_left_by_rounding

  const System<T>& system() const { return work.system; }
  const Kinematics<T>& k() const { return work.k; }
  const std::vector<RecursionUnit>& units() const { return work.recursion.units; }
  const T* driven(int joint) const {
    for (const Drive<T>& d : drives)
      if (d.coordinate == joint) return &d.acceleration;
    return nullptr;
  }
  /// Origin of a unit's end from the origin of its base body, in the axes of the frame that carries the base body.
  Vector<T> from_base(const RecursionUnit& unit, int body) const {
    const Vector<T>& at = k().position[body];
    return unit.base == kGround || work.own(unit.base) ? at : at - k().position[unit.base];
  }
  /// An inertia given in the axes of a body, in the axes of its base frame.
  PseudoInertia<T> in_base_axes(int body, const PseudoInertia<T>& m) const {
    const std::string& name = system().body_name(body);
    const PseudoInertia<T> now = turned(k().orientation[body], system().topology.bodies[body].axis, k().axis[body], m,
                                        [&](const T& across, const T& along, const T& reciprocal) {
                                          system().annotator.detail(across, "Kacross_", name);
                                          system().annotator.detail(along, "Kalong_", name);
                                          system().annotator.detail(reciprocal, "per_m_", name);
                                        });
    detail_inertia(system().annotator, now, "hb_", "Kb_", "Ib_", name);
    return now;
  }
  const Vector<T> omega_of(int body) const { return body == kGround ? Vector<T>{} : omega[body]; }
};

}  // namespace detail

}  // namespace mbgen
