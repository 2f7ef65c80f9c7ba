#pragma once
// The parts of a model that form its vehicle, for manoeuvres. Without effect on the motion.

#include <optional>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// A vehicle with x of its body forward, y to the left, z up. Positions of tyres follow from the tyres.
struct Vehicle {
  Attachment reference;                    ///< reference point of the vehicle's motion, on its body
  Attachment towed;                        ///< likewise for the last towed unit; body -1: none
  int steer = -1, drive = -1, brake = -1;  ///< indices into Model::inputs, -1: none
  int speed = -1;                          ///< index into Model::parameters of its initial speed, m/s; -1: none
  double steer_ratio = 1;                  ///< steering input over angle of the road wheels, negative for turning right
  std::optional<double> steer_limit;       ///< rad, largest magnitude at the input
  std::optional<double> drive_limit;       ///< N m, of all driven wheels together
  std::optional<double> brake_limit;       ///< N m, of all wheels together
  std::optional<double> wheelbase;         ///< m; default: from the foremost to the rearmost tyres
  std::optional<double> width;             ///< m, of lanes' rules
};

}  // namespace mbgen
