#pragma once
// Sections of elements in the model format: one source per section, with the table of its fields and their reading.

#include "compiler/model/element_access.hpp"
#include "compiler/reader/elements/composed.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

struct ElementSection {
  std::string_view doc;
  std::vector<ObjectKind> (*kinds)();             ///< of its objects and their inner objects
  void (*read)(Reader&, const Entries& entries);  ///< into the model
  /// for an elastic kind: reason why the force of an element is not integrated, "" if it is
  std::string (*trouble)(const Model&, std::size_t index) = nullptr;
  void (*note)(Reader&) = nullptr;  ///< on values that are allowed but unlikely
};

/// Tag of the kind that leads a section. The source of the section defines section_of(Leader<Kind>).
template <class Kind>
struct Leader {
  friend ElementSection section_of(Leader);
};

/// A section of elements that stand for others.
struct ComposedSection {
  std::string_view name, key, doc;
  std::vector<ObjectKind> (*kinds)();  ///< of its objects, named `key`, and their inner objects
  void (*compose)(Reader&, const Entries& entries, ComposedParts& made);
};

/// Tag of a composition by its fields. The source of its table defines section_of(Composition<Fields>).
template <class Fields>
struct Composition {
  friend ComposedSection section_of(Composition);
};

template <class Use, class... Fields>
void each_composition(Kinds<Fields...>, const Use& use) {
  (use(Composition<Fields>()), ...);
}

/// Calls use(Composition<Fields>{}) for every composition.
template <class Use>
void each_composition(const Use& use) {
  each_composition(Compositions(), use);
}

/// Whether a kind is the first in its section.
template <class Kind>
constexpr bool leads_section() {
  bool leads = true, is_before = true;
  each_kind([&](auto other) {
    is_before = is_before && !std::is_same_v<typename decltype(other)::Element, Kind>;
    if (is_before && std::string_view(other.section) == KindOf<Kind>::section) leads = false;
  });
  return leads;
}

/// Calls use(KindOf<Kind>{}) for the first kind of every section.
template <class Use>
void each_section(const Use& use) {
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if constexpr (leads_section<Kind>()) use(kind);
  });
}

/// An end of an element.
inline FieldInfo element_end(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::attachment, .doc = doc, .need = Need::required};
}

/// A coordinate that an element acts on.
inline FieldInfo element_coordinate(std::string_view name, std::string_view doc, Need need) {
  return {.name = name, .shape = Shape::coordinate, .doc = doc, .need = need};
}

/// Adds a note on an element.
void note_at(Reader& reader, const Where& where, std::string message, std::string hint = {});

/// Notes an angle of more than a turn; not for a translational coordinate. name: of the angle.
void note_angle(Reader& reader, const Where& where, const std::string& name, const CoordinateReference& coordinate,
                double angle);

constexpr const char* kByExpression = "a force by an expression, which is not integrated";
constexpr const char* kByMotion = "a law that depends on the motion, which is not integrated";

/// Whether one of the fields depends on moving quantities.
template <class... Fields>
bool look_at_motion(const Model& model, const Fields&... fields) {
  using Kind = ExpressionNode::Kind;
  bool looks = false;
  const auto look = [&](int expression) {
    looks = looks || mentions(model, expression,
                              {Kind::position, Kind::velocity, Kind::state, Kind::length, Kind::rate, Kind::observed});
  };
  (each_expression_in(fields, look), ...);
  return looks;
}

/// Reports an element between a coordinate and itself, or between a rotation and a translation; and coordinates whose
/// sign the tree reverses. element: its words, for messages.
void check_coordinate_pair(Reader& reader, const Value& value, std::string_view element,
                           const CoordinateReference& joint, const CoordinateReference& relative_to);

}  // namespace mbgen::reading
