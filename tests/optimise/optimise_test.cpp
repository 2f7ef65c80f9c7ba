// mbgen optimise: designs that are closed forms, and the words of its results.

#include "tests/optimise/optimise_support.hpp"

namespace mbgen::cli_test {
namespace {

const std::string kForm = "optimise forms.json --free p=-3:3,q=-3:3 --json ";

TEST_F(Optimise, ABowlCutByALineIsMetWhereTheLineTouchesIt) {
  // Nearest point of p + q = 2 to (2, 1); the goal there is (3 - s)^2 / 2 of a line p + q = s: its slope is s - 3.
  for (const char* method : {"slsqp", "mma"}) {
    const Json result = json_of(kForm + "--goal min:start:bowl:1 --constraint '2000 mm>=start:sum' --method " + method);
    EXPECT_EQ(result["status"], "ok") << method;
    EXPECT_NEAR(value_of(result, "p"), 1.5, 1e-5) << method;
    EXPECT_NEAR(value_of(result, "q"), 0.5, 1e-5) << method;
    const Json line = result["constraints"][0];
    EXPECT_EQ(line["limit"], 2.0);
    EXPECT_TRUE(line["active"]);
    EXPECT_NEAR(line["goal_per_unit"].get<double>(), -1, 1e-5) << method;
  }
  const Json equal = json_of(kForm + "--goal min:start:bowl:1 --constraint start:sum==4");
  EXPECT_NEAR(value_of(equal, "p"), 2.5, 1e-7);
  EXPECT_NEAR(value_of(equal, "q"), 1.5, 1e-7);
  EXPECT_NEAR(equal["constraints"][0]["goal_per_unit"].get<double>(), 1, 1e-6);
}

TEST_F(Optimise, ABoundTellsWhatItCosts) {
  // (p - 2)^2 at p = 1.5 falls by 1 per unit.
  const Json result = json_of("optimise forms.json --free p=0:1.5,q=-3:3 --goal min:start:bowl:1 --json");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_EQ(value_of(result, "p"), 1.5);
  EXPECT_NEAR(value_of(result, "q"), 1, 1e-7);
  const Json p = entry(result, "variables", "p");
  EXPECT_EQ(p["at_bound"], "upper");
  EXPECT_NEAR(p["goal_per_unit"].get<double>(), -1, 1e-6);
  EXPECT_EQ(entry(result, "variables", "q")["at_bound"], "");
}

TEST_F(Optimise, GoalsAreWeighedByTheirScales) {
  // near / a + far / b is least at p = (1/b) / (1/a + 1/b), q = 0.
  const Json result = json_of(kForm + "--goal a=min:start:near:2,b=min:start:far:6");
  EXPECT_NEAR(value_of(result, "p"), 0.25, 1e-7);
  EXPECT_NEAR(value_of(result, "q"), 0, 1e-7);
  EXPECT_NEAR(result["sum"].get<double>(), 0.0625 / 2 + 0.5625 / 6, 1e-9);
}

TEST_F(Optimise, WhatIsFoundDoesNotDependOnScales) {
  for (const char* scale : {"1e-6", "1e6"}) {
    const Json result = json_of(kForm + "--constraint 'start:sum<=2' --goal min:start:bowl:" + scale);
    EXPECT_EQ(result["status"], "ok") << scale;
    EXPECT_NEAR(value_of(result, "p"), 1.5, 1e-6) << scale;
    EXPECT_NEAR(value_of(result, "q"), 0.5, 1e-6) << scale;
  }
}

TEST_F(Optimise, AVariableThatMovesNothingIsNamed) {
  const Json result = json_of("optimise damped.json --free stiffness,damping --goal min:start:x --json");
  ASSERT_GE(result["warnings"].size(), 2u);
  EXPECT_EQ(result["warnings"][0], "stiffness: no goal and no constraint depends on it at the start");
  EXPECT_EQ(result["warnings"][1], "damping: no goal and no constraint depends on it at the start");
  EXPECT_EQ(result["status"], "doubted, see the warnings");
}

TEST_F(Optimise, ALimitFarBelowTheStartIsNotKeptByItsDistance) {
  // near + 0.1 <= 0.1 - 1e-4 is out of reach by 1e-4, a millionth of the start's 100.
  write("far.json", R"({ "mbgen": 1, "name": "far_start", "include": ["forms.json"],
    "outputs": { "lifted": { "unit": "m^2", "expression": "p*p + 0.1" } } })");
  const Outcome run = mbgen(
      "optimise far.json --free p=-20:10:20 --goal min:start:near --constraint "
      "'start:lifted<=0.0999'");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("start:lifted<=0.0999 is broken by 0.0001"), std::string::npos) << run.out;
}

TEST_F(Optimise, PointsOfATradeOffThatAreNotConvergedSaySo) {
  const Json result = json_of(kForm +
                              "--goal near=min:start:near,far=min:start:far --trade-off near,far --points 3 "
                              "--evaluations 2");
  int doubted = 0;
  for (const Json& point : result["trade_off"]["points"]) doubted += point["status"] != "ok";
  EXPECT_GT(doubted, 0);
}

TEST_F(Optimise, ATradeOffIsThatOfTwoPoints) {
  // Squares of the distances from two points 1 apart: on the line between them their roots add up to 1.
  const Json result =
      json_of(kForm +
              "--goal near=min:start:near,far=min:start:far --trade-off near,far --points 5 -o front.csv "
              "--report front.html");
  const Json& points = result["trade_off"]["points"];
  ASSERT_EQ(points.size(), 5u);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(points[k]["status"], "ok") << k;
    const double near = points[k]["goals"][0]["value"], far = points[k]["goals"][1]["value"];
    EXPECT_NEAR(far, 1 - 0.25 * static_cast<double>(k), 1e-6) << k;
    EXPECT_NEAR(std::sqrt(near) + std::sqrt(far), 1, 1e-6) << k;
  }
  const std::string front = read("front.csv");
  EXPECT_TRUE(front.starts_with("point,near [m^2],far [m^2],p [m],q [m],status\n1,")) << front;
  EXPECT_EQ(std::count(front.begin(), front.end(), '\n'), 6);
  EXPECT_NE(read("front.html").find("<svg"), std::string::npos);
}

TEST_F(Optimise, AResonanceComesBetweenItsLimits) {
  // As stiff as 1.4 Hz allows: stiffness / mass = (2.8 pi)^2; as soft as 1.1 Hz allows: (2.2 pi)^2.
  const double pi = std::acos(-1.0);
  write("tuned.json", R"({ "mbgen": 1, "name": "tuned", "include": ["damped.json"],
    "outputs": { "k": { "unit": "N/m", "expression": "stiffness" } } })");
  const Json stiff = json_of(
      "optimise tuned.json --set damping=0 --free stiffness=10:1000 --goal max:start:k --json "
      "--constraint '1.1<=mode:1:frequency<=1.4'");
  EXPECT_NEAR(value_of(stiff, "stiffness"), 2 * std::pow(2.8 * pi, 2), 1e-3);
  EXPECT_TRUE(entry(stiff, "constraints", "mode:1:frequency<=1.4")["active"]);
  EXPECT_FALSE(entry(stiff, "constraints", "mode:1:frequency>=1.1")["active"]);
  const Json damped = json_of(
      "optimise damped.json --free damping --goal min:mode:1:damping~0.25 --constraint 'mode:1:frequency<=10 Hz' "
      "--json");
  EXPECT_NEAR(value_of(damped, "damping"), 2 * 0.25 * std::sqrt(2.0 * 50), 1e-6);
}

TEST_F(Optimise, TheLeastSquareOfASwingIsAtHalfOfTheCriticalDamping) {
  // Of x from rest at x0 the integral of x^2 is x0^2 (4 d^2 + 1) / (4 d w): least at d = 1/2, damping = sqrt(k m).
  const Json result = json_of("optimise damped.json --free damping=1:30 --goal 'min:mean(x*x)' -o best.json --json");
  EXPECT_EQ(result["derivatives"], "exact");
  EXPECT_EQ(result["status"], "ok");
  // The sum of trapezoids differs from the integral by the cube of the step: 1e-6 of it.
  EXPECT_NEAR(value_of(result, "damping"), std::sqrt(50.0 * 2), 1e-3);
  EXPECT_NEAR(result["goals"][0]["value"].get<double>(), 0.01 * 2 / (4 * 0.5 * 5) / 8, 1e-7);
  // By differences the same design, which is a model of its own.
  const Json again = json_of("optimise damped.json --free damping=1:30 --goal 'min:mean(x*x)' --engine generic --json");
  EXPECT_EQ(again["derivatives"], "central differences");
  EXPECT_NEAR(value_of(again, "damping"), value_of(result, "damping"), 1e-5);
  EXPECT_EQ(json_of("simulate best.json --engine generic --out m.csv --json")["status"], "ok");
}

TEST_F(Optimise, AVariableThatNoSolverCanTuneIsSearchedToo) {
  // From rest on an incline the block swings to twice its equilibrium, 2 m g sin / k: sin = 0.1 k / (m g).
  std::string text = kDamped;
  const auto change = [&](const std::string& old, const std::string& now) {
    text.replace(text.find(old), old.size(), now);
  };
  change(R"("gravity": [0, 0, 0])", R"("gravity": [0, 0, -9.81])");
  change(R"("parameters": {)", R"("parameters": { "tilt": 0.2,)");
  change(R"("axis": "x")", R"("axis": [1, 0, "tilt"])");
  write("incline.json", text);
  const Outcome run = mbgen(
      "optimise incline.json --set damping=0 --set start=0 --free tilt=-1:1 --goal 'min:min(x)~-0.2' --duration 2 "
      "--json"
      " --step 2e-3");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.starts_with("optimise: the model is analysed anew for each value: incline.json:")) << run.err;
  const double sine = 0.1 * 50 / (2 * 9.81);
  // The lowest of the points lies at most (5 * 1e-3)^2 / 4 of the swing above it.
  EXPECT_NEAR(value_of(Json::parse(run.out), "tilt"), sine / std::sqrt(1 - sine * sine), 5e-6);
}

TEST_F(Optimise, TheDesignThatMadeAToeCurveIsFound) {
  write("axle.json", fmt::format(R"({{ "mbgen": 1, "name": "wanted_axle",
    "include": [{{ "file": "{}/models/axles/double_wishbone.json", "replace": {{ "/hardpoints/rack/2": "rack_z" }} }}],
    "parameters": {{ "rack_z": {{ "value": 0.3, "unit": "m" }} }} }})",
                                 kSource));
  ASSERT_EQ(mbgen("kc axle.json --set rack_z=0.265 --points 11 -o rig").exit_code, 0);
  const Table curve = table("rig/front_parallel_travel.csv");
  std::string target = "travel [mm],toe [deg]\n";
  for (const std::vector<double>& row : curve.rows)
    target += fmt::format("{},{}\n", 1000 * row[0], row[1] * 180 / std::acos(-1.0));
  write("target.csv", target);
  const Json result = json_of(
      "optimise axle.json --free rack_z=0.2:0.3 --goal 'min:kc:front:toe~target.csv' --report page.html --json");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_NEAR(value_of(result, "rack_z"), 0.265, 1e-7);
  EXPECT_LT(result["goals"][0]["value"].get<double>(), 1e-8);
  ASSERT_EQ(result["curves"].size(), 1u);
  EXPECT_EQ(result["curves"][0]["name"], "kc:front:parallel_travel:toe");
  EXPECT_NEAR(result["curves"][0]["target"][0].get<double>(), curve.rows[0][1], 1e-12);
  const std::string page = read("page.html");
  for (const char* word : {"before", "after", "target", "Course of the search"})
    EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST_F(Optimise, ANumberOfAManoeuvreIsReached) {
  std::ifstream file(kSource + "/tests/data/models/four_wheeler.json");
  std::stringstream text;
  text << file.rdbuf();
  std::string car = text.str();
  const auto change = [&](const std::string& old, const std::string& now) {
    ASSERT_NE(car.find(old), std::string::npos) << old;
    car.replace(car.find(old), old.size(), now);
  };
  change(R"("parameters": {)", R"("parameters": { "load": { "value": 1200, "unit": "kg" },)");
  change(R"("car": { "mass": 1200)", R"("car": { "mass": "load")");
  write("car.json", car);
  write("step.json", R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 15, "steer": 0.01, "at": 0.2,
    "duration": 2.5, "step": 5e-3, "driver": { "understeer": 0.001 } })");
  ASSERT_EQ(mbgen("simulate car.json --manoeuvre step.json --set load=1350 --engine generic --out m.csv").exit_code, 0);
  double wanted = 0;
  const Json run = Json::parse(read("m.csv.run.json"));
  for (const Json& metric : run["metrics"])
    if (metric["name"] == "yaw_rate_gain") wanted = metric["value"];
  const std::string words = "optimise car.json --free load=1000:1500 --manoeuvre step.json --engine generic ";
  const Json result = json_of(words + fmt::format("--goal min:yaw_rate_gain~{} --json", wanted));
  EXPECT_NEAR(value_of(result, "load"), 1350, 0.01);
  EXPECT_EQ(result["goals"][0]["unit"], "1/s");
  const Outcome wrong = mbgen(words + "--goal min:yaw_rate_gan");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("the manoeuvre gives no number \"yaw_rate_gan\"\n  hint: did you mean \"yaw_rate_gain\"?"),
            std::string::npos)
      << wrong.err;
}

TEST_F(Optimise, AGlobalSearchLeavesTheNearestValley) {
  // (p^2 - 1)^2 + 0.2 p has its lower valley at p < -1, where 4 p (p^2 - 1) = -0.2; the start is in the other one.
  const Json local = json_of("optimise forms.json --free p=-3:0.9:3,q --goal min:start:valleys:1 --json");
  EXPECT_GT(value_of(local, "p"), 0.9);
  const Json best = json_of("optimise forms.json --free p=-3:0.9:3,q --goal min:start:valleys:1 --global 5 --json");
  const double p = value_of(best, "p");
  EXPECT_LT(p, -1);
  EXPECT_NEAR(4 * p * (p * p - 1), -0.2, 1e-5);
  EXPECT_EQ(best["starts"].size(), 5u);
}

TEST_F(Optimise, AKilledSearchGoesOnToTheSameResult) {
  const std::string words =
      "optimise forms.json --free p=-3:3,q=-3:3 --goal min:start:valleys,min:start:near --constraint 'start:sum>=0.3' ";
  const Outcome whole = mbgen(words + "-o whole.json");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const std::string journal = read("whole.json.journal");
  for (const std::size_t cut : {journal.find('\n') + 1, journal.size() / 2, journal.size()}) {
    write("half.json.journal", journal.substr(0, cut));
    const Outcome rest = mbgen(words + "-o half.json --jobs 1");
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole.out);
    EXPECT_EQ(read("half.json"), read("whole.json"));
    EXPECT_EQ(read("half.json.journal"), journal);
  }
  const Outcome other = mbgen(words + "--global 2 -o whole.json");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("whole.json.journal: belongs to another run of mbgen optimise"), std::string::npos)
      << other.err;
}

TEST_F(Optimise, DesignsWithoutAResultAreRefusedAndNamed) {
  // The root is real from p = 0.2 on, where its slope is infinite: it is least there, and no step beyond is taken.
  const Outcome run = mbgen("optimise forms.json --free p=-3:3 --goal min:start:root:1 --evaluations 60");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("  refused: p = "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(": start: start:root is nan\n"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("  ok: "), std::string::npos) << run.out;
}

TEST_F(Optimise, ADesignBesideOnesWithoutAResultIsTaken) {
  // The edge itself has a result, and derivatives to one side.
  const Json result = json_of("optimise forms.json --json --free p=-3:3 --goal min:start:verge:1");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_NEAR(value_of(result, "p"), 0, 1e-6);
}

TEST_F(Optimise, ADesignThatBreaksAConstraintIsNeverOk) {
  const Outcome run =
      mbgen("optimise forms.json --free p=-3:3,q=-3:3 --goal min:start:bowl --constraint 'start:sum<=-7' -o none.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("  start:sum<=-7 is broken by 1: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("BROKEN"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("optimise: no design was found that keeps all constraints: start:sum<=-7 is broken by 1\n  "
                         "none.json is not written\n"),
            std::string::npos)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("none.json")));
}

TEST_F(Optimise, MistakesHaveTheirMessages) {
  const std::string words = "optimise forms.json --free p=-3:3 ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--goal start:near", "--goal \"start:near\": must be [NAME=]min:MEASURE[:SCALE]"},
      {"--goal min:start:nea",
       "--goal \"start:nea\": the model has no output \"nea\"\n  hint: did you mean \"near\"?\n"},
      {"--goal min:near", "--goal \"near\":1:1: \"near\" changes along the motion, a metric is one number\n"},
      {"--goal max:start:near~3", "--goal \"max:start:near~3\": a target is approached by min:\n"},
      {"--goal min:start:near~abc",
       "--goal \"start:near\": must be a number, with a unit where needed, or a table (CSV)"},
      {"--goal 'min:start:near~3 N'", "--goal start:near: is in \"m^2\", found \"N\"\n"},
      {"--goal 'min:mode:1:frequency~1000 mHz'", "--goal \"mode:1:frequency\": unknown unit \"mHz\": write a number"},
      {"--goal 'min:max(near)~3 m'", "--goal max(near): a metric has the units of its outputs: leave out \"m\"\n"},
      {"--goal min:start:near:-2", "--goal \"min:start:near:-2\": the scale must be above 0, found -2\n"},
      {"--goal min:start:near,max:start:near", "--goal: \"start:near\" stands twice"},
      {"--goal min:kc:front:toe~a.csv", "--goal \"kc:front:toe\": the model has no axle \"front\"\n"},
      {"--goal min:mode:0:damping", "--goal \"mode:0:damping\": modes are numbered from 1, found 0\n"},
      {"--goal min:mode:1:mass", "--goal \"mode:1:mass\": must be start:OUTPUT, mode:K:frequency"},
      {"--goal min:step:x", "--goal \"step:x\": must be start:OUTPUT, mode:K:frequency"},
      {"--goal min:start:near --constraint start:far", "--constraint \"start:far\": must be MEASURE<=LIMIT"},
      {"--goal min:start:near --constraint '1>=start:far>=0'", "--constraint \"1>=start:far>=0\": must be MEASURE<="},
      {"--goal min:start:near --trade-off near,far", "--trade-off: no goal is called \"near\"\n"},
      {"--goal a=min:start:near --trade-off a", "--trade-off: must be GOAL,GOAL, two names of --goal, found \"a\"\n"},
      {"--goal a=min:start:near,b=min:start:far,c=min:start:sum --trade-off a,b",
       "--trade-off: is of two goals, found 3: write the others as --constraint\n"},
      {"--goal min:start:near --constraint '0.9<=start:sum<=0.8'",
       "--constraint: start:sum>=0.9 and start:sum<=0.8 leave no value\n"},
      {"--goal min:start:near -o n.json --report ./n.json", "./n.json: --out and --report must be two files\n"},
      {"--goal min:start:near --method mma --constraint start:far==1", "--method mma: takes no equalities"},
      {"--goal min:start:near --free pp", "--free: the model has no parameter \"pp\"\n"},
      {"--goal min:start:near -o forms.json", "forms.json: cannot write: it is read by this command\n"},
      {"--goal min:start:root --set q=1 --free q", "--set q: --free finds the value of \"q\"\n"},
      {"--goal min:start:root --free p=-1:0:0.1", "--free: \"p\" stands twice\n"},
  };
  for (const auto& [options, message] : cases) {
    const Outcome run = mbgen(words + options);
    EXPECT_EQ(run.exit_code, 1) << options;
    EXPECT_TRUE(run.err.starts_with(message)) << options << "\n" << run.err;
  }
  const Outcome start = mbgen("optimise forms.json --free p=-3:0.1:3 --goal min:start:root");
  EXPECT_TRUE(start.err.starts_with("optimise: no result at the start values: start: start:root is nan\n"))
      << start.err;
}

}  // namespace
}  // namespace mbgen::cli_test
