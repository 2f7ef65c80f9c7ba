#pragma once
// Parts of a model that are its vehicle: for manoeuvres. Without effect on the motion.

#include <optional>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A vehicle that drives along x of its body, y to the left, z up. Which tyres stand where follows from the tyres.
struct Vehicle {
  Attachment reference;                    ///< point whose motion is the vehicle's, on its body
  Attachment towed;                        ///< likewise of the last towed unit; body -1: there is none
  int steer = -1, drive = -1, brake = -1;  ///< indices into Model::inputs, -1: there is none
  int speed = -1;                          ///< index into Model::parameters of its speed at the start, m/s; -1: none
  double steer_ratio = 1;             ///< steering input over angle of the road wheels, negative where it turns right
  std::optional<double> steer_limit;  ///< rad, largest magnitude at the input
  std::optional<double> drive_limit;  ///< N m, of all driven wheels together
  std::optional<double> brake_limit;  ///< N m, of all wheels together
  std::optional<double> wheelbase;    ///< m; default: from the foremost to the rearmost tyres
  std::optional<double> width;        ///< m, of lanes' rules
};

}  // namespace mbgen
