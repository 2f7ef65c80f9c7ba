#include "workbench/describe/dump_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "workbench/describe/dump_outputs.hpp"
#include "workbench/describe/names.hpp"
#include "workbench/describe/vehicle_text.hpp"

namespace mbgen {
namespace {

/// Prints the elements of one model.
class ModelText : public ModelWords {
 public:
  explicit ModelText(const Model& model) : ModelWords{model} {}

  template <std::size_t size>
  std::string quantities(const std::array<Quantity, size>& values) const {
    std::vector<std::string> texts;
    for (const Quantity& value : values) texts.push_back(quantity(value));
    return fmt::format("({})", fmt::join(texts, ", "));
  }

  std::string law(const std::optional<Law>& law) const {
    if (!law) return "none";
    if (const Quantity* factor = std::get_if<Quantity>(&*law)) return quantity(*factor);
    return this->table(std::get<Table>(*law));
  }

  std::string table(const Table& table) const {
    std::vector<std::string> points;
    for (std::size_t i = 0; i < table.x.size(); ++i) points.push_back(fmt::format("{}: {}", table.x[i], table.y[i]));
    const char* kinds[] = {"linear", "monotone cubic", "spline"};
    return fmt::format("{}{} table [{}]", table.periodic ? "periodic " : "",
                       kinds[static_cast<int>(table.interpolation)], fmt::join(points, ", "));
  }

  std::string body(const Body& body) const {
    std::string text = fmt::format("  {}: mass {}, com {}, inertia {}, origin ({}), rotation ({})\n", body.name,
                                   quantity(body.mass), quantities(body.com), quantities(body.inertia),
                                   fmt::join(body.pose.origin, ", "), fmt::join(body.pose.rotation, ", "));
    for (const Point& point : body.points) text += fmt::format("    .{} {}\n", point.name, quantities(point.position));
    return text;
  }

  std::string hardpoints() const {
    std::string text = model_.hardpoints.empty() ? "" : "hardpoints\n";
    for (const Point& point : model_.hardpoints)
      text += fmt::format("  {} {}\n", point.name, quantities(point.position));
    return text;
  }

  std::string joint(const Joint& joint) const {
    const char* marks[] = {"", ", marked cut", ", marked tree"};
    std::string text = fmt::format("  {}: {} from {} to {}{}\n", joint.name, name_of(joint.type),
                                   attachment(joint.from), attachment(joint.to), marks[static_cast<int>(joint.cut)]);
    if (joint.radius) text += fmt::format("    radius {}\n", quantity(*joint.radius));
    for (const Freedom& freedom : joint.freedoms) {
      text += fmt::format("    {}: {} ({})\n", freedom.name, name_of(freedom.kind), fmt::join(freedom.axis, ", "));
    }
    return text;
  }

  std::string rods_and_springs() const {
    std::string text = "rods\n";
    for (const Rod& rod : model_.rods) {
      text += fmt::format("  {}: from {} to {}, mass {}, length {}\n", rod.name, attachment(rod.from),
                          attachment(rod.to), quantity(rod.mass), rod.length ? quantity(*rod.length) : "as placed");
    }
    for (const Coupling& coupling : model_.couplings)
      text += coupling.curve ? fmt::format("  {}: {} = {} over {}\n", coupling.name, coordinate(*coupling.joint),
                                           table(*coupling.curve), coordinate(*coupling.follows))
                             : fmt::format("  {}: {} stays 0\n", coupling.name, quantity(coupling.relation));
    text += "springs\n";
    for (const PointSpring& spring : model_.springs) {
      text += fmt::format("  {}: from {} to {}, stiffness {}, damping {}, preload {}\n", spring.name,
                          attachment(spring.from), attachment(spring.to), law(spring.stiffness), law(spring.damping),
                          quantity(spring.preload));
    }
    for (const JointSpring& spring : model_.joint_springs) {
      text +=
          fmt::format("  {}: on {}{}, stiffness {}, damping {}, preload {}\n", spring.name, coordinate(spring.joint),
                      spring.relative_to ? " relative to " + coordinate(*spring.relative_to) : "",
                      law(spring.stiffness), law(spring.damping), quantity(spring.preload));
    }
    for (const AirSpring& spring : model_.air_springs) {
      text += fmt::format("  {}: air, from {} to {}, pressure {}, exponent {}, area {}\n", spring.name,
                          attachment(spring.from), attachment(spring.to), quantity(spring.pressure),
                          quantity(spring.exponent), law(spring.area));
    }
    return text;
  }

  std::string bushings() const {
    std::string text;
    for (const Bushing& bushing : model_.bushings) {
      text += fmt::format("  {}: bushing, from {} to {}, axes ({}){}\n", bushing.name, attachment(bushing.from),
                          attachment(bushing.to), fmt::join(bushing.axes, ", "),
                          bushing.is_mirrored ? ", counts mirrored" : "");
      for (std::size_t i = 0; i < bushing.freedoms.size(); ++i) {
        const std::optional<BushingFreedom>& own = bushing.freedoms[i];
        if (!own) continue;
        text += fmt::format("    {}: stiffness {}, damping {}, preload {}", kBushingFreedomNames[i],
                            law(own->stiffness), law(own->damping), quantity(own->preload));
        if (own->force) text += fmt::format(", force {{{}}}", model_.expressions[*own->force].text);
        if (own->maxwell_stiffness)
          text +=
              fmt::format(", Maxwell branch {}, {} s", quantity(*own->maxwell_stiffness), quantity(own->maxwell_time));
        text += '\n';
      }
      if (bushing.stiffness) text += fmt::format("    stiffness {}\n", quantities(*bushing.stiffness));
      if (bushing.damping) text += fmt::format("    damping {}\n", quantities(*bushing.damping));
    }
    return text;
  }

  std::string bump_stops() const {
    const char* sides[] = {"compression", "extension", "above", "below"};
    std::string text;
    for (const BumpStop& stop : model_.bump_stops) {
      const std::string place = stop.is_on_joint() ? "on " + coordinate(stop.joint)
                                                   : "from " + attachment(stop.from) + " to " + attachment(stop.to);
      text += fmt::format("  {}: bump stop, {}, {}, clearance {}, stiffness {}, exponent {}, damping {}\n", stop.name,
                          place, sides[static_cast<int>(stop.side)], quantity(stop.clearance), law(stop.stiffness),
                          stop.exponent, quantity(stop.damping));
      if (stop.axis) text += fmt::format("    along ({})\n", fmt::join(*stop.axis, ", "));
      if (stop.force) text += fmt::format("    force {{{}}}\n", model_.expressions[*stop.force].text);
    }
    return text;
  }

  std::string forces() const {
    std::string text = "forces\n";
    for (const AppliedForce& force : model_.forces) {
      text += fmt::format("  {}: at {}, force {}, torque {}, {} axes\n", force.name, attachment(force.at),
                          quantities(force.force), quantities(force.torque), force.in_body_axes ? "body" : "global");
    }
    for (const JointForce& force : model_.joint_forces) {
      text += fmt::format("  {}: on {}, {}\n", force.name, coordinate(force.joint), quantity(force.force));
    }
    for (const JointFriction& friction : model_.frictions) {
      text += fmt::format("  {}: friction on {}, coulomb {}, viscous {}{}\n", friction.name, coordinate(friction.joint),
                          quantity(friction.coulomb), quantity(friction.viscous), details(friction));
    }
    for (const SpringFriction& friction : model_.spring_frictions) {
      text += fmt::format("  {}: friction along spring {}, coulomb {}, viscous {}{}\n", friction.name,
                          model_.springs[friction.spring].name, quantity(friction.coulomb), quantity(friction.viscous),
                          details(friction));
    }
    for (const RodFriction& friction : model_.rod_frictions) {
      text += fmt::format("  {}: friction in rod {} at {}, coulomb {}, viscous {}{}\n", friction.name,
                          model_.rods[friction.rod].name, friction.at_from ? "from" : "to", quantity(friction.coulomb),
                          quantity(friction.viscous), details(friction));
    }
    for (const Tyre& tyre : model_.tyres) {
      text += fmt::format("  {}: tyre at {}, axis ({}), count {}, radius {}, stiffness {}{}{}{}{}{}\n", tyre.name,
                          attachment(tyre.centre), fmt::join(tyre.axis, ", "), tyre.count, quantity(tyre.radius),
                          quantity(tyre.stiffness),
                          tyre.model == TyreModel::mf61 ? ", pressure " + quantity(tyre.pressure) : "",
                          tyre.road < 0 ? "" : ", on road " + model_.roads[tyre.road].name,
                          tyre.envelope ? ", " + to_text(*tyre.envelope) : "",
                          tyre.combined_slip == CombinedSlip::ellipse ? ", combined slip by an ellipse" : "",
                          tyre.parking ? turning(tyre) : "");
    }
    return text;
  }

  /// ", turns with stiffness 2000, ...". Requires: a tyre with a turning contact patch.
  std::string turning(const Tyre& tyre) const {
    return fmt::format(", turns with stiffness {} and radius {} under {}{}", quantity(tyre.parking->stiffness),
                       quantity(tyre.parking->radius), quantity(tyre.parking->load),
                       tyre.turn_slip ? ", turn slip" : "");
  }

  /// "" without any.
  std::string axles() const {
    std::string text = model_.axles.empty() ? "" : "axles\n";
    for (const Axle& axle : model_.axles) {
      text += fmt::format("  {}: {} axle held by {}{}\n", axle.name, axle.end == Axle::End::front ? "front" : "rear",
                          body_name(axle.body), axle.steer ? ", steered by " + coordinate(*axle.steer) : "");
      const auto number = [&](const char* name, const std::optional<double>& value) {
        if (value) text += fmt::format("    {} {}\n", name, *value);
      };
      number("wheelbase", axle.wheelbase);
      number("centre_of_gravity_height", axle.centre_of_gravity_height);
      number("brake_share", axle.brake_share);
      number("drive_share", axle.drive_share);
      text += fmt::format("    brakes on the {}, drive on the {}\n", support(axle.brakes_on), support(axle.drive_on));
      if (axle.left.is_there()) text += "    left" + wheel(axle.left);
      if (axle.right.is_there()) text += "    right" + wheel(axle.right);
      if (!axle.without.empty()) text += fmt::format("    without {}\n", fmt::join(axle.without, ", "));
    }
    return text;
  }

  /// "" without any.
  std::string roads() const {
    std::string text = model_.roads.empty() ? "" : "roads\n";
    for (const Road& road : model_.roads) {
      text += fmt::format("  {}: origin ({}), heading {}, slopes {} and {}", road.name, fmt::join(road.origin, ", "),
                          road.heading, quantity(road.slope_x), quantity(road.slope_y));
      if (road.height) text += fmt::format(", height {{{}}}", model_.expressions[*road.height].text);
      if (road.friction) text += fmt::format(", friction {{{}}}", model_.expressions[*road.friction].text);
      if (road.host_input >= 0) text += ", told by a host";
      text += '\n';
      for (const RoadTracks& tracks : road.tracks)
        text += fmt::format("    tracks: y {} and {}, {} places from {} on, each {} m{}\n", tracks.right, tracks.left,
                            tracks.count, tracks.from, tracks.spacing, tracks.is_periodic ? ", periodic" : "");
      for (const RoadGrid& grid : road.grids)
        text += fmt::format("    grid: smooth over {} m and {} m at its ends, beyond {} {:+} m, beside {} {:+} m\n",
                            grid.smooth_begin, grid.smooth_end, name_of(grid.ends), grid.end_offset,
                            name_of(grid.sides), grid.side_offset);
      for (const RoadFeature& feature : road.features) text += "    " + this->feature(feature) + '\n';
      for (const RoadPatch& patch : road.patches)
        text += fmt::format("    {}: friction {}{}\n", patch.name, quantity(patch.friction), stretch(patch));
    }
    return text;
  }

  /// "" without any.
  std::string states() const {
    std::string text = model_.states.empty() ? "" : "states\n";
    for (const UserState& state : model_.states)
      text += fmt::format("  {} [{}]: derivative {}, at the start {}\n", state.name, state.unit,
                          quantity(state.derivative), state.initial);
    text += model_.sampled.empty() ? "" : "sampled\n";
    for (const SampledValue& value : model_.sampled)
      text += fmt::format("  {} [{}]: every {} s {}, {} later, at the start {}\n", value.name, value.unit, value.period,
                          value.load ? load(*value.load) : quantity(value.value), value.delay, value.initial);
    return text;
  }

  std::string load(const ReactionLoad& load) const {
    static constexpr const char* kDirections[] = {"", " across", " along"};  // in the order of Direction
    return fmt::format("{} of {}{}", load.what == ReactionOutput::What::force ? "force" : "moment",
                       load.joint >= 0 ? model_.joints[load.joint].name : model_.rods[load.rod].name,
                       kDirections[static_cast<int>(load.direction)]);
  }

  /// Load and bristles.
  std::string details(const FrictionLaw& friction) const {
    const std::string pressed = friction.load < 0 ? "" : ", pressed by " + model_.sampled[friction.load].name;
    if (!friction.has_bristle()) return pressed;
    return pressed + fmt::format(", {} with stiffness {}, damping {}",
                                 friction.kind == FrictionLaw::Kind::lugre ? "lugre" : "elasto_plastic",
                                 quantity(friction.stiffness), quantity(friction.damping));
  }

 private:
  static const char* support(TorqueSupport support) { return support == TorqueSupport::body ? "body" : "carrier"; }
  std::string wheel(const AxleWheel& wheel) const {
    std::string text = fmt::format(" wheel at {}, axis ({}), radius {}", attachment(wheel.centre),
                                   fmt::join(wheel.axis, ", "), wheel.radius);
    if (wheel.lower.body >= 0)
      text += fmt::format(", steered about {} to {}", attachment(wheel.lower), attachment(wheel.upper));
    return text + "\n";
  }
  std::string feature(const RoadFeature& feature) const {
    static constexpr const char* kKinds[] = {"bump", "plank", "pothole", "sine", "sweep"};  // in the order of Kind
    std::string text = fmt::format("{}: {}, height {}{}, ramp {}", feature.name, kKinds[static_cast<int>(feature.kind)],
                                   quantity(feature.height), stretch(feature), feature.ramp);
    if (feature.wave_length)
      text += fmt::format(", wave_length {}, phase {}", quantity(*feature.wave_length), quantity(feature.phase));
    if (feature.last_wave_length) text += ", last_wave_length " + quantity(*feature.last_wave_length);
    return text;
  }
  std::string stretch(const RoadStretch& stretch) const {
    std::string text = ", from " + quantity(stretch.from);
    for (const auto& [name, value] :
         {std::pair(", length ", stretch.length), {", right ", stretch.right}, {", left ", stretch.left}})
      if (value) text += name + quantity(*value);
    return text;
  }
};

}  // namespace

std::string dump_model(const Model& model) {
  const ModelText describe(model);
  std::string text =
      fmt::format("model {}, hash {}\ngravity {}\n", model.name, model.hash, describe.quantities(model.gravity));
  text += "parameters\n";
  for (const Parameter& parameter : model.parameters) {
    text += fmt::format("  {} = {} {}{}\n", parameter.name, parameter.value, parameter.unit,
                        parameter.tunable           ? ", tunable"
                        : parameter.expression >= 0 ? ", follows from tunable ones"
                                                    : "");
  }
  text += "inputs\n";
  for (const Input& input : model.inputs) {
    text += fmt::format("  {} = {} {}{}\n", input.name, input.default_value, input.unit,
                        input.derivative < 0 ? "" : ", derivative " + model.inputs[input.derivative].name);
  }
  text += describe.hardpoints() + "bodies\n";
  for (const Body& body : model.bodies) text += describe.body(body);
  text += "joints\n";
  for (const Joint& joint : model.joints) text += describe.joint(joint);
  text += describe.rods_and_springs() + describe.bushings() + describe.bump_stops() + describe.forces() +
          describe.roads() + describe.axles() + vehicle_dump(model) + "motions\n";
  for (const Motion& motion : model.motions) {
    text += fmt::format("  {}: {} = {}\n", motion.name, describe.coordinate(motion.joint),
                        describe.quantity(motion.position));
  }
  text += describe.states() + "outputs\n";
  for (const Output& output : model.outputs) text += output_text(model, output);
  return text;
}

}  // namespace mbgen
