#pragma once
// Common data of the parts of the reader: the model under construction, the names known so far and the problems found.
// An unreadable value is NaN or index -1, so that later checks do not report it again.

#include <array>
#include <deque>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <type_traits>

#include "compiler/expressions/names.hpp"
#include "compiler/model/model.hpp"
#include "compiler/model/vectors.hpp"
#include "compiler/reader/fields.hpp"
#include "compiler/reader/hardpoints.hpp"
#include "compiler/reader/scopes.hpp"
#include "compiler/reader/varied.hpp"

namespace mbgen::reading {

struct RoadFields;
struct TyreFields;

/// Position of a body's inertia, nullptr without one, and whether a physically impossible one is accepted.
struct WrittenInertia {
  const Value* value = nullptr;
  bool accepted = false;
};

/// One named object of a map of the model, from any of its files.
struct Entry {
  std::string name;     ///< in the model
  std::string written;  ///< in its file
  Place place;          ///< of the key
  const Value* value;
  std::size_t scope = 0;
  bool adds_points = false;  ///< to a body of another scope
};
using Entries = std::vector<Entry>;

/// An output in an expression.
struct WrittenOutputUse {
  Place place;
  std::size_t scope = 0;
  int output = -1;                  ///< index into Model::outputs
  bool sees_accelerations = false;  ///< see FieldInfo
};

struct Reader {
  Documents documents;
  std::deque<Value> changed_files = {};  ///< copies of included files with the changes of their includers
  std::deque<Value> composed = {};       ///< elements that a composition stands for, as written in their sections
  Problems problems;
  Problems notes;  ///< nothing is wrong
  Model model;
  Names names;
  std::array<NameMap<int>, ElementKinds::count> element_names = {};  ///< see names_of
  Hardpoints hardpoints = {};
  std::vector<Pose> body_frames = {};     ///< per body: its pose as written in its scope
  bool has_bodies = false;                ///< bodies and their points are read
  std::vector<WrittenInertia> inertias;   ///< per body
  std::vector<Place> body_places = {};    ///< per body: of its key
  std::vector<Scope> scopes = {Scope{}};  ///< the model, then its instances, each after the scope that places it
  std::size_t scope = 0;                  ///< whose text is being read
  std::size_t placed_scopes = 1;          ///< number of leading scopes with their placement
  std::vector<VariedParameter> varied = {};
  /// Samples of roads and large tables, see Model::samples: finished tables point to it while others are still added.
  std::shared_ptr<std::vector<double>> samples = std::make_shared<std::vector<double>>();
  std::vector<std::pair<int, std::size_t>> stored_numbers = {};  ///< of tables: place among the samples, count
  Entries tyre_data = {};                                        ///< coefficients of tyres
  std::vector<WrittenOutputUse> output_uses = {};
  std::size_t own_sampled = 0;  ///< sampled values before the loads of frictions
  bool folds_tunable = false;   ///< for the present value tunable parameters are replaced by their values
};

inline const Scope& current_scope(const Reader& reader) { return reader.scopes[reader.scope]; }

/// Names of the elements of a kind; expressions use those with a length, too.
template <class Kind>
NameMap<int>& names_of(Reader& reader) {
  if constexpr (KindOf<Kind>::has_length)
    return reader.names.lengths[length_place<Kind>()].names;
  else
    return reader.element_names[kKindIndex<Kind>];
}

/// Reads the text of a scope during its lifetime.
class InScope {
 public:
  InScope(Reader& reader, std::size_t scope) : reader_(reader), before_(reader.scope) { reader.scope = scope; }
  InScope(const InScope&) = delete;
  InScope& operator=(const InScope&) = delete;
  ~InScope() { reader_.scope = before_; }

 private:
  Reader& reader_;
  std::size_t before_;
};

constexpr double kUnreadable = std::numeric_limits<double>::quiet_NaN();
/// Values of `frame` of a force or a reaction.
constexpr std::array<std::string_view, 2> kFrames = {"global", "body"};

void report(Reader& reader, Place place, std::string message, std::string hint = {});
inline void report(Reader& reader, const Value& value, std::string message, std::string hint = {}) {
  report(reader, value.place, std::move(message), std::move(hint));
}

/// Adds a note on an entry that is allowed but unlikely.
void note(Reader& reader, Place place, std::string message, std::string hint = {});

/// Hints are omitted after many problems: nobody reads them, and the search for the nearest name takes long.
inline bool suggests(const Reader& reader) { return reader.problems.size() < 1000; }

/// Hint with the nearest known name.
template <class Target>
std::string suggestion(const Reader& reader, std::string_view word, const NameMap<Target>& names) {
  return suggests(reader) ? did_you_mean(word, names, current_scope(reader).visible) : std::string();
}

/// The member's value if present, else the object itself: position of a message about a field.
const Value& member_or_object(const Value& object, std::string_view key);

// Readers of one value by its type. Each reports a wrong value and leaves `target` unreadable then. An optional<int> is
// the index of a force expression; an unreadable optional word stays empty.
void read_value(Reader& reader, const Value& value, const FieldInfo& info, bool& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, double& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::string& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Quantity& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Vector3& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Matrix3& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::array<double, 4>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Vector3Quantity& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::array<Quantity, 6>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Attachment& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<Attachment>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, CoordinateReference& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Law& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Table& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Pose& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<std::array<double, 2>>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<double>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<std::vector<double>>& target);
void read_value(Reader& reader, const Value& value, const FieldInfo& info, const Value*& target);

/// constant + sum of factors * quantities, as an expression if one of them is an expression.
Quantity combination(Reader& reader, const Vector3& factors, const Vector3Quantity& quantities, double constant);
/// factor * quantity.
inline Quantity scaled(Reader& reader, double factor, const Quantity& quantity) {
  return combination(reader, {factor, 0, 0}, {quantity, 0.0, 0.0}, 0);
}

/// Index into info.words, or -1.
int read_word(Reader& reader, const Value& value, const FieldInfo& info);

/// Index of the element named by a text, -1 with a problem; -1 without a problem for any other value. kind: of the
/// elements, for people.
int find_named(Reader& reader, const Value& reference, std::string_view kind, const NameMap<int>& names);

/// The coordinate of this name. Fails: unknown, or a joint of several coordinates or none.
CoordinateReference read_coordinate(Reader& reader, Place place, const std::string& name);

/// Index of the expression in Model::expressions, -1 if unreadable.
int read_force_expression(Reader& reader, const Value& value, const FieldInfo& info);

template <class Enumeration>
requires std::is_enum_v<Enumeration>
void read_value(Reader& reader, const Value& value, const FieldInfo& info, Enumeration& target) {
  if (const int index = read_word(reader, value, info); index >= 0) target = static_cast<Enumeration>(index);
}

template <class Inner>
void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::optional<Inner>& target) {
  if constexpr (std::is_enum_v<Inner>) {
    if (const int index = read_word(reader, value, info); index >= 0) target = static_cast<Inner>(index);
  } else if constexpr (std::is_same_v<Inner, int>) {
    target = read_force_expression(reader, value, info);
  } else {
    Inner inner{};
    read_value(reader, value, info, inner);
    target = std::move(inner);
  }
}

/// Default of an absent member; members without a default in the table keep the default of their struct.
template <class Target>
void set_default(const FieldInfo& info, Target& target) {
  if constexpr (std::is_enum_v<Target>) {
    for (std::size_t i = 0; i < info.words.size(); ++i) {
      if (info.words[i] == info.fallback_word) target = static_cast<Target>(i);
    }
  } else if constexpr (std::is_arithmetic_v<Target> || std::is_same_v<Target, Quantity>) {
    if (info.fallback) target = static_cast<Target>(*info.fallback);
  } else if constexpr (std::is_same_v<Target, std::string>) {
    target = std::string(info.fallback_word);
  }
}

template <class Target>
void spoil(Target& target) {
  if constexpr (std::is_same_v<Target, double> || std::is_same_v<Target, Quantity>) target = kUnreadable;
  if constexpr (std::is_same_v<Target, Law>) target = Quantity(kUnreadable);
  if constexpr (std::is_same_v<Target, Vector3> || std::is_same_v<Target, Vector3Quantity>) target.fill(kUnreadable);
}

/// The row of a table for a member of Object (or of its base).
template <class Object, auto Member>
Field<Object> field(const FieldInfo& info) {
  return {info,
          [](Reader& reader, const Value& value, const FieldInfo& row, Object& object) {
            read_value(reader, value, row, object.*Member);
          },
          [](const FieldInfo& row, Object& object) { set_default(row, object.*Member); },
          [](Object& object) { spoil(object.*Member); }};
}

/// An object with every default of its table.
template <class Object>
Object with_defaults() {
  Object object{};
  for (const Field<Object>& row : fields<Object>()) row.set_default(row.info, object);
  return object;
}

/// Reports a value that is no object (false), and unknown, reserved and missing keys.
bool check_keys(Reader& reader, const Value& value, const std::vector<const FieldInfo*>& rows);

/// Fills the members of `object` that are present; missing required ones are reported and spoiled. Result: false if the
/// value is no object.
template <class Object>
bool read_fields(Reader& reader, const Value& value, Object& object) {
  const std::span<const Field<Object>> table = fields<Object>();
  std::vector<const FieldInfo*> rows;
  for (const Field<Object>& row : table) rows.push_back(&row.info);
  const bool readable = check_keys(reader, value, rows);
  for (const Field<Object>& row : table) {
    if (const Value* member = find(value, row.info.name)) {
      row.read(reader, *member, row.info, object);
    } else if (row.info.need == Need::required) {
      row.spoil(object);
    }
  }
  return readable;
}

/// Fills one list of the model: an element per entry, in order, with defaults, name and position set. check:
/// void(Reader&, const Value&, Element&) for rules beyond a table; called if the value is an object.
template <class Element, class Check>
void read_list(Reader& reader, const Entries& entries, std::vector<Element>& list, Check check) {
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    Element element = with_defaults<Element>();
    element.name = entry.name;
    element.where = where_of(reader.documents, entry.place);
    if (read_fields(reader, *entry.value, element)) check(reader, *entry.value, element);
    list.push_back(std::move(element));
  }
}

// Instances.
/// Reads a file, its included files and its subsystems into reader.scopes. Result: false if names defined in them could
/// not be read.
bool load_files(Reader& reader, const std::string& file, std::string text);
/// A file named by another one, and its canonical path.
struct NamedFile {
  std::string path, identity;
};
/// named: relative to the directory of `file`.
NamedFile beside(const std::string& file, const std::string& named);
/// Adds a file of the model that is not read by load_files, for positions in messages. Result: its index.
std::size_t add_document(Reader& reader, const std::string& file, std::string text);
/// Reads the poses of the instances. Requires: parameters are read.
void place_instances(Reader& reader);
/// Whether a body of the current scope belongs to the scope that places it: a connected body, or ground.
bool is_outer_body(const Reader& reader, std::string_view name);
/// Whether the current scope, or one that places it, connects its body `name` to a body of another name.
bool is_connected(const Reader& reader, std::string_view name);
/// Name of a body of the current scope in the innermost scope that defines it, or in the model.
std::string find_outer_name(const Reader& reader, std::string_view name);
/// Index of the body of this name in the current scope, or -1.
int find_body(const Reader& reader, std::string_view name);
/// Transforms a body of the current scope to its pose in the model.
void place_body(Reader& reader, Body& body);
/// The axes of a subsystem relative to the model, including its mirroring.
Matrix3 axes_of(const Placement& placement);
/// Removes rounding errors from a rotation: sine and cosine of quarter turns in degrees deviate by 1e-16, which would
/// make every structural zero of the equations a number.
Matrix3 without_rest(const Matrix3& rotation);
/// matrix * vector + constant
Vector3Quantity transformed(Reader& reader, const Matrix3& matrix, const Vector3Quantity& vector,
                            const Vector3& constant = {0, 0, 0});
/// 1, or -1 in a mirrored instance.
double handedness(const Placement& placement);
/// A point of the current scope in the frame of its body.
Vector3Quantity placed_point(Reader& reader, int body, const Vector3Quantity& written);
/// A direction of the current scope in global axes, mirrored where the scope is. Requires: the body was read.
Vector3 placed_direction(const Reader& reader, int body, const Vector3& written);
/// An axis of the current scope in global axes, in its positive direction: a mirrored rotation is positive such that
/// equal coordinates are mirrored motions, or keeps its direction.
Vector3 placed_axis(const Reader& reader, int body, const Vector3& written, FreedomKind kind);
/// Whether coordinates of this axis have the opposite sign to a mirrored motion.
bool is_reversed(const Reader& reader, const Vector3& written, FreedomKind kind);
/// Reports a use of a coordinate with the opposite sign inside a mirrored instance.
void refuse_reversed(Reader& reader, Place place, const CoordinateReference& coordinate);
/// Transforms the components of an applied force.
void place_force(Reader& reader, AppliedForce& force);

// The sections of a model, in the order of reading: each needs the names of those before it.
void read_parameters(Reader& reader, const Entries& entries);
void read_inputs(Reader& reader, const Entries& entries);
void read_bodies(Reader& reader, const Entries& entries);
void read_joints(Reader& reader, const Entries& entries);
/// Checks the inertias of groups of rigidly connected bodies. Requires: joints are read.
void check_inertias(Reader& reader);
/// Per body: the lowest index of the bodies rigidly connected to it by fixed joints.
std::vector<int> rigid_groups(const Model& model);
/// A group of rigidly connected bodies, in global axes at the reference: moments and products about the centre of mass.
struct RigidGroup {
  double mass = 0;   ///< kg
  Vector3 centre{};  ///< m
  std::array<double, 6> inertia{};
};
/// group: their number in rigid_groups.
RigidGroup rigid_group(const Model& model, const std::vector<int>& groups, int group);
/// Gives a tyre without an axis the axis of its wheel's joint, and notes unlikely entries.
void place_on_wheel(Reader& reader, const Value& value, const std::vector<int>& groups, TyreFields& tyre);
void read_rods(Reader& reader, const Entries& entries, const Entries& actuators);
void read_couplings(Reader& reader, const Entries& entries);
/// Adds the names of a joint's coordinates to its scope and the enclosing scopes; reports existing names.
void add_coordinates(Reader& reader, const Entry& entry, const Joint& joint, int index);
/// Gives a driven joint that is marked cut the coordinates for its motion: it moves a massless body, and a fixed joint
/// closes the loop. entry: of the motion.
void drive_at_cut(Reader& reader, const Entry& entry, int joint);
/// Whether an object has one of these fields.
bool has_any(const Value& value, std::initializer_list<std::string_view> keys);
/// Reports two ends on one body. Result: the distance of the ends at the reference, NaN if there is none.
double check_ends(Reader& reader, const Value& value, const Attachment& from, const Attachment& to);
/// States and sampled values; their expressions may name springs and air springs.
/// "an air spring".
inline std::string with_article(std::string_view words) {
  return (std::string_view("aeiou").find(words.front()) < 5 ? "an " : "a ") + std::string(words);
}

/// Adds the names of elements with a length for expressions, before the elements are read. entries: of every kind.
void name_lines(Reader& reader, const std::array<Entries, ElementKinds::count>& entries);
/// Sets default lags. Requires: the solver's settings are read.
void finish_lags(Reader& reader);
void read_roads(Reader& reader, const Entries& entries);
/// Adds the inputs of roads given by a host. Requires: the model's own inputs are read.
void add_host_inputs(Reader& reader, const Entries& roads);
/// Sets the host's plane as height and friction of `road`.
void lay_host_plane(Reader& reader, const Value& value, RoadFields& road);
/// Reports a second tyre, after `before`, on a road of a host.
void check_host_road(Reader& reader, const Value& value, const Tyre& tyre, const std::vector<Tyre>& before);
/// The road of an OpenCRG file, as a grid of `road`.
void read_crg_road(Reader& reader, const Value& value, Road& road);
void read_axles(Reader& reader, const Entries& entries);
void read_motions(Reader& reader, const Entries& entries);
/// Adds second rates to inputs of motions with a first rate only, see is_made_rate. Requires: all motions are read.
void make_second_rates(Reader& reader);
/// Makes the names of outputs known to expressions that are read before them.
void name_outputs(Reader& reader, const Entries& entries);
void read_outputs(Reader& reader, const Entries& entries);
/// Puts the outputs that expressions look at into Model::observed. Requires: read_outputs.
void observe_outputs(Reader& reader);
void read_shapes(Reader& reader, const Entries& entries);
/// A section that is one object, of one file.
struct Part {
  const Value* value;
  std::size_t scope = 0;
};
/// Files from the innermost instance and include to the main file: later values override.
void read_initial(Reader& reader, const std::vector<Part>& parts);
/// Initial orientations of joints, as values of their coordinates, after the existing ones.
void read_orientations(Reader& reader, const Value* values, Initial& initial);
void read_solver(Reader& reader, const std::vector<Part>& parts);
void read_vehicle(Reader& reader, const std::vector<Part>& parts);

// Values that are allowed but unlikely.
bool is_large_angle(double angle);
/// Notes an angle of more than a turn, probably typed in degrees.
void note_turns(Reader& reader, const Value& value, double angle);
/// Notes on the whole model. Requires: it has no problems.
void note_unlikely(Reader& reader);

// Geometry at the reference configuration.
/// "body.point" as the user writes it.
std::string attachment_text(const Model& model, const Attachment& attachment);
/// True for rotations. Requires: a valid reference.
bool is_rotation(const Model& model, const CoordinateReference& coordinate);
const std::string& coordinate_name(const Model& model, const CoordinateReference& coordinate);

}  // namespace mbgen::reading
