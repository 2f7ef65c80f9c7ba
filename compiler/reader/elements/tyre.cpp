// Tyres and their coefficient sets.
#include "mbgen/tyres/tyre.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/tyres.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/read_turning.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/reader/tir_file.hpp"
#include "compiler/reader/tyre_notes.hpp"

namespace mbgen::reading {
namespace {

/// A coefficient set in the order of the runtime; empty if it could not be read.
struct CoefficientSet {
  TyreModel model = TyreModel::pac2002;
  std::vector<Quantity> coefficients;
  Place place = {};  ///< of the set
};

/// A coefficient of a set with names.
Quantity& coefficient(CoefficientSet& set, std::string_view name) {
  return set.coefficients[tyre_field_index(tyre_fields(set.model), name)];
}

std::vector<Quantity> read_named(Reader& reader, const Value& value, TyreModel model) {
  const std::span<const TyreField> fields = tyre_fields(model);
  std::vector<Quantity> coefficients;
  std::vector<std::string_view> known;
  for (const TyreField& row : fields) {
    coefficients.emplace_back(row.default_value);
    known.push_back(row.name);
  }
  for (const Member& member : value.members) {
    const std::size_t index = tyre_field_index(fields, member.key);
    if (index == fields.size()) {
      report(reader, member.place, "unknown tyre coefficient " + in_quotes(member.key),
             did_you_mean(member.key, known));
      continue;
    }
    const bool positive = is_scale(model, member.key) || member.key == "LONGVL";
    const FieldInfo info{.name = "coefficient", .bound = positive ? Bound::positive : Bound::none};
    read_value(reader, member.value, info, coefficients[index]);
  }
  for (const TyreField& row : fields) {
    if (is_scale(model, row.name) && !find(value, row.name))
      report(reader, value, "tyre coefficient " + in_quotes(row.name) + " is missing");
  }
  return coefficients;
}

std::vector<Quantity> read_pac89(Reader& reader, const Value& value) {
  const struct {
    std::string_view name;
    int count;
  } arrays[] = {{"a", kPac89ACount}, {"b", kPac89BCount}, {"c", kPac89CCount}};
  std::vector<Quantity> coefficients;
  for (const Member& member : value.members) {
    if (member.key != "a" && member.key != "b" && member.key != "c") {
      report(reader, member.place, "unknown key " + in_quotes(member.key), "a pac89 set has the arrays a, b and c");
    }
  }
  for (const auto& [name, count] : arrays) {
    const Value* array = find(value, name);
    if (!array) {
      report(reader, value, "key " + in_quotes(name) + " is missing");
    } else if (array->kind != Value::Kind::array || array->items.size() != static_cast<std::size_t>(count)) {
      report(reader, *array,
             fmt::format("must be an array of {} numbers, {}0 to {}{}, got {}", count, name, name, count - 1,
                         describe(*array)));
    } else {
      for (const Value& item : array->items) {
        read_value(reader, item, FieldInfo{.name = "coefficient"}, coefficients.emplace_back());
      }
    }
  }
  return coefficients;
}

std::vector<CoefficientSet> read_sets(Reader& reader, const Entries& entries) {
  std::vector<TyreDataFields> data;
  read_list(reader, entries, data, [](Reader&, const Value&, const TyreDataFields&) {});
  std::vector<CoefficientSet> sets;
  for (const TyreDataFields& fields : data) {
    reader.names.tyre_data.emplace(fields.name, static_cast<int>(sets.size()));
    CoefficientSet& set = sets.emplace_back();
    if (fields.coefficients) set.place = fields.coefficients->place;
    if (!fields.written_model || !fields.coefficients) continue;
    set.model = *fields.written_model;
    if (fields.coefficients->kind != Value::Kind::object) {
      report(reader, *fields.coefficients, "must be an object of coefficients, got " + describe(*fields.coefficients));
    } else {
      set.coefficients = set.model == TyreModel::pac89 ? read_pac89(reader, *fields.coefficients)
                                                       : read_named(reader, *fields.coefficients, set.model);
    }
  }
  return sets;
}

void check_tyre(Reader& reader, const Value& value, const std::vector<int>& groups, TyreFields& tyre) {
  constexpr double kSmallestTilt = 1e-3;  // rad between the axis and the vertical
  if (std::abs(tyre.side) != 1 && !std::isnan(tyre.side)) {
    report(reader, *find(value, "side"), fmt::format("side must be 1 or -1, got {}", tyre.side));
  }
  if (tyre.count != std::round(tyre.count) && !std::isnan(tyre.count)) {
    report(reader, *find(value, "count"), fmt::format("count must be a whole number, got {}", tyre.count));
  }
  if (tyre.centre.body >= 0 && tyre.centre.body == reader.model.ground) {
    report(reader, *find(value, "centre"), "a tyre on ground has no effect");
  }
  turn_axis_by_points(reader, find(value, "axis"), tyre.centre.body, tyre.axis);
  place_on_wheel(reader, value, groups, tyre);
  tyre.side *= handedness(current_scope(reader).placement);
  if (std::hypot(tyre.axis[0], tyre.axis[1]) < kSmallestTilt) {
    report(reader, member_or_object(value, "axis"), "axis of a tyre is vertical, the wheel would lie on the road");
  }
}

/// Relaxation lengths of a set at its nominal load and pressure, m; zero for missing ones.
tyre_law::Relaxation<double> nominal_relaxation(const CoefficientSet& set) {
  std::vector<double> values;
  for (const Quantity& q : set.coefficients) values.push_back(q.value);
  if (set.model == TyreModel::mf61) {
    const auto mf61 = MagicFormula61<double>::from_fields(values.data());
    const auto at = magic::mf61_state<double>(mf61, mf61.fnomin * mf61.lfzo, mf61.nompres, 1, 1);
    return {mf61.longitudinal_stiffness > 0 ? magic::mf61_relaxation_x(mf61, at) : 0,
            mf61.lateral_stiffness > 0 ? magic::mf61_relaxation_y(mf61, at) : 0};
  }
  const auto pac2002 = Pac2002<double>::from_fields(values.data());
  const double nominal = pac2002.fnomin * pac2002.lfzo;
  const auto at = magic::load_terms<double>(nominal, nominal, 1, 1);
  return {magic::pac2002_relaxation_x(pac2002, at),
          pac2002.pty2 == 0 ? 0 : magic::pac2002_relaxation_y<double>(pac2002, at, 0)};
}

/// A relaxation length not given by the model depends on the load according to the set, if it says so.
void take_relaxation(const Value& value, const CoefficientSet& set, TyreFields& tyre) {
  if (set.model == TyreModel::pac89) return;
  const tyre_law::Relaxation<double> of_set = nominal_relaxation(set);
  const auto take = [&](const char* key, double length, Quantity& target, bool& over_load) {
    over_load = !find(value, key) && length > 0;
    if (over_load) target = length;
  };
  take("relaxation_x", of_set.x, tyre.relaxation_x, tyre.over_load_x);
  take("relaxation_y", of_set.y, tyre.relaxation_y, tyre.over_load_y);
}

/// Takes over a set, and its properties that are not given by the model.
void use_coefficients(Reader& reader, const Value& value, CoefficientSet& set, TyreFields& tyre) {
  tyre.model = set.model;
  tyre.coefficients = set.coefficients;
  if (set.coefficients.empty()) return;
  note_tyre_set(reader, set.place, tyre);
  const auto take = [&](std::string_view key, std::string_view name, Quantity& target) {
    if (!find(value, key)) target = coefficient(set, name);
  };
  if (set.model == TyreModel::mf61) {
    take("pressure", "NOMPRES", tyre.pressure);
    take("rolling_resistance", "QSY1", tyre.rolling_resistance);
  } else if (const Member* pressure = find_member(value, "pressure")) {
    report(reader, pressure->place, "only a tyre with mf61 data has a pressure");
  }
  take_relaxation(value, set, tyre);
  if (set.model != TyreModel::pac89) {
    take("radius", "UNLOADED_RADIUS", tyre.radius);
  } else if (!find(value, "radius")) {
    report(reader, value, "a tyre with pac89 data needs \"radius\"");
  }
}

/// Notes steps of expressions: cams find edges of planks and potholes only.
void note_steps_below(Reader& reader, const Value& value, const TyreFields& tyre) {
  if (tyre.road < 0) return;
  const Road& road = reader.model.roads[static_cast<std::size_t>(tyre.road)];
  if (!road.height) return;
  const auto may_jump = [](const ExpressionNode& node) {
    return node.kind == ExpressionNode::Kind::call &&
           (node.function == Function::step || node.function == Function::sign || node.function == Function::select ||
            node.function == Function::floor);
  };
  if (std::ranges::any_of(reader.model.expressions[static_cast<std::size_t>(*road.height)].nodes, may_jump))
    note(
        reader, value.place,
        fmt::format("where the \"height\" of road \"{}\" jumps (step, sign, select), the force of this enveloping tyre "
                    "jumps too",
                    road.name),
        "make steps of planks and potholes: cams know their edges");
}

/// The envelope of a tyre, with the cam data of a file; after the road.
void use_envelope(Reader& reader, const CamsOfFile& of_file, TyreFields& tyre) {
  constexpr int kMostSamples = 50;  // to each side
  if (!tyre.enveloping) return;
  const Value& value = *tyre.enveloping;
  TyreEnvelope cams = with_defaults<TyreEnvelope>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, value, cams) || reader.problems.size() > problems) return;
  const auto take = [&](const char* key, const std::optional<double>& number, double& target) {
    if (number && !find(value, key)) target = *number;
  };
  take("base", of_file.base, cams.base);
  take("length", of_file.length, cams.length);
  take("height", of_file.height, cams.height);
  take("order", of_file.order, cams.order);
  if (cams.order < 1) report(reader, member_or_object(value, "order"), "order must be at least 1");
  if (cams.steps != std::round(cams.steps)) {
    report(reader, *find(value, "steps"), fmt::format("steps must be a whole number, got {}", cams.steps));
  } else if (const double places = (0.5 * cams.base + cams.length) / cams.spacing(); places > kMostSamples) {
    report(reader, member_or_object(value, "steps"),
           fmt::format("the cams look at {:.0f} places to each side, at most {} are possible", places, kMostSamples),
           "give fewer \"steps\" or a longer \"base\"");
  }
  if (tyre.road >= 0 && reader.model.roads[static_cast<std::size_t>(tyre.road)].is_of_one_point())
    report(reader, value, "an envelope looks at a road at several places, but this road tells a plane below one",
           "leave out \"enveloping\", or give the road heights over x and y in place of \"host\", slope_x and slope_y");
  note_steps_below(reader, value, tyre);
  if (reader.problems.size() == problems) tyre.envelope = cams;
}

/// The road under a tyre: the named one, or the only one.
void use_road(Reader& reader, const Value& value, TyreFields& tyre) {
  const NameMap<int>& roads = reader.names.roads;
  if (!tyre.written_road) {
    if (roads.size() == 1) tyre.road = 0;
    if (roads.size() > 1)
      report(reader, value, "tyre does not say on which of the roads it is",
             fmt::format("give it \"road\", for example \"road\": \"{}\"", roads.begin()->first));
    return;
  }
  if (!tyre.written_road->empty()) tyre.road = find_named(reader, *find(value, "road"), "road", roads);
}

/// Takes over coefficients from a .tir file, and properties of the tyre that are not given by the model.
void use_file(Reader& reader, const Value& value, TyreFields& tyre) {
  const Value& file = *find(value, "tir");
  if (file.kind != Value::Kind::text) return;
  const std::optional<TirTyre> read = read_tir(reader, file, {tyre.enveloping != nullptr, tyre.written_turn_slip});
  if (!read) return;
  use_envelope(reader, read->cams, tyre);
  CoefficientSet set{read->model, read->coefficients, read->nominal};
  use_coefficients(reader, value, set, tyre);
  const auto take = [&](std::string_view key, const std::optional<double>& number, Quantity& target) {
    if (number && !find(value, key)) target = *number;
  };
  take("stiffness", read->stiffness, tyre.stiffness);
  take("damping", read->damping, tyre.damping);
  take("rolling_resistance", read->rolling_resistance, tyre.rolling_resistance);
  take("pressure", read->pressure, tyre.pressure);
  if (!find(value, "stiffness") && tyre.stiffness.value <= 0)
    report(reader, file, "file has no VERTICAL_STIFFNESS above zero", "give the tyre its \"stiffness\"");
  use_turning(reader, value, read->turning, tyre);
}

/// Checks that coefficients come from a set of the model or from a file.
void check_source(Reader& reader, const Value& value) {
  const Member *data = find_member(value, "data"), *tir = find_member(value, "tir");
  if (!data && !tir) report(reader, value, "a tyre needs \"data\" or \"tir\"");
  if (data && tir) report(reader, tir->place, "tyre has both \"data\" and \"tir\"");
  if (data && !tir && !find(value, "stiffness")) report(reader, value, "key \"stiffness\" is missing");
}

void use_set(Reader& reader, const Value& value, const std::vector<CoefficientSet>& sets, TyreFields& tyre) {
  const Value* data = find(value, "data");
  const int index = data ? find_named(reader, *data, "tyre_data", reader.names.tyre_data) : -1;
  if (index < 0) return;
  CoefficientSet set = sets[static_cast<std::size_t>(index)];
  use_coefficients(reader, value, set, tyre);
  use_turning(reader, value, {}, tyre);
}

void read_tyres(Reader& reader, const Entries& tyres) {
  const std::vector<CoefficientSet> sets = read_sets(reader, reader.tyre_data);
  for (const Entry& entry : tyres) {
    names_of<Tyre>(reader).emplace(entry.name, static_cast<int>(names_of<Tyre>(reader).size()));
  }
  const std::vector<int> groups = rigid_groups(reader.model);
  std::vector<TyreFields> list;
  std::vector<Tyre> before;
  read_list(reader, tyres, list, [&](Reader& r, const Value& value, TyreFields& tyre) {
    check_source(r, value);
    check_tyre(r, value, groups, tyre);
    use_road(r, value, tyre);
    check_host_road(r, value, tyre, before);
    before.push_back(tyre);
    if (tyre.tir) {
      use_file(r, value, tyre);
    } else {
      use_envelope(r, {}, tyre);
      use_set(r, value, sets, tyre);
    }
  });
  for (const TyreFields& tyre : list) reader.model.tyres.push_back(tyre);
}

}  // namespace

ElementSection section_of(Leader<Tyre>) {
  return {"tyres on roads",
          [] {
            return std::vector<ObjectKind>{
                kind_of<TyreDataFields>("tyre_data", "coefficients of a tyre"),
                kind_of<TyreFields>("tyre", "a tyre on a road; exactly one of data and tir", {"data", "tir"},
                                    {{"data", "stiffness"}}),
                kind_of<TyreEnvelope>("tyre_envelope",
                                      "four cams that replace the road by a plane: a rear and a front one below each "
                                      "half of the tyre's width; lengths in unloaded radii of the tyre"),
                kind_of<TyrePatch>(
                    "tyre_patch", "contact patch of a tyre that turns about the road's normal, as for a parked wheel")};
          },
          read_tyres};
}

}  // namespace mbgen::reading
