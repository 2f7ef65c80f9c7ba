#include "compiler/report/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "compiler/report/forces.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

constexpr double kShortestInterval = 0.01;  ///< s between two frames: more than a screen shows
/// Numbers that a page carries of each kind: 4 bytes, 5.3 in base64; poses and table together stay under 2 MB.
constexpr std::size_t kMostPoseNumbers = 240'000, kMostTableNumbers = 120'000;
constexpr std::size_t kFewestRows = 200;
constexpr std::size_t kPoseNumbers = 7;

using Quaternion = std::array<double, 4>;  ///< x y z w

/// Source: S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1(3), 1978: divides by the
/// largest component.
Quaternion quaternion_of(const Matrix3& r) {
  const double trace = r[0] + r[4] + r[8];
  const std::array<double, 4> squares = {1 + 2 * r[0] - trace, 1 + 2 * r[4] - trace, 1 + 2 * r[8] - trace, 1 + trace};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const double twice = std::sqrt(std::max(0.0, squares[largest]));
  const double part = 0.5 / twice;
  const std::array<double, 3> off = {r[7] - r[5], r[2] - r[6], r[3] - r[1]};  // 4 w (x, y, z)
  const std::array<double, 3> sum = {r[5] + r[7], r[2] + r[6], r[1] + r[3]};  // 4 (yz, xz, xy)
  Quaternion q{};
  q[largest] = 0.5 * twice;
  if (largest == 3) {
    for (int i = 0; i < 3; ++i) q[i] = off[i] * part;
    return q;
  }
  q[3] = off[largest] * part;
  for (int i = 0; i < 3; ++i) {
    if (i != largest) q[i] = sum[3 - i - largest] * part;
  }
  return q;
}

/// Columns of the coordinates of a model in a result, in the order of the tree.
Result<std::vector<int>> coordinate_columns(const ReportSource& source, const std::string& file) {
  std::vector<int> columns;
  for (const TreeBody& body : source.topology.bodies) {
    columns.push_back(find_column(source.results, "z." + body.coordinate));
    if (columns.back() >= 0) continue;
    Diagnostic problem;
    problem.where.file = file;
    problem.message = fmt::format("no column \"z.{}\": not a result of model {}", body.coordinate, source.model.name);
    problem.hint = "give --model, or simulate again";
    return problem;
  }
  return columns;
}

const char* group_of(const std::string& name) {
  if (name.starts_with("z.")) return "coordinate";
  if (name.starts_with("zd.")) return "velocity";
  return name.starts_with("residual") ? "residual" : "output";
}

}  // namespace

std::string base64(const std::vector<float>& numbers) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes(numbers.size() * sizeof(float));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned long three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kLetters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

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

Result<Json> motion_json(const ReportSource& source, const std::string& file) {
  const Result<std::vector<int>> columns = coordinate_columns(source, file);
  if (!columns) return columns.problems();
  const std::vector<Column>& table = source.results.columns;
  const GenericSolver solver(source.model, source.topology, source.analysis);
  GenericState state;
  state.z.resize(columns->size());
  state.zd.assign(columns->size(), 0.0);
  std::vector<float> times, numbers;
  std::vector<Quaternion> before(source.model.bodies.size(), Quaternion{0, 0, 0, 1});
  const std::size_t most = kMostPoseNumbers / (kPoseNumbers * source.model.bodies.size());
  for (const std::size_t row : kept_rows(table.front().values, std::max(kFewestRows, most))) {
    state.t = table.front().values[row];
    for (std::size_t i = 0; i < columns->size(); ++i) state.z[i] = table[(*columns)[i]].values[row];
    times.push_back(static_cast<float>(state.t));
    const std::vector<Pose> poses = solver.poses(state);
    for (std::size_t b = 0; b < poses.size(); ++b) {
      Quaternion q = quaternion_of(poses[b].rotation);
      double along = 0;
      for (int i = 0; i < 4; ++i) along += q[i] * before[b][i];
      for (double& component : q) component = along < 0 ? -component : component;  // the shorter way between frames
      before[b] = q;
      for (const double x : poses[b].origin) numbers.push_back(static_cast<float>(x));
      for (const double x : q) numbers.push_back(static_cast<float>(x));
    }
  }
  return Json{{"name", "motion"},
              {"kind", "time"},
              {"count", times.size()},
              {"times", base64(times)},
              {"poses", base64(numbers)}};
}

Json table_json(const ReportSource& source) {
  const std::vector<Column>& columns = source.results.columns;
  const std::size_t most = std::max(kFewestRows, kMostTableNumbers / columns.size());
  const std::vector<std::size_t> rows = kept_rows(columns.front().values, most);
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
  for (const Column& column : columns) {
    describe(column, list.empty() ? "time" : group_of(column.heading.name));
    for (const std::size_t row : rows) numbers.push_back(static_cast<float>(column.values[row]));
  }
  for (const Column& column : element_forces(source, rows)) {
    describe(column, "force");
    for (const double value : column.values) numbers.push_back(static_cast<float>(value));
  }
  return {{"rows", rows.size()}, {"all_rows", source.results.rows()}, {"columns", list}, {"data", base64(numbers)}};
}

}  // namespace mbgen
