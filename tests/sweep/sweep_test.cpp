// mbgen sweep: what it computes, and what it says.

#include <cmath>

#include "tests/sweep/sweep_support.hpp"

namespace mbgen::cli_test {
namespace {

TEST_F(Sweep, GivesTheAmplitudesOfAnOscillator) {
  for (const char* engine : kEngines) {
    const Json study = json_of(fmt::format(
        "sweep spring.json --vary amplitude=0.05,0.2 --vary mass=0.5:0.5:2 --vary force=0,3 --duration 4 --step 1e-3 "
        "--metric 'max(x)' --metric 'min(x)' --metric 'top=max(abs(v))' --metric 'at(1, x)' --metric 'mean(t)' "
        "--metric 'initial(x) - amplitude + range(force)' --metric 'mass * stiffness' --metric 'max(zd.slide - v)' "
        "--metric 'rms(v)' --engine {0} --json --out {0}.csv",
        engine));
    ASSERT_EQ(study["cases"].size(), 16u);
    EXPECT_EQ(study["failed"], 0);
    for (const Json& one : study["cases"]) {
      const double amplitude = one["values"][0], mass = one["values"][1], force = one["values"][2];
      const double omega = std::sqrt(50 / mass), centre = force / 50, swing = std::abs(amplitude - centre);
      const auto metric = [&](int k) { return one["metrics"][k].get<double>(); };
      EXPECT_NEAR(metric(0), centre + swing, 1e-5);  // the largest of the points, which are a step apart
      EXPECT_NEAR(metric(1), centre - swing, 1e-5);
      EXPECT_NEAR(metric(2), swing * omega, 1e-4);
      EXPECT_NEAR(metric(3), centre + (amplitude - centre) * std::cos(omega), 1e-8);
      EXPECT_NEAR(metric(4), 2, 1e-12);
      EXPECT_NEAR(metric(5), 0, 1e-15);
      EXPECT_EQ(metric(6), mass * 50);
      EXPECT_EQ(metric(7), 0);
      const double mean_square = 0.5 - std::sin(2 * omega * 4) / (4 * omega * 4);
      EXPECT_NEAR(metric(8), swing * omega * std::sqrt(mean_square), 1e-5);
    }
  }
}

TEST_F(Sweep, AgreesWithSimulatingCaseByCase) {
  mbgen(
      "sweep spring.json --vary mass=1,2 --vary force=0:2:4 --metric 'final(x)' --metric 'max(v)' --duration 2 "
      "--step 1e-2 --out sweep.csv");
  std::istringstream table(read("sweep.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "case,mass [kg],force [N],final(x),max(v),status");
  for (const double mass : {1, 2}) {
    std::string text = kSpring;
    const std::string old = R"("mass": { "value": 2)";
    text.replace(text.find(old), old.size(), fmt::format(R"("mass": {{ "tunable": true, "value": {})", mass));
    write("one.json", text);
    for (const double force : {0, 2, 4}) {
      mbgen(fmt::format("simulate one.json --input force={} --duration 2 --step 1e-2 --every 1 --out one.csv", force));
      const Table motion = this->table("one.csv");
      double fastest = motion.at(0, "v [m/s]");
      for (const auto& row : motion.rows) fastest = std::max(fastest, row[motion.column("v [m/s]")]);
      ASSERT_TRUE(std::getline(table, line));
      std::vector<std::string> fields;
      std::string field;
      for (std::istringstream row(line); std::getline(row, field, ',');) fields.push_back(field);
      ASSERT_EQ(fields.size(), 6u) << line;
      EXPECT_EQ(std::stod(fields[1]), mass);
      EXPECT_EQ(std::stod(fields[2]), force);
      EXPECT_NEAR(std::stod(fields[3]), motion.last("x [m]"), 1e-14);
      EXPECT_NEAR(std::stod(fields[4]), fastest, 1e-14);
      EXPECT_EQ(fields[5], "ok");
    }
  }
}

TEST_F(Sweep, AFailedCaseIsARow) {
  const Outcome run = mbgen(
      "sweep spring.json --vary mass=1,-1 --vary tilt=0 --metric 'final(t)' --duration 1 --step 0.01 --out sweep.csv");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err,
            "sweep: each case is analysed anew: spring.json:7:97: must be constant, depends on tunable parameter "
            "\"tilt\"\n");
  const std::string table = read("sweep.csv");
  EXPECT_NE(table.find("\n1,1,0,1,ok\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\n2,-1,0,,"), std::string::npos) << table;
  EXPECT_NE(table.find("must not be negative, got -1"), std::string::npos) << table;
  EXPECT_NE(run.out.find("spring: 2 cases, 1 failed, engine generic; table in sweep.csv\n"), std::string::npos);
  const Outcome infinite = mbgen("sweep spring.json --vary mass=1 --metric 'max(x) / (mass - 1)' --out infinite.csv");
  EXPECT_NE(infinite.out.find("metric max(x) / (mass - 1) is inf"), std::string::npos) << infinite.out;
}

TEST_F(Sweep, RangesHoldTheDecimalsThatTheyMean) {
  const Json study = json_of(
      "sweep spring.json --vary force=-0.3:0.1:0.35 --vary mass=3:-1:1,0.5,1e3:1e3:2e3 --metric 'final(t)' "
      "--duration 0.1 --step 0.1 --engine generic --json --out sweep.csv");
  std::vector<double> forces, masses;
  for (const Json& one : study["cases"]) {
    if (one["values"][1] == 3) forces.push_back(one["values"][0]);
    if (one["values"][0] == 0) masses.push_back(one["values"][1]);
  }
  EXPECT_EQ(forces, (std::vector<double>{-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3}));
  EXPECT_EQ(masses, (std::vector<double>{3, 2, 1, 0.5, 1000, 2000}));
}

struct BadWords {
  const char *words, *message;
};

TEST_F(Sweep, SaysWhatIsWrong) {
  const std::string rest = " --duration 1 --engine generic --out sweep.csv";
  const BadWords kBad[] = {
      {"--vary mas=1 --metric 'final(x)'",
       "--vary \"mas=1\": the model has no parameter or input \"mas\"; did you mean \"mass\"?\n"},
      {"--vary mass --metric 'final(x)'", "--vary \"mass\": must be name=first:step:last or name=value,value\n"},
      {"--vary mass=1:2 --metric 'final(x)'", "--vary \"mass=1:2\": a range is written first:step:last\n"},
      {"--vary mass=1:-1:2 --metric 'final(x)'",
       "--vary \"mass=1:-1:2\": a range from 1 by steps of -1 does not come to 2\n"},
      {"--vary mass=1:0:2 --metric 'final(x)'", "--vary \"mass=1:0:2\": the step of a range cannot be 0\n"},
      {"--vary mass=1:1e-9:2 --metric 'final(x)'",
       "--vary \"mass=1:1e-9:2\": the range has more than 10 million values\n"},
      {"--vary mass=1:1e-4:2 --vary force=0:1:9999 --metric 'final(x)'",
       "--vary \"force=0:1:9999\": the grid has more than 10 million cases\n"},
      {"--vary mass=1,x --metric 'final(x)'", "--vary \"mass=1,x\": \"x\" is not a finite number\n"},
      {"--vary mass=1 --vary mass=2 --metric 'final(x)'", "--vary \"mass=2\": \"mass\" is varied twice\n"},
      {"--vary force=1 --input force=2 --metric 'final(x)'", "--input force: --vary gives \"force\" its values\n"},
      {"--vary mass=1 --metric 'at(2, x)'", "--metric: at(2, ...) is not in the motion, which lasts 1 s\n"},
      {"--vary mass=1 --metric 'final(x)' --jobs -1", "--jobs: must be from 1 to 1024, found -1\n"},
      {"--vary mass=1 --metric 'mass=final(x)'",
       "--metric: the table has another column \"mass\", which is varied\n"
       "  hint: give the metric another name, NAME=EXPRESSION\n"},
      {"--vary mass=1 --metric 'status=final(x)'",
       "--metric: the table has another column \"status\"\n"
       "  hint: give the metric another name, NAME=EXPRESSION\n"},
      {"--vary mass=1 --metric 'final(x)' --slurm ./sweep.csv", "./sweep.csv: --out and --slurm must be two files\n"},
      {"--vary mass=1 --metric 'final(x)' --slurm sweep.csv.journal",
       "sweep.csv.journal: the journal beside --out and --slurm must be two files\n"},
      {"--vary mass=1,2 --metric 'final(x)' --keep . --slurm case_2.csv",
       "case_2.csv: --slurm and a motion of --keep must be two files\n"},
      {"--vary mass=1 --metric 'final(x)' --part 3/2", "--part: must be K/N with K from 1 to N, found 3/2\n"},
  };
  for (const BadWords& bad : kBad) {
    const Outcome run = mbgen("sweep spring.json " + (bad.words + rest));
    EXPECT_EQ(run.exit_code, 1) << bad.words;
    EXPECT_EQ(run.err, bad.message);
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(leftovers(), std::vector<std::string>{"spring.json"});
  const Outcome constant =
      mbgen("sweep spring.json --vary tilt=0,1 --metric 'final(x)' --engine generated --out sweep.csv");
  EXPECT_EQ(constant.exit_code, 1);
  EXPECT_EQ(constant.err,
            "--engine generated: one solver cannot serve all cases: spring.json:7:97: must be constant, depends on "
            "tunable parameter \"tilt\"\n  hint: leave out --engine, cases are then analysed one by one and run on the "
            "generic engine\n");
  const Outcome device = mbgen("sweep spring.json --vary mass=1 --metric 'final(x)' --out /dev/null");
  EXPECT_EQ(device.err, "/dev/null: cannot write: a study keeps a journal beside its table, name a file\n");
}

TEST_F(Sweep, SaysWhatIsWrongWithAMetric) {
  const BadWords kBad[] = {
      {"max(abs(y))", "unknown name \"y\" in expression"},
      {"maxi(x)", "unknown function \"maxi\""},
      {"mean(x, v)", "mean takes 1 argument, got 2"},
      {"at(x, 1)", "at takes a number first, at(1.5, x)"},
      {"2 * x", "\"x\" changes along the motion, a metric is one number"},
      {"max(x) + z.slide", "\"z.slide\" changes along the motion, a metric is one number"},
      {"2x=max(x)", "invalid name \"2x\""},
      {"max(x", "')' is missing for the '(' at column 4 of the expression"},
      {"final(z.slid)", "unknown coordinate \"slid\""},
  };
  for (const BadWords& bad : kBad) {
    const Outcome run =
        mbgen(fmt::format("sweep spring.json --vary mass=1 --metric 'final(x)' --metric '{}' --out a.csv", bad.words));
    EXPECT_EQ(run.exit_code, 1) << bad.words;
    EXPECT_TRUE(run.err.starts_with("--metric:2:")) << run.err;
    EXPECT_NE(run.err.find(bad.message), std::string::npos) << run.err;
  }
  const Outcome near = mbgen("sweep spring.json --vary mass=1 --metric 'max(stifness)' --out a.csv");
  EXPECT_EQ(near.err,
            "--metric:1:5: unknown name \"stifness\" in expression\n  max(stifness)\n      ^~~~~~~~\n"
            "  hint: did you mean \"stiffness\"?\n");
  const Outcome twice = mbgen("sweep spring.json --vary mass=1 --metric 'max(x)' --metric 'max(x)' --out a.csv");
  EXPECT_EQ(twice.err, "--metric:2:1: metric \"max(x)\" is there twice\n  max(x)\n  ^~~\n");
}

}  // namespace
}  // namespace mbgen::cli_test
