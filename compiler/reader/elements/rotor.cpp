// Rotors of actuators, as bodies that couplings turn.
#include <fmt/format.h>

#include "compiler/reader/elements/actuator.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {
namespace {

/// Formula of the coordinate that an actuator moves, "" with a problem or where it is not readable.
std::string coordinate_formula(Reader& reader, const Value& actuator) {
  const auto text = [&](std::string_view key) {
    const Value* member = find(actuator, key);
    return member && member->kind == Value::Kind::text ? member->text : std::string();
  };
  if (const std::string rod = text("rod"); !rod.empty()) return fmt::format("z.{}_length", rod);
  if (find(actuator, "relative_to")) return fmt::format("(z.{} - z.{})", text("joint"), text("relative_to"));
  if (const std::string joint = text("joint"); !joint.empty()) return "z." + joint;
  if (!find(actuator, "joint") && !find(actuator, "rod"))
    report(reader, find_member(actuator, "rotor_inertia")->place,
           "the rotor of this actuator has no coordinate to turn with",
           "let it act on a \"joint\" or a \"rod\", or leave the inertia out");
  return "";
}

/// A gear as text of a formula, "" for one that is not readable.
std::string gear_formula(const Value& actuator) {
  const Value* gear = find(actuator, "gear");
  if (!gear) return "1";
  if (gear->kind == Value::Kind::number) return fmt::format("({})", gear->number);
  return gear->kind == Value::Kind::text ? fmt::format("({})", gear->text) : "";
}

}  // namespace

void compose_rotors(Reader& reader, const Entries& actuators, ComposedParts& made) {
  for (const Entry& entry : actuators) {
    const Value* inertia = entry.value->kind == Value::Kind::object ? find(*entry.value, "rotor_inertia") : nullptr;
    if (!inertia) continue;
    const InScope in_scope(reader, entry.scope);
    const std::string coordinate = coordinate_formula(reader, *entry.value), gear = gear_formula(*entry.value);
    if (coordinate.empty() || gear.empty()) continue;
    const std::string name = entry.written + "_rotor";
    add_composed_hardpoint(reader, entry, name, {});
    Composed body(inertia->place), joint(entry.place), coupling(entry.place);
    Value moments;
    moments.kind = Value::Kind::array;
    moments.place = inertia->place;
    moments.items.assign(3, *inertia);
    body.add("mass", *inertia);  // moves nothing, its centre stands still
    body.add("inertia", std::move(moments));
    joint.add_text("type", "revolute");
    joint.add_text("from", "ground." + name);
    joint.add_text("to", name + "." + name);
    joint.add_text("axis", "z");
    coupling.add_text("relation", fmt::format("z.{} - {}*{}", name, gear, coordinate));
    add_composed(reader, made.bodies, entry, "_rotor", std::move(body));
    add_composed(reader, made.joints, entry, "_rotor", std::move(joint));
    add_composed(reader, made.couplings, entry, "_rotor", std::move(coupling));
  }
}

}  // namespace mbgen::reading
