#pragma once
// Elements and attributes of a format, and their treatment: the one list behind the notes about parts that are not
// carried over. The note on an attribute that is in no list proposes the nearest name.

#include <span>

#include "workbench/import/xml.hpp"

namespace mbgen::importing {

/// Names in lists are separated by blanks.
struct KnownElement {
  std::string_view path;        ///< context/name, as joint/limit
  std::string_view read;        ///< attributes that the translation reads; it tells itself where it leaves one out
  std::string_view quiet = {};  ///< attributes without a part in the motion: one note names those of a file
  std::string_view left_out =
      {};                 ///< why the whole element, with all inside, is left out; "-": told by the translation
  bool is_quiet = false;  ///< the whole element is like a quiet attribute
};

/// An attribute that has a part in the motion and is not carried over.
struct LostAttribute {
  std::string_view path, name, reason;
};

/// Other contexts whose elements stand in this one too: those of a body in a frame.
struct SameContext {
  std::string_view context, as;
};

struct KnownFormat {
  std::string_view name;  ///< of the format
  std::span<const KnownElement> elements;
  std::span<const LostAttribute> lost;
  std::span<const SameContext> contexts;
};

extern const KnownFormat kUrdf, kMjcf;

/// Notes about elements and attributes that are not carried over, one per kind, and about unknown ones. The inside of
/// an element that is left out is not checked.
void note_left_out(Reading& reading, const Element& root, const KnownFormat& format);

/// Whether the format has the attribute in an element of this path.
bool is_known(const KnownFormat& format, std::string_view path, std::string_view attribute);

}  // namespace mbgen::importing
