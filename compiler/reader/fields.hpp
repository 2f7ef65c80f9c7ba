#pragma once
// The table of fields: one per kind of object of the model format. It serves reading, the JSON Schema and the
// documentation.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/parse_expression.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {

/// Kind of value that a field takes.
enum class Shape {
  boolean,
  number,  ///< constant; a number or an expression of untunable parameters
  text,
  word,             ///< one of FieldInfo::words
  quantity,         ///< number or expression
  vector,           ///< three constants
  quaternion,       ///< four constants: w, x, y, z
  quantity_vector,  ///< three quantities
  position,         ///< three constants or quantities, or the name of a hardpoint
  place,            ///< a position, or "body.point"
  inertia,          ///< three or six quantities
  six_by_six,       ///< six rows of six quantities
  axis,             ///< a letter with sign, or three constants, or two points where FieldInfo::by_points says so
  attachment,       ///< "body.point"
  attachments,      ///< two of them, up to FieldInfo::most
  coordinate,       ///< name of a coordinate
  reference,        ///< name of another element, FieldInfo::of says of which map
  force,            ///< expression with FieldInfo::locals
  equation,         ///< number or name of a closure equation
  law,              ///< quantity or table
  table,            ///< table
  table_points,     ///< [[x, y], ...]
  object,           ///< of kind FieldInfo::of
  map,              ///< name -> object of kind FieldInfo::of
  points,           ///< name -> three quantities
  positions,        ///< name -> position
  values,           ///< coordinate -> constant, or an object of kind FieldInfo::of
  overrides,        ///< parameter -> quantity
  names,            ///< name -> name
  rotations,        ///< one object of kind FieldInfo::of, or an array of them
  coefficients,     ///< name -> quantity, or "a", "b", "c" -> arrays
  parameters,       ///< name -> a constant, or an object of kind FieldInfo::of
  paths             ///< array of texts
};

enum class Need { optional, required };
enum class Bound { none, positive, not_negative };

/// One row of a table.
struct FieldInfo {
  std::string_view name = {};
  Shape shape = Shape::quantity;
  std::string_view doc = {};
  std::string_view unit = {};
  Need need = Need::optional;
  std::optional<double> fallback = std::nullopt;  ///< value of an absent number
  std::string_view fallback_word = {};            ///< value of an absent word
  Bound bound = Bound::none;
  Depends depends = Depends::all;
  bool angle = false;                             ///< {"deg": number} may be written
  bool by_points = false;                         ///< an axis may go from one point to another: its reader turns it
  bool at_start = false;                          ///< parameters that act at the start may stand in it
  std::size_t longest = 256;                      ///< bytes of a text
  std::size_t most = 2;                           ///< points of Shape::attachments
  std::span<const std::string_view> words = {};   ///< in the order of the enumeration they stand for
  std::span<const std::string_view> locals = {};  ///< variables of a Shape::force expression
  std::string_view of = {};                       ///< kind of the objects inside
};

/// A number that is constant, with its value where it is absent.
inline FieldInfo constant_info(std::string_view name, std::string_view doc, std::string_view unit, double fallback,
                               Bound bound, Depends depends) {
  return {.name = name,
          .shape = Shape::number,
          .doc = doc,
          .unit = unit,
          .fallback = fallback,
          .bound = bound,
          .depends = depends};
}

struct Reader;

/// A row with the member of Object that it fills.
template <class Object>
struct Field {
  FieldInfo info;
  void (*read)(Reader&, const Value&, const FieldInfo&, Object&);
  void (*set_default)(const FieldInfo&, Object&);
  void (*spoil)(Object&);  ///< marks the member as unreadable
};

/// The table of a kind of object; one specialisation per kind, in tables_*.cpp.
template <class Object>
std::span<const Field<Object>> fields();

/// A kind of object without its C++ type, for the schema.
struct ObjectKind {
  std::string_view name;
  std::string_view doc;
  std::vector<FieldInfo> fields;
  std::vector<std::string_view> exactly_one = {};  ///< of these fields one must be there, and only one
  /// the second field must be there where the first one is
  std::vector<std::pair<std::string_view, std::string_view>> needs = {};
};

/// The kind of the objects that a table describes.
template <class Object>
ObjectKind kind_of(std::string_view name, std::string_view doc, std::vector<std::string_view> exactly_one = {},
                   std::vector<std::pair<std::string_view, std::string_view>> needs = {}) {
  ObjectKind result{name, doc, {}, std::move(exactly_one), std::move(needs)};
  for (const Field<Object>& row : fields<Object>()) result.fields.push_back(row.info);
  return result;
}

/// Every kind, the whole file ("model") first.
std::vector<ObjectKind> object_kinds();

/// JSON text of the definitions of a schema: what fields share, then each of these kinds by its name.
std::string schema_definitions(const std::vector<ObjectKind>& kinds);

}  // namespace mbgen::reading
