// mbgen fit: the values that it finds, and how certain it says they are.

#include "tests/fit/fit_support.hpp"

namespace mbgen::cli_test {
namespace {

/// Unknowns of a result by their names.
double value_of(const Json& result, const std::string& name, const char* field = "value") {
  for (const Json& unknown : result["unknowns"])
    if (unknown["name"] == name) return unknown[field].is_null() ? NAN : unknown[field].get<double>();
  ADD_FAILURE() << "no unknown " << name;
  return NAN;
}

void expect_reference(const Json& result, const Json& reference) {
  const std::vector<std::string> order = reference["optimum_order"];
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double optimum = reference["optimum"][order[i]], deviation = reference["standard_deviations"][i];
    EXPECT_NEAR(value_of(result, order[i]), optimum, 1e-6 * optimum) << order[i];
    EXPECT_NEAR(value_of(result, order[i], "standard_error"), deviation, 1e-4 * deviation) << order[i];
    for (std::size_t j = 0; j < order.size(); ++j) {
      const double covariance = reference["covariance"][i][j], correlation = reference["correlation"][i][j];
      const double scale = deviation * reference["standard_deviations"][j].get<double>();
      EXPECT_NEAR(result["covariance"][i][j].get<double>(), covariance, 1e-4 * scale) << order[i] << " " << order[j];
      EXPECT_NEAR(result["correlation"][i][j].get<double>(), correlation, 1e-4) << order[i] << " " << order[j];
    }
  }
  const double squares = reference["sum_of_squares_weighted"];
  EXPECT_NEAR(result["sum_of_squares"].get<double>(), squares, 1e-6 * squares);
  EXPECT_EQ(result["values"], reference["residuals"]);
  EXPECT_TRUE(result["converged"]);
}

TEST_F(Fit, MeetsTheOptimumOfTheQuarterVehicleFromBothSides) {
  const Json reference = quarter_vehicle();
  // The model starts 31 % below and 56 %, 37 %, 23 % above the true values; the other start is 40 % off on other sides.
  expect_reference(json_of("fit " + kVehicle + "--free k,c,kt,ms --json"), reference);
  expect_reference(
      json_of("fit " + kVehicle + "--free k=1e4:44800:1e5,c=100:960:1e4,kt=5e4:114000:1e6,ms=50:186:1000 --json"),
      reference);
}

TEST_F(Fit, NamesThePairThatTheDataCannotTell) {
  const Json reference = quarter_vehicle();
  const Json result = json_of(
      "fit " + kVehicle + "--set c=1600 --set kt=190000 --set ms=310 --free k,L0=0.6:0.9,pre=-2000:500:2000 --json");
  ASSERT_EQ(result["not_identified"].size(), 1u);
  const std::string words = result["not_identified"][0]["words"];
  EXPECT_TRUE(words.starts_with("L0 and pre only as pre - k L0, with k = 3")) << words;
  const Json& direction = result["not_identified"][0]["direction"];
  const double k = value_of(result, "k");
  EXPECT_NEAR(direction["pre"].get<double>() / direction["L0"].get<double>(), k, 1e-4 * k);
  EXPECT_TRUE(std::isnan(value_of(result, "pre", "standard_error")));
  EXPECT_TRUE(std::isnan(value_of(result, "L0", "standard_error")));
  EXPECT_NEAR(k, 32000, 5 * value_of(result, "k", "standard_error"));
  // The combination that the data do tell is the true one: pre - k L0 = -32000 * 0.725 where k is the true one.
  EXPECT_NEAR(value_of(result, "pre") - k * value_of(result, "L0"), -k * 0.725, 30);
  // The scaled information at the true values, of L0 and k by their scales there; its rank is two.
  const std::vector<double> eigenvalues = result["scaled_eigenvalues"];
  ASSERT_EQ(eigenvalues.size(), 3u);
  EXPECT_GT(eigenvalues[1], 1e5);
  EXPECT_LT(eigenvalues[2], 1e-9 * eigenvalues[0]);
}

TEST_F(Fit, FindsFaultsOfAChannelBesideTheParameters) {
  const double omega = std::sqrt(36.0 / 2);
  write("twin.csv", block_data(omega, 0.1, 0.013, 1.2, 0.03, 0.11));
  const Json result = json_of(
      "fit block.json --data twin.csv --match x:1e-3 --free stiffness=10:100 --nuisance x:gain:bias:delay --json "
      "--engine generic --step 5e-3");
  // Before the delay the block stands: the start of the data is the start of the motion held.
  EXPECT_NEAR(value_of(result, "stiffness"), 36, 1e-4);
  EXPECT_NEAR(value_of(result, "gain of x"), 1.2, 1e-5);
  EXPECT_NEAR(value_of(result, "bias of x"), 0.03, 1e-6);
  EXPECT_NEAR(value_of(result, "delay of x"), 0.11, 1e-5);
  EXPECT_LT(result["sum_of_squares"].get<double>(), 1e-2);
}

TEST_F(Fit, FitsSeveralRunsWithStartsOfTheirOwnAndTestsAnother) {
  const double omega = std::sqrt(36.0 / 2);
  write("one.csv", block_data(omega, 0.05, 0.01));
  write("two.csv", block_data(omega, -0.2, 0.02));
  write("three.csv", block_data(omega, 0.1, 0.05));
  const Json result = json_of(
      "fit block.json --data one.csv,two.csv --hold-out three.csv --match x:1e-3 --free stiffness "
      "--free-start z.slide=-1:1 --engine generic --step 5e-3 --json -o fitted.json --report fit.html");
  EXPECT_NEAR(value_of(result, "stiffness"), 36, 1e-5);
  EXPECT_NEAR(value_of(result, "z.slide of run 1"), 0.05, 1e-7);
  EXPECT_NEAR(value_of(result, "z.slide of run 2"), -0.2, 1e-7);
  const Json& held = result["channels"][2];
  EXPECT_EQ(held["file"], "three.csv");
  EXPECT_TRUE(held["held_out"]);
  EXPECT_LT(held["rms"].get<double>(), 1e-6);
  // The result is a model of its own.
  const Json moved = json_of("simulate fitted.json --engine generic --duration 1 --step 1e-3 --out m.csv --json");
  EXPECT_EQ(moved["status"], "ok");
  EXPECT_NEAR(table("m.csv").last("x [m]"), 0.1 * std::cos(omega), 1e-6);
  const std::string page = read("fit.html");
  EXPECT_NE(page.find("held out"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
}

TEST_F(Fit, EstimatesNoiseThatNobodyGave) {
  // Errors of +-0.01 in turn: their deviation is known.
  std::string text = "t [s],x [mm]\n";
  const double omega = std::sqrt(36.0 / 2);
  for (int k = 0; k <= 400; ++k)
    text += fmt::format("{},{}\n", k * 0.01, 1e3 * (0.1 * std::cos(omega * k * 0.01) + (k % 2 == 0 ? 0.01 : -0.01)));
  write("noisy.csv", text);
  const Json result =
      json_of("fit block.json --data noisy.csv --match x --free stiffness --engine generic --step 5e-3 --json");
  EXPECT_NEAR(value_of(result, "stiffness"), 36, 0.1);
  EXPECT_NEAR(result["channels"][0]["sigma"].get<double>(), 0.01, 2e-4);
  EXPECT_TRUE(result["channels"][0]["sigma_estimated"]);
  // Neighbours with opposite signs: Durbin and Watson's number is 4 (1 - 1 / n), and this is no white noise.
  EXPECT_NEAR(result["channels"][0]["durbin_watson"].get<double>(), 4, 0.1);
  EXPECT_LT(result["channels"][0]["ljung_box_p"].get<double>(), 1e-6);
}

TEST_F(Fit, AnOutlierWeighsLittleUnderARobustLoss) {
  std::string text = block_data(std::sqrt(36.0 / 2), 0.1, 0.01);
  text += "4.01,3\n4.02,3\n4.03,3\n";
  write("outliers.csv", text);
  const std::string words =
      "fit block.json --data outliers.csv --match x:1e-3 --free stiffness=25:40:60 --engine generic --step 1e-2 "
      "--json ";
  EXPECT_GT(std::abs(value_of(json_of(words), "stiffness") - 36), 0.05);
  EXPECT_NEAR(value_of(json_of(words + "--loss cauchy:1"), "stiffness"), 36, 1e-3);
}

TEST_F(Fit, InputsAreColumnsOfTheData) {
  // A force from the start moves the centre of the swing to force / stiffness.
  std::string text = "t [s],force [kN],x [m]\n";
  const double omega = std::sqrt(36.0 / 2);
  for (int k = 0; k <= 200; ++k)
    text += fmt::format("{},{},{}\n", k * 0.02, 0.0054, 0.15 + (0.1 - 0.15) * std::cos(omega * k * 0.02));
  write("pushed.csv", text);
  const Json result = json_of(
      "fit block.json --data pushed.csv --match x:1e-3 --free stiffness,mass --engine generic --step 5e-3 --json");
  EXPECT_NEAR(value_of(result, "stiffness"), 36, 1e-5);
  EXPECT_NEAR(value_of(result, "mass"), 2, 1e-6);
}

TEST_F(Fit, SaysWhichBoundStoppedIt) {
  write("run.csv", block_data(std::sqrt(36.0 / 2), 0.1, 0.01));
  const Outcome run = mbgen(
      "fit block.json --data run.csv --match x:1e-3 --free stiffness=40:60 --engine generic --step 5e-3 --jobs 1");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("at its lower bound"), std::string::npos) << run.out;
}

TEST_F(Fit, AKilledFitGoesOnToTheSameResult) {
  write("run.csv", block_data(std::sqrt(36.0 / 2), 0.1, 0.01, 1.1));
  const std::string words =
      "fit block.json --data run.csv --match x --free stiffness,mass=2:2.5 --nuisance x:gain --engine generic --step "
      "1e-2 --json ";
  const Outcome whole = mbgen(words + "-o whole.json");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const std::string journal = read("whole.json.journal");
  std::vector<std::size_t> ends;
  for (std::size_t at = journal.find('\n'); at != std::string::npos; at = journal.find('\n', at + 1))
    ends.push_back(at);
  ASSERT_GT(ends.size(), 6u);
  for (const std::size_t cut : {ends[1] + 1, ends[ends.size() / 2] + 20, journal.size()}) {
    write("half.json.journal", journal.substr(0, cut));
    const Outcome rest = mbgen(words + "-o half.json");
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole.out);
    EXPECT_NE(rest.err.find("evaluations were done before"), std::string::npos) << rest.err;
    EXPECT_EQ(read("half.json"), read("whole.json"));
    EXPECT_EQ(read("half.json.journal"), journal);
  }
  // Another fit does not take it.
  const Outcome other = mbgen(words + "--loss huber:2 -o whole.json");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("whole.json.journal: belongs to another run of mbgen fit"), std::string::npos) << other.err;
  EXPECT_EQ(mbgen(words + "--loss huber:2 --restart -o whole.json").exit_code, 0);
}

TEST_F(Fit, FindsAHardpointFromTheCurveOfARig) {
  write("axle.json", fmt::format(R"({{ "mbgen": 1, "name": "measured_axle",
    "include": [{{ "file": "{}/models/axles/double_wishbone.json", "replace": {{ "/hardpoints/rack/2": "rack_z" }} }}],
    "parameters": {{ "rack_z": {{ "value": 0.3, "unit": "m" }} }} }})",
                                 kSource));
  ASSERT_EQ(mbgen("kc axle.json --set rack_z=0.265 --points 11 -o rig").exit_code, 0);
  const Json result = json_of(
      "fit axle.json --data rig/front_parallel_travel.csv --match kc:front:toe:1e-4 --free rack_z=0.2:0.3 --json");
  EXPECT_NEAR(value_of(result, "rack_z"), 0.265, 1e-7);
  EXPECT_EQ(result["values"], 11);
}

/// Both axles have a column of this name: the files' names tell them apart.
TEST_F(Fit, TakesCurvesOfTwoAxles) {
  const std::string car = kSource + "/models/axles/coach.json";
  for (const char* axle : {"front", "rear"})
    ASSERT_EQ(mbgen(fmt::format("kc '{}' {} --points 3 -o rig", car, axle)).exit_code, 0);
  const std::string words = "fit '" + car + "' --data rig/front_parallel_travel.csv,rig/rear_parallel_travel.csv " +
                            "--free air_pressure_rear --json --match kc:front:load_left:50";
  const Json result = json_of(words + ",kc:rear:load_left:50");
  EXPECT_NEAR(value_of(result, "air_pressure_rear"), 672e3, 1);
  EXPECT_EQ(result["values"], 6);
  const Outcome unmatched = mbgen(words);
  EXPECT_EQ(unmatched.exit_code, 1);
  EXPECT_NE(unmatched.err.find("rear_parallel_travel.csv: is of the axle rear, which no --match names\n  hint: --match "
                               "kc:rear:COLUMN"),
            std::string::npos)
      << unmatched.err;
}

TEST_F(Fit, TakesSingleNumbersAndModesAsTargets) {
  // Frequency 2 Hz and a start at 0.3 m: stiffness / mass = (4 pi)^2.
  const std::string words = "fit block.json --target mode:1:frequency=2:0.01,start:x=0.3:1e-3 --json ";
  const Json result = json_of(words + "--free stiffness=10:1000,start");
  const double omega = 4 * std::acos(-1.0);
  EXPECT_NEAR(value_of(result, "stiffness"), 2 * omega * omega, 1e-4);
  EXPECT_NEAR(value_of(result, "start"), 0.3, 1e-9);
  // Errors by hand: d frequency / frequency = d stiffness / (2 stiffness).
  EXPECT_NEAR(value_of(result, "stiffness", "standard_error"), 2 * omega * omega * 2 * 0.01 / 2, 1e-2);
  EXPECT_NEAR(value_of(result, "start", "standard_error"), 1e-3, 1e-9);
  // A metric of the motion: the largest speed is start sqrt(stiffness / mass), which points 2e-3 s apart miss by at
  // most (10 * 1e-3)^2 / 2 of it.
  const Json speed = json_of(
      "fit block.json --target 'max(v)=1:0.01,start:x=0.1:1e-3' --free stiffness=10:1000,start --engine generic "
      "--step 2e-3 --json");
  EXPECT_NEAR(value_of(speed, "stiffness"), 200, 0.02);
  // Mass and stiffness only by their ratio, which is no linear combination: the direction at the result is told.
  const Json pair = json_of(words + "--free stiffness=10:1000,mass=0.1:10,start");
  ASSERT_EQ(pair["not_identified"].size(), 1u);
  const Json& direction = pair["not_identified"][0]["direction"];
  EXPECT_NEAR(direction["stiffness"].get<double>() / direction["mass"].get<double>(), omega * omega, 1e-3);
}

TEST_F(Fit, ComesToTheEdgeOfTheValuesThatHaveAResult) {
  // A damping of 1.5 is beyond the critical one, 2 sqrt(stiffness mass) = 20, where the mode oscillates no more: the
  // least sum of squares is at the edge, beside which one side alone has a result.
  write("damped.json", R"({ "mbgen": 1, "name": "damped", "include": ["block.json"],
    "parameters": { "damping": { "value": 1, "unit": "N s/m" } },
    "joint_springs": { "damper": { "joint": "slide", "damping": "damping" } } })");
  const Json result = json_of("fit damped.json --target mode:1:damping=1.5:0.01 --free damping=0.1:100 --json");
  EXPECT_NEAR(value_of(result, "damping"), 20, 1e-4);
  EXPECT_FALSE(result["converged"]);
  ASSERT_FALSE(result["warnings"].empty());
  EXPECT_NE(result["warnings"].back().get<std::string>().find("the model has 0 oscillations"), std::string::npos)
      << result["warnings"];
}

TEST_F(Fit, ASumThatFallsNoMoreIsAnEnd) {
  // x(1) = 0.1 cos(sqrt(stiffness / mass)) is never 0.2: it is nearest at the start of a period, where x has no slope.
  write("one.csv", "t [s],x [m]\n1,0.2\n");
  const Json result =
      json_of("fit block.json --data one.csv --match x:1e-3 --free stiffness=20:60:150 --engine generic --json");
  EXPECT_NEAR(value_of(result, "stiffness"), 2 * std::pow(2 * std::acos(-1.0), 2), 0.1);
  EXPECT_TRUE(result["converged"]) << result["warnings"];
}

}  // namespace
}  // namespace mbgen::cli_test
