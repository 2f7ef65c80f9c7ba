#pragma once
// Table of fields of each kind of object of the model format, used for reading, JSON Schema and documentation.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/parse_expression.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {

/// Kind of value of a field.
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
  axis,             ///< a letter with sign, or three constants, or two points if FieldInfo::by_points
  attachment,       ///< "body.point"
  attachments,      ///< two of them, up to FieldInfo::most
  coordinate,       ///< name of a coordinate
  reference,        ///< name of another element, in the map FieldInfo::of
  force,            ///< expression with FieldInfo::locals
  equation,         ///< number or name of a closure equation
  law,              ///< quantity or table
  table,            ///< table
  table_points,     ///< [[x, y], ...]
  numbers,          ///< [x, ...], at least two
  rows,             ///< [[x, ...], ...], at least two by two
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
  paths,            ///< array of texts, and of objects of kind FieldInfo::of
  contents          ///< JSON Pointer -> any value
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
  bool by_points = false;                         ///< an axis may be given by two points; its reader transforms it
  bool at_start = false;                          ///< start parameters are allowed
  bool sees_accelerations = false;                ///< outputs over accelerations and reactions are allowed
  std::size_t longest = 256;                      ///< bytes of a text
  std::size_t most = 2;                           ///< points of Shape::attachments
  std::span<const std::string_view> words = {};   ///< in the order of their enumeration
  std::span<const std::string_view> locals = {};  ///< variables of a Shape::force expression
  std::string_view of = {};                       ///< kind of the objects inside
};

/// A constant number, with a default.
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

/// A row with its member of Object.
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
  std::vector<std::string_view> exactly_one = {};  ///< exactly one of these fields is required
  /// the second field is required if the first one is present
  std::vector<std::pair<std::string_view, std::string_view>> needs = {};
};

/// The kind of object described by a table.
template <class Object>
ObjectKind kind_of(std::string_view name, std::string_view doc, std::vector<std::string_view> exactly_one = {},
                   std::vector<std::pair<std::string_view, std::string_view>> needs = {}) {
  ObjectKind result{name, doc, {}, std::move(exactly_one), std::move(needs)};
  for (const Field<Object>& row : fields<Object>()) result.fields.push_back(row.info);
  return result;
}

/// Every kind, the whole file ("model") first.
std::vector<ObjectKind> object_kinds();

/// JSON text of the definitions of a schema: common parts of fields, then each of these kinds by its name.
std::string schema_definitions(const std::vector<ObjectKind>& kinds);

}  // namespace mbgen::reading
