// Table of fields: the vehicle.
#include <array>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

FieldInfo input(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::reference, .doc = doc, .of = "inputs"};
}

FieldInfo positive(std::string_view name, std::string_view doc, std::string_view unit) {
  return {.name = name, .shape = Shape::number, .doc = doc, .unit = unit, .bound = Bound::positive};
}

}  // namespace

template <>
std::span<const Field<VehicleFields>> fields<VehicleFields>() {
  using F = VehicleFields;
  static const std::array table = {
      field<F, &F::reference>({.name = "reference",
                               .shape = Shape::attachment,
                               .doc = "reference point of the vehicle's position, speed and accelerations; its body "
                                      "gives heading, roll and pitch, x forward, y to the left, z up",
                               .need = Need::required}),
      field<F, &F::towed>({.name = "towed",
                           .shape = Shape::attachment,
                           .doc = "reference point of the last towed unit, on its body, for lateral acceleration; the "
                                  "rearmost tyres belong to this unit"}),
      field<F, &F::written_steer>(input("steer", "steering input, rad; its derivatives, if any, change with it")),
      field<F, &F::steer_ratio>({.name = "steer_ratio",
                                 .shape = Shape::number,
                                 .doc = "angle at that input over the mean angle of the road wheels, which is positive "
                                        "to the left; negative where a positive input steers to the right",
                                 .unit = "1",
                                 .fallback = 1}),
      field<F, &F::steer_limit>(positive("steer_limit", "largest angle at that input, to either side", "rad")),
      field<F, &F::written_drive>(input("drive", "input of the driving torque, N m, of all driven wheels together")),
      field<F, &F::drive_limit>(
          positive("drive_limit", "largest driving torque, of all driven wheels together", "N m")),
      field<F, &F::written_brake>(input("brake", "input of the braking torque, N m, of all wheels together")),
      field<F, &F::brake_limit>(positive("brake_limit", "largest braking torque, of all wheels together", "N m")),
      field<F, &F::written_speed>({.name = "speed",
                                   .shape = Shape::reference,
                                   .doc = "parameter of the initial speed, m/s: set by manoeuvres",
                                   .of = "parameters"}),
      field<F, &F::wheelbase>(
          positive("wheelbase", "for the driver; default: from the foremost to the rearmost tyres", "m")),
      field<F, &F::width>(positive("width", "width of the vehicle, for the widths of lanes", "m")),
  };
  return table;
}

}  // namespace mbgen::reading
