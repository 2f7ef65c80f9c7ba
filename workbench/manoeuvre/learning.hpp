#pragma once
// A driver that learns the vehicle before the manoeuvre.

#include <string>

#include "compiler/model/model.hpp"
#include "workbench/manoeuvre/manoeuvre.hpp"

namespace mbgen {

/// Values that a driver with DriverSettings::learns knows.
struct LearnedVehicle {
  double steer_ratio = 1;  ///< steering input over the mean angle of the foremost wheels, at the start
  double understeer = 0;   ///< rad s^2/m, of the steady motion straight on at the start's speed (trim.hpp)
};

/// model: with its speed at the start, inputs at their defaults. file: of the manoeuvre, for messages. Fails: UserError
/// if the steering input turns no wheels, or there is no steady motion straight on.
LearnedVehicle learn_vehicle(const Model& model, const std::string& file);

}  // namespace mbgen
