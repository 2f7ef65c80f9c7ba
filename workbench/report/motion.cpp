#include "workbench/report/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "compiler/model/element_access.hpp"
#include "workbench/report/forces.hpp"
#include "workbench/report/poses.hpp"
#include "workbench/report/table_states.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kShortestInterval = 0.01;  ///< s between two frames: more than a screen shows
/// Numbers that a page carries of each kind: 4 bytes, 5.3 in base64; poses and table together stay under 2 MB.
constexpr std::size_t kMostPoseNumbers = 240'000, kMostTableNumbers = 120'000;
constexpr std::size_t kFewestRows = 200;

const char* group_of(const std::string& name) {
  if (name.starts_with("z.")) return "coordinate";
  if (name.starts_with("zd.")) return "velocity";
  return name.starts_with("residual") ? "residual" : "output";
}

/// Springs and air springs are shown together: outputs name them by one field.
std::string quantity_shown(const ElementOutput& output) {
  if (is_stored_energy(output)) return "energy";
  const ElementQuantity quantity = quantity_of(output);
  std::string text;
  with_kind(output.kind, [&](auto kind) { text = fmt::format("{} {}", source_key(kind), quantity.name); });
  return quantity.components > 1 ? fmt::format("{} {}", text, output.axis) : text;
}

}  // namespace

std::vector<std::size_t> kept_rows(const std::vector<double>& time, std::size_t most) {
  const std::size_t rows = time.size();
  const double duration = time.back() - time.front();
  const auto wanted = static_cast<std::size_t>(std::ceil(duration / kShortestInterval)) + 1;
  const std::size_t count = std::clamp<std::size_t>(std::min(std::max(wanted, kFewestRows), most), 1, rows);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; ++i) {
    kept.push_back(count == 1 ? 0 : (i * (rows - 1) + (count - 1) / 2) / (count - 1));
  }
  return kept;
}

Result<std::vector<GenericState>> motion_frames(const ReportSource& source, const std::string& file,
                                                std::size_t results) {
  for (const TreeBody& body : source.topology.bodies) {
    if (find_column(source.results, "z." + body.coordinate) >= 0) continue;
    Diagnostic problem;
    problem.where.file = file;
    problem.message = fmt::format("no column \"z.{}\": not a result of model {}", body.coordinate, source.model.name);
    problem.hint = "give --model, or simulate again";
    return problem;
  }
  const std::size_t most = kMostPoseNumbers / (kPoseNumbers * source.model.bodies.size() * results);
  return table_states(source, kept_rows(source.results.columns.front().values, std::max(kFewestRows, most)));
}

Json motion_json(const GenericSolver& solver, const std::vector<GenericState>& frames) {
  std::vector<float> times, numbers;
  std::vector<Quaternion> before;
  for (const GenericState& frame : frames) {
    times.push_back(static_cast<float>(frame.t));
    add_poses(solver.poses(frame), before, numbers);
  }
  return {{"name", "motion"},
          {"kind", "time"},
          {"count", times.size()},
          {"times", base64(times)},
          {"poses", base64(numbers)}};
}

/// Outputs with one quantity are shown together: the same quantity of points, tyres, springs or joints, along one axis;
/// expressions with the same beginning of their name.
std::string quantity_of(const Output& output) {
  const auto numbered = [&](const char* kind, const auto& source) {
    return fmt::format("{} {}", kind, static_cast<int>(source.what));
  };
  if (const auto* point = std::get_if<PointOutput>(&output.source)) {
    return fmt::format("{} {}", numbered("point", *point), point->axis);
  }
  if (const auto* rotation = std::get_if<RotationOutput>(&output.source)) {
    const bool is_angle = rotation->what == RotationOutput::What::angle;
    return fmt::format("{} {}", numbered("rotation", *rotation), is_angle ? rotation->turn : rotation->axis);
  }
  if (const auto* momentum = std::get_if<MomentumOutput>(&output.source)) {
    const bool is_energy = momentum->what <= MomentumOutput::What::potential_energy;
    return is_energy ? "energy" : fmt::format("{} {}", numbered("momentum", *momentum), momentum->axis);
  }
  if (std::holds_alternative<StoredEnergyOutput>(output.source)) return "energy";
  if (const auto* element = std::get_if<ElementOutput>(&output.source)) return quantity_shown(*element);
  if (const auto* points = std::get_if<PointsOutput>(&output.source))
    return points->points[2].body < 0 ? "distance" : "angle";
  if (const auto* wheel = std::get_if<WheelOutput>(&output.source)) return numbered("wheel", *wheel);
  if (const auto* joint = std::get_if<CoordinateOutput>(&output.source)) return numbered("joint", *joint);
  if (const auto* reaction = std::get_if<ReactionOutput>(&output.source)) return numbered("reaction", *reaction);
  if (std::holds_alternative<ExpressionOutput>(output.source)) {
    return "expression " + output.name.substr(0, output.name.find_first_of("_0123456789"));
  }
  return std::holds_alternative<DriveOutput>(output.source) ? "drive" : "multiplier";
}

namespace {

/// A column of another result at times of the first one, on the straight line between its rows; NaN after its end.
std::vector<float> values_at(const Results& results, const Column& column, const std::vector<double>& times) {
  const std::vector<double>& own = results.columns.front().values;
  std::vector<float> values;
  std::size_t row = 0;
  for (const double t : times) {
    while (row + 2 < own.size() && own[row + 1] < t) ++row;
    const std::size_t next = std::min(row + 1, own.size() - 1);
    constexpr double kEnd = 1e-9;  // s
    const double span = own[next] - own[row];
    const double part = span > 0 ? std::clamp((t - own[row]) / span, 0.0, 1.0) : 0;
    const bool is_there = t >= own.front() - kEnd && t <= own.back() + kEnd;
    values.push_back(is_there
                         ? static_cast<float>(column.values[row] + part * (column.values[next] - column.values[row]))
                         : std::numeric_limits<float>::quiet_NaN());
  }
  return values;
}

/// The column of another result with the name and unit of a heading; none where it has no such.
const Column* same_column(const OtherResult& other, const Heading& heading) {
  for (const Column& column : other.source.results.columns)
    if (column.heading.name == heading.name && column.heading.unit == heading.unit) return &column;
  return nullptr;
}

}  // namespace

Json table_json(const ReportSource& source, const std::vector<OtherResult>& others) {
  const std::vector<Column>& columns = source.results.columns;
  const std::size_t most = std::max(kFewestRows, kMostTableNumbers / (columns.size() * (1 + others.size())));
  const std::vector<std::size_t> rows = kept_rows(columns.front().values, most);
  std::vector<double> times;
  for (const std::size_t row : rows) times.push_back(columns.front().values[row]);
  std::vector<float> numbers;
  Json list = Json::array();
  const auto describe = [&](const Column& column, const char* group) {
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    list.push_back({{"name", column.heading.name},
                    {"unit", column.heading.unit == "1" ? "" : column.heading.unit},
                    {"group", group},
                    {"smallest", *low},
                    {"largest", *high},
                    {"last", column.values.back()}});
  };
  std::map<std::string, std::string> quantities;
  for (const Output& output : source.model.outputs) quantities[output.name] = quantity_of(output);
  for (const Column& column : columns) {
    const bool is_slip = column.heading.name.starts_with("x.");  // a state of the solver; outputs tell of tyres
    if (is_slip) continue;
    describe(column, list.empty() ? "time" : group_of(column.heading.name));
    if (const auto found = quantities.find(column.heading.name); found != quantities.end()) {
      list.back()["quantity"] = found->second;
    }
    for (const std::size_t row : rows) numbers.push_back(static_cast<float>(column.values[row]));
    if (list.size() == 1) continue;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const Column* other = same_column(others[i], column.heading);
      if (other == nullptr) continue;
      const Json beside = list.back();
      describe(*other, group_of(column.heading.name));
      list.back()["name"] = fmt::format("{} ({})", column.heading.name, others[i].label);
      list.back()["other"] = i + 1;
      if (beside.contains("quantity")) list.back()["quantity"] = beside["quantity"];
      const std::vector<float> values = values_at(others[i].source.results, *other, times);
      numbers.insert(numbers.end(), values.begin(), values.end());
    }
  }
  for (const Column& column : element_forces(source, rows)) {
    describe(column, "force");
    for (const double value : column.values) numbers.push_back(static_cast<float>(value));
  }
  return {{"rows", rows.size()}, {"all_rows", source.results.rows()}, {"columns", list}, {"data", base64(numbers)}};
}

}  // namespace mbgen
