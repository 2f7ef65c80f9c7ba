#pragma once
// Reactions of joints and rods as normal forces: fields and resolution.

#include <array>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// In the order of ReactionOutput::What and of ReactionLoad::Direction.
inline constexpr std::array<std::string_view, 2> kReactionQuantityWords = {"force", "moment"};
inline constexpr std::array<std::string_view, 3> kLoadDirectionWords = {"whole", "across", "along"};

/// The rows of ReactionFields, for the table of a kind with it. doc: of the reaction.
template <class F>
std::array<Field<F>, 3> reaction_fields(std::string_view doc) {
  return {field<F, &F::reaction>({.name = "reaction", .shape = Shape::reference, .doc = doc, .of = "joints"}),
          field<F, &F::quantity>({.name = "quantity",
                                  .shape = Shape::word,
                                  .doc = "of the reaction: its force, or its moment about the joint's point on `to`; "
                                         "default: force",
                                  .words = kReactionQuantityWords}),
          field<F, &F::direction>(
              {.name = "direction",
               .shape = Shape::word,
               .doc = "of the reaction: its magnitude, or the magnitude of its component across or along the joint's "
                      "axis; default: across an axis of rotation or sliding, along a normal",
               .words = kLoadDirectionWords})};
}

/// The reaction named by `fields`; reports fields that do not apply to it. Requires: fields.reaction.
ReactionLoad read_reaction(Reader& reader, const Value& value, const ReactionFields& fields);

/// Unit of a load: N or N m.
const char* unit_of(const ReactionLoad& load);

}  // namespace mbgen::reading
