// Tyres and their coefficient sets.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/positions.hpp"
#include "compiler/model/raw.hpp"
#include "compiler/model/reader.hpp"
#include "compiler/model/tir_file.hpp"
#include "mbgen/tyre.hpp"

namespace mbgen::reading {
namespace {

/// A coefficient set in the order of the runtime; empty when it could not be read.
struct CoefficientSet {
  TyreModel model = TyreModel::pac2002;
  std::vector<Quantity> coefficients;
};

constexpr std::string_view kRadiusName = "UNLOADED_RADIUS", kLoadName = "FNOMIN";

std::size_t pac2002_index(std::string_view name) {
  const auto* found = std::find_if(std::begin(kPac2002Fields), std::end(kPac2002Fields),
                                   [&](const TyreField& row) { return row.name == name; });
  return static_cast<std::size_t>(found - std::begin(kPac2002Fields));
}

std::vector<Quantity> read_pac2002(Reader& reader, const Value& value) {
  std::vector<Quantity> coefficients;
  std::vector<std::string_view> known;
  for (const TyreField& row : kPac2002Fields) {
    coefficients.emplace_back(row.default_value);
    known.push_back(row.name);
  }
  for (const Member& member : value.members) {
    const std::size_t index = pac2002_index(member.key);
    if (index == kPac2002Count) {
      report(reader, member.place, "unknown tyre coefficient " + in_quotes(member.key),
             did_you_mean(member.key, known));
      continue;
    }
    const bool scale = member.key == kRadiusName || member.key == kLoadName;
    const FieldInfo info{.name = "coefficient", .bound = scale ? Bound::positive : Bound::none};
    read_value(reader, member.value, info, coefficients[index]);
  }
  for (const std::string_view name : {kRadiusName, kLoadName}) {
    if (!find(value, name)) report(reader, value, "tyre coefficient " + in_quotes(name) + " is missing");
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
    if (!fields.written_model || !fields.coefficients) continue;
    set.model = *fields.written_model;
    if (fields.coefficients->kind != Value::Kind::object) {
      report(reader, *fields.coefficients, "must be an object of coefficients, got " + describe(*fields.coefficients));
    } else {
      set.coefficients = set.model == TyreModel::pac2002 ? read_pac2002(reader, *fields.coefficients)
                                                         : read_pac89(reader, *fields.coefficients);
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

/// Takes coefficients from a .tir file, and properties of the tyre that the model does not give.
void use_file(Reader& reader, const Value& value, TyreFields& tyre) {
  const Value& file = *find(value, "tir");
  if (file.kind != Value::Kind::text) return;
  const std::optional<TirTyre> read = read_tir(reader, file);
  if (!read) return;
  tyre.model = TyreModel::pac2002;
  tyre.coefficients = read->coefficients;
  const auto take = [&](std::string_view key, const std::optional<double>& number, Quantity& target) {
    if (number && !find(value, key)) target = *number;
  };
  take("radius", read->coefficients[pac2002_index(kRadiusName)].value, tyre.radius);
  take("stiffness", read->stiffness, tyre.stiffness);
  take("damping", read->damping, tyre.damping);
  take("rolling_resistance", read->rolling_resistance, tyre.rolling_resistance);
  take("relaxation_x", read->relaxation_x, tyre.relaxation_x);
  take("relaxation_y", read->relaxation_y, tyre.relaxation_y);
  if (!find(value, "stiffness") && tyre.stiffness.value <= 0)
    report(reader, file, "file has no VERTICAL_STIFFNESS above zero", "give the tyre its \"stiffness\"");
}

/// Coefficients stand in a set of the model or in a file.
void check_source(Reader& reader, const Value& value) {
  const Member *data = find_member(value, "data"), *tir = find_member(value, "tir");
  if (!data && !tir) report(reader, value, "a tyre needs \"data\" or \"tir\"");
  if (data && tir) report(reader, tir->place, "tyre has both \"data\" and \"tir\"");
  if (data && !tir && !find(value, "stiffness")) report(reader, value, "key \"stiffness\" is missing");
}

void use_set(Reader& reader, const Value& value, const std::vector<CoefficientSet>& sets, TyreFields& tyre) {
  const auto found = find_visible(reader.names.tyre_data, tyre.data, current_scope(reader).visible);
  if (found == reader.names.tyre_data.end()) {
    const Value* data = find(value, "data");
    if (!data || data->kind != Value::Kind::text) return;
    report(reader, *data, "unknown tyre_data " + in_quotes(tyre.data),
           suggestion(reader, tyre.data, reader.names.tyre_data));
    return;
  }
  const CoefficientSet& set = sets[static_cast<std::size_t>(found->second)];
  tyre.model = set.model;
  tyre.coefficients = set.coefficients;
  if (find(value, "radius") || set.coefficients.empty()) return;
  if (set.model == TyreModel::pac2002) {
    tyre.radius = set.coefficients[pac2002_index(kRadiusName)];
  } else {
    report(reader, value, "a tyre with pac89 data needs \"radius\"");
  }
}

}  // namespace

void read_tyres(Reader& reader, const Entries& tyre_data, const Entries& tyres) {
  const std::vector<CoefficientSet> sets = read_sets(reader, tyre_data);
  for (const Entry& entry : tyres) {
    reader.names.tyres.emplace(entry.name, static_cast<int>(reader.names.tyres.size()));
  }
  const std::vector<int> groups = rigid_groups(reader.model);
  std::vector<TyreFields> list;
  read_list(reader, tyres, list, [&](Reader& r, const Value& value, TyreFields& tyre) {
    check_source(r, value);
    check_tyre(r, value, groups, tyre);
    if (tyre.tir) {
      use_file(r, value, tyre);
    } else {
      use_set(r, value, sets, tyre);
    }
  });
  for (const TyreFields& tyre : list) reader.model.tyres.push_back(tyre);
}

}  // namespace mbgen::reading
