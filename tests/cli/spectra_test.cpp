// Spectra, weighted accelerations and chosen rows of `plot`.

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

class Spectra : public CommandLine {
 protected:
  /// A table with an acceleration "a", at steps of 1/100 s.
  void write_series(const std::string& name, std::size_t rows, const std::function<double(double)>& of) const {
    std::string text = "t [s],a [m/s^2],x [m]\n";
    for (std::size_t i = 0; i < rows; ++i)
      text += fmt::format("{},{},{}\n", 0.01 * static_cast<double>(i), of(0.01 * static_cast<double>(i)), i);
    write(name, text);
  }
  std::string refusal(const std::string& words) const {
    const Outcome run = mbgen(words);
    EXPECT_EQ(run.exit_code, 1) << words;
    EXPECT_EQ(run.out, "");
    return run.err;
  }
};

TEST_F(Spectra, ASineHasItsMeanSquareAtItsFrequency) {
  write_series("a.csv", 2000, [](double t) { return 9.81 + 0.6 * std::sin(kTwoPi * 5 * t); });
  ASSERT_EQ(mbgen("plot a.csv --columns a --psd --segment 4 -o d.csv").exit_code, 0);
  const Table density = table("d.csv");
  EXPECT_EQ(density.names, (std::vector<std::string>{"frequency [Hz]", "a [(m/s^2)^2/Hz]"}));
  ASSERT_EQ(density.rows.size(), 201u);
  double sum = 0;
  for (const auto& row : density.rows) sum += row[1] * 0.25;
  EXPECT_NEAR(sum, 0.18, 1e-12);
  EXPECT_EQ(density.rows[20][0], 5);
  EXPECT_NEAR(density.rows[20][1], 0.18 * 2 / 3 / 0.25, 1e-12);
  EXPECT_NEAR(density.rows[21][1], 0.18 / 6 / 0.25, 1e-12);
  // A quarter of the rows where no length is given; the axes of the picture are logarithmic.
  ASSERT_EQ(mbgen("plot a.csv --columns a --psd -o quarter.csv").exit_code, 0);
  EXPECT_EQ(table("quarter.csv").rows.size(), 251u);
  const Outcome picture = mbgen("plot a.csv --columns a,x --psd");
  for (const char* text :
       {">frequency, Hz</text>", ">(m/s^2)^2/Hz</text>", ">m^2/Hz</text>", ">0.1</text>", ">10</text>"})
    EXPECT_NE(picture.out.find(text), std::string::npos) << text;
}

// scipy.signal.welch, whose defaults are ours: Hann windows, overlap by half, without means, one-sided density.
TEST_F(Spectra, NoiseHasTheDensityOfScipy) {
  if (std::system("python3 -c 'import scipy.signal' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-scipy is not installed";
  std::mt19937 random(4);
  std::normal_distribution<double> normal(1, 2);
  write_series("a.csv", 3001, [&](double) { return normal(random); });
  ASSERT_EQ(mbgen("plot a.csv --columns a --psd --segment 2.51 -o d.csv").exit_code, 0);
  write("welch.py",
        "import csv, scipy.signal\n"
        "a = [float(row[1]) for row in list(csv.reader(open('a.csv')))[1:]]\n"
        "for f, p in zip(*scipy.signal.welch(a, 100.0, nperseg=251)): print(repr(float(f)), repr(float(p)))\n");
  std::istringstream lines(shell("python3 welch.py").out);
  const Table density = table("d.csv");
  std::size_t row = 0;
  for (double f = 0, p = 0; lines >> f >> p; ++row) {
    ASSERT_LT(row, density.rows.size());
    EXPECT_NEAR(density.rows[row][0], f, 1e-9);
    EXPECT_NEAR(density.rows[row][1], p, 1e-9 * p + 1e-12) << f;
  }
  EXPECT_EQ(row, density.rows.size());
}

TEST_F(Spectra, AWeightedAccelerationIsFelt) {
  write_series("a.csv", 6000, [](double t) { return 9.81 + std::sin(kTwoPi * 4 * t); });
  const Outcome run = mbgen("plot a.csv --columns a --weight k -o felt.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("a of a.csv, W_k of ISO 2631-1: 0.68")) << run.out;
  const Table felt = table("felt.csv");
  EXPECT_EQ(felt.names, (std::vector<std::string>{"t [s]", "W_k(a) [m/s^2]"}));
  double largest = 0;
  for (std::size_t i = 2000; i < 4000; ++i) largest = std::max(largest, std::abs(felt.rows[i][1]));
  EXPECT_NEAR(largest, 0.967, 0.005);  // ISO 8041-1, table B.8: 0.9648 at 3.981 Hz, 1.039 at 5.012 Hz
  const Outcome spectrum = mbgen("plot a.csv --columns a --weight d --psd --segment 10 -o d.csv");
  EXPECT_TRUE(spectrum.out.starts_with("a of a.csv, W_d of ISO 2631-1: 0.36")) << spectrum.out;
}

TEST_F(Spectra, AMetricIsTheWeightedAcceleration) {
  write("m.json", R"json({ "mbgen": 1, "name": "seat", "gravity": [0, 0, 0], "parameters": { "size": 1 },
    "bodies": { "ground": { "points": { "o": [0, 0, 0] } },
                "seat": { "mass": 1, "inertia": [1, 1, 1], "points": { "o": [0, 0, 0] } } },
    "joints": { "lift": { "type": "prismatic", "from": "ground.o", "to": "seat.o", "axis": "z" } },
    "joint_forces": { "shake": { "joint": "lift", "force": "size * sin(25.1327412287 * t)" } },
    "outputs": { "az": { "point": "seat.o", "quantity": "acceleration", "axis": "z" } } })json");
  const Json study = json_of(
      "sweep m.json --vary size=1,2 --metric 'wk(az)' --metric 'wd(az)' --duration 20 --step 5e-3 --engine generic "
      "--json --out s.csv");
  const double both[] = {0.967, 0.511};  // at 4 Hz, between the standard's factors at 3.981 Hz and 5.012 Hz
  for (std::size_t k = 0; k < 2; ++k) {
    const auto metric = [&](std::size_t i) { return study["cases"][i]["metrics"][k].get<double>(); };
    EXPECT_NEAR(metric(0) * std::numbers::sqrt2 / both[k], 1, 0.015);
    EXPECT_NEAR(metric(1) / metric(0), 2, 1e-9);
  }
}

TEST_F(Spectra, RowsAreChosen) {
  write("s.csv", "case,bar [N],mass [kg],lean,status\n1,5,1,10,ok\n2,5,2,20,ok\n3,7,1,30,ok\n4,7,2,40,ok\n5,9,2,,no\n");
  const auto rows = [&](const std::string& where) {
    const Outcome run = mbgen("plot s.csv --columns lean " + where + " -o r.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::vector<double> cases;
    for (const auto& row : table("r.csv").rows) cases.push_back(row[0]);
    return cases;
  };
  EXPECT_EQ(rows("--where 'bar >= 7' --where 'mass = 2' --where 'lean > 0'"), (std::vector<double>{4}));
  EXPECT_EQ(rows("--where 'bar != 7' --where 'lean < 100'"), (std::vector<double>{1, 2}));
  EXPECT_EQ(rows("--where 'case<=3' --where bar=5"), (std::vector<double>{1, 2}));
  EXPECT_EQ(refusal("plot s.csv --columns lean --where 'bar > 9'"), "--where: s.csv has no such row\n");
  EXPECT_EQ(refusal("plot s.csv --columns lean --where 'bat > 9'"),
            "--where: s.csv has no column \"bat\"; did you mean \"bar\"?\n");
  EXPECT_EQ(refusal("plot s.csv --columns lean --where bar"),
            "--where \"bar\": must be COLUMN SIGN NUMBER, with one of = != < <= > >=\n");
  EXPECT_EQ(refusal("plot s.csv --columns lean --where 'bar > x'"), "--where: \"x\" is not a finite number\n");
}

TEST_F(Spectra, SaysWhatItCannotDo) {
  write_series("a.csv", 400, [](double t) { return t; });
  write("uneven.csv", "t [s],a [m/s^2]\n0,1\n1,2\n3,2\n4,1\n");
  write("slow.csv", "t [s],a [m/s^2]\n0,1\n1,2\n2,2\n3,1\n");
  write("s.csv", "case,lean,status\n1,10,ok\n2,20,ok\n3,30,ok\n");
  EXPECT_EQ(refusal("plot uneven.csv --columns a --psd"),
            "--psd: the rows of uneven.csv are not at equal steps of time: 3 s follows 1 s\n");
  EXPECT_EQ(refusal("plot s.csv --columns lean --psd"), "--psd: s.csv is no series over time\n");
  EXPECT_EQ(refusal("plot a.csv --columns a --psd --segment 5"),
            "--segment: must be from 0.02 to 4 s, the steps and the length of a.csv, found 5\n");
  EXPECT_EQ(refusal("plot a.csv --columns a --segment 1"), "--segment: goes with --psd\n");
  EXPECT_EQ(refusal("plot a.csv --columns a --weight z"),
            "--weight: there is no weighting \"z\"; there are: k, d, c, e, j, f\n");
  EXPECT_EQ(refusal("plot a.csv --columns x --weight k"), "--weight: x of a.csv is no acceleration, its unit is m\n");
  EXPECT_EQ(refusal("plot slow.csv --columns a --weight k"),
            "--weight k: slow.csv has 1 rows in a second, the weighting needs 50\n");
  EXPECT_EQ(refusal("plot a.csv --columns a --psd --over x"), "--over: --psd is of a series over time\n");
  EXPECT_EQ(refusal("plot a.csv --columns a --psd --where 't > 1'"), "--where: --psd needs all rows\n");
}

}  // namespace
}  // namespace mbgen::cli_test
