#pragma once
// Elements and attributes of a format with their treatment: the single source of notes about lost parts. The note on an
// unknown attribute proposes the nearest name.

#include <span>

#include "workbench/import/xml.hpp"

namespace mbgen::importing {

/// Names in lists are separated by blanks.
struct KnownElement {
  std::string_view path;           ///< context/name, as joint/limit
  std::string_view read;           ///< attributes that are read; the translation itself reports losses
  std::string_view quiet = {};     ///< attributes without effect on the motion: one note lists those of a file
  std::string_view left_out = {};  ///< reason for the loss of the whole element; "-": reported by the translation
  bool is_quiet = false;           ///< the whole element has no effect on the motion
};

/// An attribute that affects the motion but is not carried over.
struct LostAttribute {
  std::string_view path, name, reason;
};

/// Other contexts with the same elements: for a frame, those of a body.
struct SameContext {
  std::string_view context, as;
};

struct KnownFormat {
  std::string_view name;  ///< of the format
  std::span<const KnownElement> elements;
  std::span<const LostAttribute> lost;
  std::span<const SameContext> contexts;
};

extern const KnownFormat kUrdf, kMjcf, kSdf;

/// Notes about elements and attributes that are not carried over, one per kind, and about unknown ones. The content of
/// a lost element is not checked.
void note_left_out(Reading& reading, const Element& root, const KnownFormat& format);

/// Whether the format has the attribute for an element of this path.
bool is_known(const KnownFormat& format, std::string_view path, std::string_view attribute);

}  // namespace mbgen::importing
