#include "workbench/describe/dump_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/model/element_access.hpp"
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

  std::string rods_and_couplings() const {
    std::string text = "rods\n";
    for (const Rod& rod : model_.rods) {
      text += fmt::format("  {}: from {} to {}, mass {}, length {}\n", rod.name, attachment(rod.from),
                          attachment(rod.to), quantity(rod.mass), rod.length ? quantity(*rod.length) : "as placed");
    }
    for (const Coupling& coupling : model_.couplings)
      text += coupling.curve ? fmt::format("  {}: {} = {} over {}\n", coupling.name, coordinate(*coupling.joint),
                                           table(*coupling.curve), coordinate(*coupling.follows))
                             : fmt::format("  {}: {} stays 0\n", coupling.name, quantity(coupling.relation));
    return text;
  }

  // Of a field of an element.
  std::string field(const Quantity& value) const { return quantity(value); }
  std::string field(const Law& value) const { return law(value); }
  std::string field(const Table& value) const { return table(value); }
  std::string field(int expression) const { return fmt::format("{{{}}}", model_.expressions[expression].text); }
  std::string field(double value) const { return fmt::format("{}", value); }
  std::string field(const char* word) const { return word; }
  template <std::size_t size>
  std::string field(const std::array<Quantity, size>& values) const {
    return quantities(values);
  }
  template <std::size_t size>
  std::string field(const std::array<double, size>& values) const {
    return fmt::format("({})", fmt::join(values, ", "));
  }

  // Where an element acts.
  std::string place(const BetweenPoints& at) const {
    return fmt::format("from {} to {}", attachment(at.from), attachment(at.to));
  }
  std::string place(const AlongDirection& at) const {
    return fmt::format("{} along ({})", place(BetweenPoints{at.from, at.to}), fmt::join(at.axis, ", "));
  }
  std::string place(const BetweenFrames& at) const { return place(BetweenPoints{at.from, at.to}); }
  std::string place(const OnCoordinate& at) const {
    return fmt::format("on {}{}", coordinate(at.joint),
                       at.relative_to ? " relative to " + coordinate(*at.relative_to) : "");
  }
  std::string place(const OnBody& at) const { return "at " + attachment(at.at); }
  std::string place(const AlongSpring& at) const { return "along spring " + name_of(model_, at); }
  std::string place(const InRodEnd& at) const {
    return fmt::format("in rod {} at {}", model_.rods[at.rod].name, at.at_from ? "from" : "to");
  }

  std::string place(const ThroughPoints& at) const {
    std::vector<std::string> points;
    for (const Attachment& point : at.points) points.push_back(attachment(point));
    return points.empty() ? "of the span before" : fmt::format("through {}", fmt::join(points, ", "));
  }

  /// "  name: spring, from a.A to b.B, stiffness 1000, damping 20": fields that are there.
  template <class Element>
  std::string element(const Element& element) const {
    std::string text = fmt::format("  {}: {}, {}", element.name, KindOf<Element>::words,
                                   std::visit([&](const auto& at) { return place(at); }, connection_of(element)));
    KindOf<Element>::fields(element, [&](const std::string& name, const auto& value) {
      if constexpr (requires { *value, value.has_value(); }) {
        if (value) text += fmt::format(", {} {}", name, field(*value));
      } else {
        text += fmt::format(", {} {}", name, field(value));
      }
    });
    if constexpr (requires { details(element); }) text += details(element);
    return text + "\n";
  }

  std::string elements() const {
    std::string text = "elements\n";
    each_element(model_, [&](const auto& each) { text += element(each); });
    return text;
  }

  std::string details(const AppliedForce& force) const {
    return fmt::format(", {} axes", force.in_body_axes ? "body" : "global");
  }

  std::string details(const Tyre& tyre) const {
    return fmt::format("{}{}{}{}", tyre.road < 0 ? "" : ", on road " + model_.roads[tyre.road].name,
                       tyre.envelope ? ", " + to_text(*tyre.envelope) : "",
                       tyre.combined_slip == CombinedSlip::ellipse ? ", combined slip by an ellipse" : "",
                       tyre.parking ? turning(tyre) : "");
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
    return pressed + (friction.kind == FrictionLaw::Kind::lugre ? ", lugre" : ", elasto_plastic");
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
  text += describe.rods_and_couplings() + describe.elements() + describe.roads() + describe.axles() +
          vehicle_dump(model) + "motions\n";
  for (const Motion& motion : model.motions) {
    text += fmt::format("  {}: {} = {}\n", motion.name, describe.coordinate(motion.joint),
                        describe.quantity(motion.position));
  }
  text += describe.states() + "outputs\n";
  for (const Output& output : model.outputs) text += output_text(model, output);
  return text;
}

}  // namespace mbgen
