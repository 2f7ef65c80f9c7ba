#include "compiler/emit/quantity_names.hpp"

namespace mbgen {
namespace {

constexpr QuantityName kQuantityNames[] = {
    // Numbers.
    {"g", "gravity", "m/s^2"},
    {"m", "mass of a body and all that is fixed to it", "kg"},
    {"c", "centre of mass, from the origin of the body in its own axes", "m"},
    {"I", "inertia about the centre of mass in the axes of the body", "kg m^2"},
    {"Io", "inertia about the origin of the body, in its own axes", "kg m^2"},
    {"h", "first moments, integral of r dm, about the origin of the body in its own axes", "kg m"},
    {"K", "second moments, integral of r r' dm, likewise", "kg m^2"},
    {"Kalong", "of a body with an axis of symmetry: second moment along it less that across it, at the centre of mass",
     "kg m^2"},
    {"Kacross", "of such a body: second moment across its axis, at the centre of mass", "kg m^2"},
    {"p",
     "p_COORDINATE: origin of a body from the origin of the body before it; p_BODY_POINT: a point from its body's "
     "origin",
     "m"},
    {"l", "length of a rod", "m"},
    {"l0", "free length of an element", "m"},
    {"z0", "free coordinate of an element", "rad or m"},
    {"k", "stiffness of an element", "N/m or N m/rad"},
    {"d", "damping of an element", "N s/m or N m s/rad"},
    {"f0", "preload of an element", "N"},
    {"m6", "a sixth of the mass of a rod", "kg"},
    {"minus", "minus_NAME: the negative of that quantity", ""},
    {"number", "a number that follows from others, by its definition", ""},
    // Step 1.
    {"z", "coordinate", "rad or m"},
    {"R", "R_BODY_a_b: component b of the body's axis a, in the axes of its base", ""},
    {"angle", "sum of the angles of joints with parallel axes up to a body", "rad"},
    {"u", "axis of a joint", ""},
    {"pin", "point of a joint, in the frame of its axis", "m"},
    {"offset", "origin of a body from the origin of the body before it, in the axes of the base", "m"},
    {"axis", "of three joints that turn or move together: axis of one", ""},
    {"dual", "the reciprocal axis of one, by which forces and accelerations of the joints follow", ""},
    {"volume", "of their three axes: zero where the joint rates are singular", ""},
    {"r", "origin of a body from the origin of its base", "m"},
    {"b", "motion of a body for a unit rate of its coordinate", ""},
    // Steps 2 and 3.
    {"arm", "end of a loop from the origin of the body that holds it", "m"},
    {"place", "end of a loop from the origin of the base", "m"},
    {"gap", "difference of the two ends of a loop", "m"},
    {"J", "J_LOOP_ROW_COORDINATE: entry of the closure Jacobian", ""},
    {"along", "force of a closure equation for a unit multiplier", ""},
    {"lever", "moment of a closure equation for a unit multiplier, about the origin of the body of this end", "m"},
    {"Phi", "residual of a closure equation", ""},
    {"L", "L_a_b: factor by which the row with the pivot of b is taken off the row with the pivot of a", ""},
    {"U", "U_a_b: entry at coordinate b of the row with the pivot of a, after elimination", ""},
    {"pivot", "of a coordinate: pivot of its column of the closure Jacobian (60), or of its free direction (63)", ""},
    {"per", "per_pivot, per_m, per_reference, per_volume: 1 over that", ""},
    {"Rz", "Rz_a_q: rate of coordinate a for a unit rate of the free direction q (61)", ""},
    // Step 4.
    {"zd", "rate of a coordinate", "rad/s or m/s"},
    {"v", "velocity of the origin of a body; v_BODY_per_COORDINATE: for a unit rate of that", "m/s"},
    {"w", "angular velocity of a body; w_BODY_per_COORDINATE: for a unit rate of that", "rad/s"},
    {"vb", "velocity of the origin of a body against its base", "m/s"},
    {"wb", "angular velocity of a body against its base", "rad/s"},
    {"vc", "vc_BODY_per_COORDINATE: velocity of the point that the body's equations are about, for a unit rate", ""},
    {"wc", "wc_BODY_per_COORDINATE: angular velocity for a unit rate", ""},
    // Step 5.
    {"length", "position of an element along its line, coordinate or axis", "m or rad"},
    {"rate", "rate of that", "m/s or rad/s"},
    {"force", "force or torque of an element against its position", "N or N m"},
    {"tension", "tension of an element", "N"},
    {"fa", "sum of the applied forces on a body", "N"},
    {"na", "sum of the applied moments on a body about its origin", "N m"},
    {"Qa", "sum of the applied forces along a coordinate", "N or N m"},
    // Step 6.
    {"abias", "acceleration of the origin of a body against its base at zero accelerations of the joints", "m/s^2"},
    {"alphabias", "angular acceleration of a body, likewise", "rad/s^2"},
    {"Gbias", "w~w~ + alpha~ of a body, likewise", "1/s^2"},
    {"varm", "velocity of a loop's end against the origin of its body", "m/s"},
    {"vgap", "rate of `gap`", "m/s"},
    {"a0gap", "second derivative of `gap` at zero accelerations of the joints", "m/s^2"},
    {"bias", "second derivative of a closure equation at zero accelerations of the joints", ""},
    {"zdd_star", "acceleration of a coordinate at zero free accelerations (62)", "rad/s^2 or m/s^2"},
    // Steps 7 and 8.
    {"hb", "first moments of a body in the axes of its base", "kg m"},
    {"Kb", "second moments, likewise", "kg m^2"},
    {"Ib", "inertia about the origin of the body, in the axes of its base", "kg m^2"},
    {"hc", "composite: first moments of a body with all that moves on it", "kg m"},
    {"Kc", "composite: second moments, likewise", "kg m^2"},
    {"Ic", "composite: inertia, likewise", "kg m^2"},
    {"hp", "share of a body in the first moments of the body that it moves on, about its origin", "kg m"},
    {"Kp", "share in the second moments, likewise", "kg m^2"},
    {"Ip", "share in the inertia, likewise", "kg m^2"},
    {"Al",
     "articulated inertia, force for an acceleration; ..._left: less the free directions; ..._down: in the axes of the "
     "base",
     "kg"},
    {"Ac", "articulated inertia, force for an angular acceleration", "kg m"},
    {"Aa", "articulated inertia, moment for an angular acceleration", "kg m^2"},
    {"astar", "acceleration of the origin of a body for zdd_star", "m/s^2"},
    {"alphastar", "angular acceleration of a body for zdd_star", "rad/s^2"},
    {"a0", "acceleration of a body at zero free accelerations", "m/s^2"},
    {"alpha0", "angular acceleration of a body, likewise", "rad/s^2"},
    {"G", "w~w~ + alpha~ of a body, the gradient of accelerations in it", "1/s^2"},
    {"f", "force that a body needs at zero free accelerations, applied forces taken off", "N"},
    {"n", "moment that a body needs, likewise", "N m"},
    {"fc", "composite: force that a body needs with all that moves on it", "N"},
    {"nc", "composite: moment, likewise", "N m"},
    {"F", "F_COORDINATE: force for a unit acceleration of the free direction; F_BODY_per_COORDINATE: share of the body",
     ""},
    {"N", "moment, likewise", ""},
    {"H", "H_a_b: inertia of the free directions a and b, Rz' M Rz (63)", ""},
    {"Q",
     "Q_COORDINATE: force along a free direction; ..._applied: of joint forces and elements; ..._left: after "
     "elimination (63)",
     "N or N m"},
    {"mass", "a mass", "kg"},
    // Step 9.
    {"qdd", "acceleration of a free direction", "rad/s^2 or m/s^2"},
    {"zdd", "acceleration of a coordinate", "rad/s^2 or m/s^2"},
    {"a", "acceleration of the origin of a body, less gravity", "m/s^2"},
    {"alpha", "angular acceleration of a body", "rad/s^2"},
    {"lambda", "multiplier of a closure equation", "N or N m"},
    // Bounds.
    {"inertia", "inertia that rounding leaves of none", "kg m^2 or kg"},
    {"share", "share that rounding leaves of a number", ""},
    {"least", "least value that counts", ""},
};

}  // namespace

std::span<const QuantityName> quantity_names() { return kQuantityNames; }

QuantityName quantity_of(std::string_view name) {
  QuantityName best;
  for (const QuantityName& kind : kQuantityNames) {
    const bool is_it = name == kind.prefix || (name.starts_with(kind.prefix) && name[kind.prefix.size()] == '_');
    if (is_it && kind.prefix.size() > best.prefix.size()) best = kind;
  }
  return best;
}

}  // namespace mbgen
