#pragma once
// Modes of vehicles by name: heave, pitch, roll, hop, tramp, ...

#include <string>
#include <vector>

#include "compiler/compile.hpp"

namespace mbgen {

/// A motion of a part of the vehicle.
struct Participation {
  std::string name;  ///< "heave", "front tramp", "trailer yaw", "engine roll"
  double share = 0;  ///< of the mode's kinetic energy
};

/// Parts in each mode, the largest share first. The parts are the vehicle and its towed unit as rigid bodies
/// (surge, sway, heave, roll, pitch, yaw in their own axes, about the unit's centre of mass), and beside that motion
/// the axles (hop and tramp of both wheels, fore-aft, lateral, shimmy, wheel spin) and each other body by its name.
/// Shares are of kinetic energies: 1/2 m |v|^2 of a body's translation, 1/2 w I w of its rotation. Empty for a mode
/// without motion. The vehicle is the body of the section "vehicle", else the heaviest body of a model with tyres; a
/// model with neither has no names.
std::vector<std::vector<Participation>> participations(const Compilation& compilation, const OperatingPoint& point,
                                                       const std::vector<Mode>& modes);

/// "roll 62 %, sway 25 %": the largest shares up to 70 % together, at most three, a small one as the first alone.
std::string participation_text(const std::vector<Participation>& parts);

}  // namespace mbgen
