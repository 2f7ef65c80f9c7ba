// Tables of many points, kept as data: read from a file, then held against a search of our own and closed forms.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/expressions/curve.hpp"
#include "compiler/expressions/table_pieces.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

/// Points of a function over [-1, 1], equally apart or at places that wander by up to `ragged` of their distance.
std::string csv_of(int count, double ragged, double (*f)(double)) {
  std::string text = "x,y\n";
  for (int i = 0; i < count; ++i) {
    const bool is_end = i == 0 || i == count - 1;
    const double x = -1 + 2 * (i + (is_end ? 0 : ragged * std::sin(7.0 * i))) / (count - 1);
    text += fmt::format("{},{}\n", x, f(x));
  }
  return text;
}

class LargeTable : public ModelFiles {
 protected:
  /// The model of an arm on springs, their stiffness the tables of these files.
  std::string arm_on(const std::vector<std::string>& files, const std::string& more) {
    std::string springs;
    for (std::size_t i = 0; i < files.size(); ++i)
      springs += fmt::format(R"({}"s{}": {{ "from": "ground.T", "to": "arm.B", "stiffness": {{ "csv": "{}"{} }} }})",
                             i == 0 ? "" : ", ", i, files[i], more);
    return write("model.json", arm_model("\"springs\": { " + springs + " }"));
  }
  Table table_of(const std::string& csv, const std::string& more) {
    write("law.csv", csv);
    model_ = read_file(arm_on({"law.csv"}, more));
    return std::get<Table>(*model_.springs.at(0).stiffness);
  }
  Model model_;
};

struct Points {
  int count;
  double ragged;
};

// From one power of two to the next, so that each first step of the search comes.
constexpr Points kPoints[] = {{129, 0},   {129, 0.4},  {255, 0.4}, {256, 0.45},
                              {257, 0.2}, {500, 0.45}, {1023, 0},  {1000, 0.3}};

/// Places between, at and beyond the points.
std::vector<double> places_of(const Table& table, double beyond) {
  std::vector<double> places = table.x;
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i)
    for (const double part : {1e-9, 0.3, 1 - 1e-9}) places.push_back(table.x[i] + part * (table.x[i + 1] - table.x[i]));
  for (double at = 1; at < beyond; at += 0.173) places.insert(places.end(), {at, -at});
  return places;
}

TEST_F(LargeTable, StraightLinesAreThoseOfASearch) {
  for (const Points& points : kPoints) {
    const Table table = table_of(csv_of(points.count, points.ragged, [](double x) { return std::sin(9 * x); }), "");
    ASSERT_TRUE(table.data);
    EXPECT_EQ(table.data->spacing > 0, points.ragged < 0.25);
    EXPECT_EQ(model_.samples->size(), 4u * static_cast<std::size_t>(points.count + 1));
    const std::vector<double>&x = table.x, &y = table.y;
    // Trapezia up to each point, from the first one.
    std::vector<double> area = {0};
    for (std::size_t i = 1; i < x.size(); ++i) area.push_back(area.back() + (x[i] - x[i - 1]) * (y[i] + y[i - 1]) / 2);
    const auto piece_of = [&](double at) {
      const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin();
      return static_cast<std::size_t>(next - 1);
    };
    const auto line = [&](std::size_t i, double at) {
      return y[i] + (y[i + 1] - y[i]) * ((at - x[i]) / (x[i + 1] - x[i]));
    };
    const auto integral = [&](double at) {
      const std::size_t i = piece_of(at);
      return area[i] + (at - x[i]) * (y[i] + line(i, at)) / 2;
    };
    for (const double at : places_of(table, 40)) {
      EXPECT_NEAR(value_along(table, at), line(piece_of(at), at), 1e-13 * (1 + 9 * std::abs(at))) << at;
      EXPECT_NEAR(integral_along(table, at), integral(at) - integral(0), 1e-13 * (1 + 9 * at * at)) << at;
    }
  }
}

// A spline through points of a cubic is the cubic, and goes straight on beyond.
TEST_F(LargeTable, SplinesOfACubicAreTheCubic) {
  const auto f = [](double x) { return 0.3 + x * (2 + x * (-0.7 + x * 1.3)); };
  const auto slope = [](double x) { return 2 + x * (-1.4 + x * 3.9); };
  const auto integral = [](double x) { return x * (0.3 + x * (1 + x * (-0.7 / 3 + x * 1.3 / 4))); };
  for (const Points& points : kPoints) {
    const Table table = table_of(csv_of(points.count, points.ragged, f), R"(, "interpolation": "spline")");
    ASSERT_TRUE(table.data);
    for (const double at : places_of(table, 5)) {
      const double end = std::clamp(at, -1.0, 1.0), more = at - end;
      const double scale = 1e-12 * (1 + at * at);
      const CurvePoint<double> point = curve_at(table, at);
      EXPECT_NEAR(value_along(table, at), f(end) + slope(end) * more, scale) << at;
      EXPECT_NEAR(point.value, f(end) + slope(end) * more, scale) << at;
      EXPECT_NEAR(point.slope, slope(end), 1e-9) << at;
      // Second differences of rounded points: their rounding over the square of their distance.
      if (std::abs(at) < 1) {
        EXPECT_NEAR(point.curvature, -1.4 + 7.8 * at, 1e-15 * points.count * points.count * 10) << at;
      }
      EXPECT_NEAR(integral_along(table, at), integral(end) + more * (f(end) + slope(end) * more / 2), scale) << at;
    }
  }
}

// Period after period, each higher; the seam is met from both sides.
TEST_F(LargeTable, PeriodsGoOn) {
  const auto f = [](double x) { return std::sin(std::numbers::pi * x) + 0.25 * x; };
  for (const char* interpolation : {"linear", "monotone_cubic", "spline"}) {
    for (const Points& points : kPoints) {
      const Table table = table_of(csv_of(points.count, points.ragged, f),
                                   fmt::format(R"(, "interpolation": "{}", "periodic": true)", interpolation));
      ASSERT_TRUE(table.data);
      const bool is_linear = table.slopes.empty();
      const double width = 2.0 * 1.9 / points.count, error = is_linear ? 1.3 * width * width : 2 * width * width;
      for (double at = -7.003; at < 7; at += 0.01) {
        EXPECT_NEAR(value_along(table, at), f(at), error) << interpolation << " " << at;
        const double integral = (1 - std::cos(std::numbers::pi * at)) / std::numbers::pi + at * at / 8;
        EXPECT_NEAR(integral_along(table, at), integral, 4 * error) << interpolation << " " << at;
        if (is_linear) continue;
        const CurvePoint<double> point = curve_at(table, at);
        EXPECT_NEAR(point.value, value_along(table, at), 1e-13) << interpolation << " " << at;
        const double step = 1e-6, ahead = curve_at(table, at + step).value, behind = curve_at(table, at - step).value;
        EXPECT_NEAR(point.slope, (ahead - behind) / (2 * step), 1e-4) << interpolation << " " << at;
      }
      for (const double seam : {-3.0, -1.0, 1.0, 5.0})
        EXPECT_NEAR(value_along(table, seam - 1e-12), value_along(table, seam + 1e-12), 1e-11) << interpolation;
    }
  }
}

// The same points as operations: what a small table does is what a large one does.
TEST_F(LargeTable, IsWhatItsPointsAreAsOperations) {
  for (const char* interpolation : {"linear", "monotone_cubic", "spline"}) {
    for (const char* period : {"", R"(, "periodic": true)"}) {
      const Table table =
          table_of(csv_of(300, 0.45, [](double x) { return std::abs(x - 0.21) + std::floor(3 * x) / 3; }),
                   fmt::format(R"(, "interpolation": "{}"{})", interpolation, period));
      ASSERT_TRUE(table.data);
      Table as_operations = table;
      as_operations.data.reset();
      for (const double at : places_of(table, 6)) {
        EXPECT_NEAR(value_along(table, at), value_along(as_operations, at), 3e-13) << interpolation << " " << at;
        EXPECT_NEAR(integral_along(table, at), integral_along(as_operations, at), 1e-12) << interpolation << " " << at;
      }
      EXPECT_TRUE(std::isnan(value_along(table, std::numeric_limits<double>::quiet_NaN())));
    }
  }
}

TEST_F(LargeTable, EqualOnesAreKeptOnceAndSmallOnesNot) {
  const auto square = [](double x) { return x * x; };
  write("one.csv", csv_of(200, 0, square));
  write("same.csv", csv_of(200, 0, square));
  write("other.csv", csv_of(200, 0.4, square));
  write("small.csv", csv_of(128, 0, square));
  const Model model = read_file(arm_on({"one.csv", "same.csv", "other.csv", "small.csv", "one.csv"}, ""));
  ASSERT_TRUE(model.samples);
  EXPECT_EQ(model.samples->size(), 2u * 4 * 201);
  const auto first = [&](std::size_t i) {
    const std::optional<TableData>& data = std::get<Table>(*model.springs.at(i).stiffness).data;
    return data ? data->first : -1;
  };
  EXPECT_EQ((std::vector<int>{first(0), first(1), first(2), first(3), first(4)}), (std::vector<int>{0, 0, 804, -1, 0}));
  EXPECT_EQ(std::get<Table>(*model.springs[2].stiffness).data->samples, model.samples);
  EXPECT_FALSE(read_file(arm_on({"small.csv"}, "")).samples);
}

TEST_F(LargeTable, OfTooManyPointsIsRefusedWithItsPlaceAndTheLimit) {
  write("law.csv", csv_of(300'001, 0, [](double x) { return x; }));
  const std::string path = arm_on({"law.csv"}, "");
  const Result<Model> refused = read_model_file(path);
  ASSERT_FALSE(refused);
  const std::string text = to_text(refused.problems()),
                    hint = "\n  hint: leave out points that lie on the curve through their neighbours\n";
  EXPECT_TRUE(text.starts_with(
      path + ":6:176: /springs/s0/stiffness/csv: table has 300001 points, at most 300000 go into a solver\n"))
      << text;
  EXPECT_TRUE(text.ends_with(hint)) << text;
  write("law.csv", csv_of(300'000, 0, [](double x) { return x; }));
  const Model model = read_file(path);
  EXPECT_NEAR(value_along(std::get<Table>(*model.springs.at(0).stiffness), 0.123456), 0.123456, 1e-15);
}

}  // namespace
}  // namespace mbgen
