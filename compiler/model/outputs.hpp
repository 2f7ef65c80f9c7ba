#pragma once
// Outputs of a model, and how values of its interface are shown.

#include <optional>
#include <string>
#include <variant>

#include "compiler/model/bodies.hpp"

namespace mbgen {

/// Texts for people beside the name and unit of a value of the interface; without effect on the motion.
struct Presentation {
  std::string description = {};
  std::string display_unit;        ///< that it is shown in, of the same dimension as its unit; none: its unit
  std::optional<double> min, max;  ///< range that is meant, in its unit
  std::optional<double> nominal;   ///< usual magnitude, in its unit
};

struct PointOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  Attachment point;
  int axis = 0;               ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;  ///< components in the axes of the point's body, else global
};
struct CoordinateOutput {
  enum class What { position, velocity, acceleration };
  What what = What::position;
  CoordinateReference coordinate;
};
struct ExpressionOutput {
  Quantity value;
};  ///< over t, parameters, inputs, coordinates
struct TyreOutput {
  enum class What { load, longitudinal_force, lateral_force, aligning_moment, longitudinal_slip, lateral_slip };
  What what = What::load;
  int tyre = -1;  ///< index into Model::tyres
};
struct SpringOutput {
  enum class What { force, length, rate };
  What what = What::force;
  int point_spring = -1, air_spring = -1;  ///< one of them
};
struct DriveOutput {
  int motion = -1;
};  ///< generalised driving force of a motion

/// A component of the force or moment that a joint or rod transmits from its `from` to its `to` body: the
/// sum of constraint, springs, friction, forces and drives of its coordinates. Moments are about the joint's point
/// on `to`, at both ends; a rod transmits none.
struct ReactionOutput {
  enum class What { force, moment };
  enum class End { to, from };
  What what = What::force;
  int joint = -1, rod = -1;   ///< one of them
  int axis = 0;               ///< 0 x, 1 y, 2 z
  bool in_body_axes = false;  ///< components in the axes of the body at `end`, else global
  End end = End::to;          ///< the body that is acted on
};

/// Multiplier of one equation of a cut joint, rod (its tension) or coupling.
struct MultiplierOutput {
  int joint = -1, rod = -1;  ///< one of them, or
  int equation = 0;          ///< index into closure_rows of the joint
  int coupling = -1;         ///< this
};

struct Output {
  std::string name;
  Where where;
  std::string unit;
  std::variant<ExpressionOutput, PointOutput, CoordinateOutput, TyreOutput, SpringOutput, DriveOutput, ReactionOutput,
               MultiplierOutput>
      source;
  Presentation shown = {};
};

}  // namespace mbgen
