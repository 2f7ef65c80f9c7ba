#pragma once
// Properties that hold for every mechanism, and how they are compared.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/support/mechanism_support.hpp"
#include "tests/system/property/random_mechanism.hpp"

namespace mbgen::testing {

/// Nothing where the property holds.
using Complaint = std::optional<std::string>;

struct Property {
  const char* name;
  Complaint (*violated)(const RandomMechanism&, const Mechanism&);
};

std::span<const Property> properties();

/// Read, its tree built and analysed. Fails: as these do.
Result<Mechanism> understood(const RandomMechanism& random);

/// Consistent states that are not near a singular position.
std::vector<GenericState> good_states(const Mechanism& m, int wanted);

constexpr double kTolerance = 1e-8;  ///< of the largest acceleration

/// A complaint about `what` where the relative error is not below the tolerance.
Complaint differ(const std::string& what, const std::vector<double>& actual, const std::vector<double>& expected,
                 double tolerance);

/// The equations of an implicit step: the optimised programs give the changes of the generic runtime.
Complaint implicit_equations_disagree(const RandomMechanism& random, const Mechanism& m);

/// Implicit steps of the emitted solver, compiled, and of the generic runtime have the same limit.
Complaint implicit_steps_disagree(const RandomMechanism& random, const Mechanism& m);

/// All outputs of the Cartesian judges, with force and moment of every joint and rod where these are unique, and their
/// energies are those of the generic runtime.
Complaint outputs_of_judges_disagree(const RandomMechanism& random, const Mechanism& m);

/// The momentum of every body changes by the forces of joints and rods, and its weight. Springs and bushings are left
/// out.
Complaint reactions_do_not_move_bodies(const RandomMechanism& random, const Mechanism& m);

/// Forces of motors for random accelerations: the judge and the optimised program find those of the generic runtime,
/// and accelerations under them are the given ones.
Complaint inverse_dynamics_disagrees(const RandomMechanism& random, const Mechanism& m);

int from_environment(const char* name, int otherwise);

}  // namespace mbgen::testing
