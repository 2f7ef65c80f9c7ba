// One meaning of --set in every command, and what a command says of a model that has notes or of a run with warnings.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

/// A block on a spring: `k` is not tunable, `mass` is; the frequency is sqrt(k / mass) / 2 pi.
constexpr const char* kBlock = R"({ "mbgen": 1, "name": "block", "gravity": [0, 0, 0],
  "parameters": { "k": { "value": 100, "unit": "N/m" }, "mass": { "value": 1, "unit": "kg", "tunable": true },
                  "start": { "value": 0.1, "unit": "m" } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "block": { "mass": "mass", "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "z" } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": "k" } },
  "outputs": { "x": { "unit": "m", "expression": "z.slide" } },
  "initial": { "positions": { "slide": "start" } } })";

/// A wheel that two springs hold, on the road from the start.
constexpr const char* kWheel = R"({ "mbgen": 1, "name": "wheel",
  "bodies": { "ground": { "points": { "start": [0, 0, 0.29] } },
    "wheel": { "mass": 20, "com": [0, 0, 0.29], "inertia": [0.5, 1, 0.5], "points": { "centre": [0, 0, 0.29] } } },
  "joints": { "wheel": { "type": "free", "from": "ground.start", "to": "wheel.centre" } },
  "tyre_data": { "summer": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000,
    "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
  "tyres": { "tyre": { "centre": "wheel.centre", "axis": "y", "data": "summer", "stiffness": 2e5, "damping": 500 } },
  "initial": { "velocities": { "wheel_tx": 8, "wheel_ty": 0.2, "wheel_ry": 27 } } })";

class Set : public CommandLine {
 protected:
  Set() {
    write("as_written.json", kBlock);
    std::string other = kBlock;
    for (const auto& [from, to] : {std::pair{"\"value\": 100", "\"value\": 400"}, {"\"value\": 1,", "\"value\": 2,"}})
      other.replace(other.find(from), std::string(from).size(), to);
    write("block.json", kBlock);
    std::filesystem::create_directory(path("other"));
    write("other/block.json", other);
  }

  /// Standard output of a command on a model, with --set and as if the values stood in the file.
  void expect_same(const std::string& command, const std::string& options) const {
    const Outcome set = mbgen(command + " block.json --set k=400 --set mass=2 " + options);
    const Outcome edited = mbgen(command + " other/block.json " + options);
    EXPECT_EQ(set.exit_code, 0) << command << set.err;
    std::string expected = edited.out;
    for (std::size_t at; (at = expected.find("other/")) != std::string::npos;) expected.erase(at, 6);
    EXPECT_EQ(set.out, expected) << command;
    EXPECT_NE(set.out, mbgen(command + " block.json " + options).out) << command << ": --set did nothing";
  }
};

TEST_F(Set, MeansTheSameInEveryCommand) {
  expect_same("linearize", "--at equilibrium --json");
  expect_same("inspect", "--dump=optimised");
  expect_same("check", "--dump=program");
  expect_same("generate", "--dump=optimised");
  expect_same("sweep",
              "--vary start=0.1,0.2 --metric 'max(zd.slide)' --engine generic --duration 1 --restart --out s.csv");
  for (const char* command :
       {"check", "inspect", "explain", "linearize", "bench", "evaluate --states s.json", "equilibrium",
        "generate --out made", "export --fmi 2 --sources-only -o f.fmu", "simulate --engine generic --out o.csv",
        "sweep --vary start=0.1,0.2 --metric 'max(x)' --out s.csv"}) {
    const Outcome run = mbgen(fmt::format("{} block.json --set mas=2", command));
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_EQ(run.err, "--set: the model has no parameter \"mas\"; did you mean \"mass\"?\n") << command;
  }
}

TEST_F(Set, CheckLooksAtTheModelAsItIsSet) {
  const Outcome bad = mbgen("check block.json --set mass=-1 --json");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_EQ(Json::parse(bad.out)["problems"][0]["message"], "must not be negative, got -1");
  EXPECT_EQ(mbgen("check block.json --set mass=1e-3").exit_code, 0);
}

TEST_F(Set, OfAStudyGoesToItsJournalAndScript) {
  const std::string sweep =
      "sweep block.json --vary start=0.1,0.2 --metric 'max(zd.slide)' --engine generic --duration 1 --out s.csv";
  ASSERT_EQ(mbgen(sweep + " --set k=400").exit_code, 0);
  EXPECT_EQ(mbgen(sweep + " --set k=401").err.substr(0, 74),
            "s.csv.journal: holds cases of another study, they differ in: set\n  hint: r");
  EXPECT_EQ(mbgen(sweep + " --set start=3").err, "--set start: --vary gives \"start\" its values\n");
  ASSERT_EQ(mbgen(sweep + " --set k=400 --slurm s.sh").exit_code, 0);
  EXPECT_NE(read("s.sh").find("'--set' 'k=400'"), std::string::npos);
}

TEST_F(Set, FormOfADumpIsTheOneAskedFor) {
  write("four_bar.json", kFourBar);
  const std::string matrix = mbgen("inspect four_bar.json --dump=optimised --form matrix").out;
  EXPECT_NE(matrix, mbgen("inspect four_bar.json --dump=optimised --form recursive").out);
  EXPECT_EQ(matrix, mbgen("generate four_bar.json --dump=optimised --form matrix").out);
}

// A row of a result of other values is not silently one of the model as it is written.
TEST_F(Set, LinearizeSaysThatAResultHadOtherValues) {
  ASSERT_EQ(mbgen("simulate block.json --engine generic --duration 1 --set k=400 --out o.csv").exit_code, 0);
  EXPECT_EQ(mbgen("linearize block.json --result o.csv --row 3").err,
            "o.csv: note: is of another model, or of other values of its parameters, than block.json is now; it was "
            "simulated with --set k=400\n");
  EXPECT_EQ(mbgen("linearize block.json --result o.csv --row 3 --set k=400").err, "");
}

TEST_F(Set, TableHoldsTheSlipsThatLinearizeTakes) {
  write("wheel.json", kWheel);
  const Outcome run = mbgen("simulate wheel.json --engine generic --duration 0.05 --step 1e-3 --out o.csv");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Table motion = table("o.csv");
  EXPECT_NE(motion.at(20, "x.tyre_v [m]"), 0);
  const Outcome taken = mbgen("linearize wheel.json --result o.csv --row 21 --json");
  const std::string noted = "wheel.json: 1 note on the model, mbgen check wheel.json prints it\n";  // pure slip only
  EXPECT_EQ(taken.err, noted);
  // Without its columns they are settled, which is another point, and said.
  std::string text = read("o.csv");
  for (std::size_t at; (at = text.find("x.tyre")) != std::string::npos;) text.replace(at, 6, "other");
  write("p.csv", text);
  const Outcome settled = mbgen("linearize wheel.json --result p.csv --row 21 --json");
  EXPECT_EQ(settled.err, noted + "p.csv: note: has not all auxiliary states, columns x.*: they are taken as settled\n");
  EXPECT_NE(Json::parse(taken.out)["drift"], Json::parse(settled.out)["drift"]);
}

// 9 * 0.001 is 0.009000000000000001 in doubles: the solver has that, the table the decimal.
TEST_F(Set, TimesAreShortDecimals) {
  ASSERT_EQ(mbgen("simulate block.json --engine generic --duration 0.03 --step 1e-3 --out o.csv").exit_code, 0);
  const std::string text = read("o.csv");
  EXPECT_NE(text.find("\n0.009,"), std::string::npos) << text.substr(0, 2000);
  EXPECT_NE(text.find("\n0.018,"), std::string::npos);
  ASSERT_EQ(mbgen("simulate block.json --engine generic --duration 0.01 --step 0.0034 --out o.csv").exit_code, 0);
  EXPECT_EQ(table("o.csv").at(1, "t [s]"), 0.01 / 3) << "a step without a short decimal is printed with every digit";
}

TEST_F(Set, StatusOfARunWithWarningsIsNotOk) {
  const std::string simulate = "simulate block.json --engine generic --duration 5 --out o.csv --step ";
  const Outcome damped = mbgen(simulate + "0.05");
  EXPECT_EQ(damped.exit_code, 0) << damped.err;
  EXPECT_NE(damped.err.find("warning: the energy balance is off by "), std::string::npos) << damped.err;
  EXPECT_NE(damped.out.find("  status                    1 warning at t = 5 s\n"), std::string::npos) << damped.out;
  EXPECT_EQ(Json::parse(read("o.csv.run.json"))["status"], "1 warning");
  EXPECT_NE(mbgen(simulate + "1e-2").out.find("  status                    ok at t = 5 s\n"), std::string::npos);
  const Outcome lost = mbgen(simulate + "0.2");
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_NE(lost.out.find("  status                    energy balance off by 92 % at t = 5 s\n"), std::string::npos)
      << lost.out;
  EXPECT_NE(lost.err.find(", step 0.2 s is too long; the fastest mode at the start, 1.592 Hz ("), std::string::npos)
      << lost.err;
}

TEST_F(Set, CasesWithWarningsAreNotOk) {
  const std::string sweep =
      "sweep block.json --vary k=0.1,100,130,800 --metric 'max(abs(x))' --engine generic --duration 5 --step 0.05 "
      "--out "
      "s.csv";
  const Outcome run = mbgen(sweep);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("warning: the energy balance is off by "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\nblock: 4 cases, 1 failed, 2 with a warning, engine generic; table in s.csv\n"
                         "  the worst warning is in case 3, k = 130\n"),
            std::string::npos)
      << run.out;
  const Json again = json_of(sweep + " --json");
  EXPECT_EQ(again["warned"], 2);
  EXPECT_EQ(again["cases"][0]["status"], "ok");
  EXPECT_TRUE(again["cases"][1]["metrics"][0].is_number()) << "there are values, with a warning";
  EXPECT_GT(std::abs(again["cases"][2]["energy_error"].get<double>()), 1e-3) << "the journal keeps it";
  EXPECT_TRUE(again["cases"][3]["status"].get<std::string>().starts_with("the energy balance is off by ")) << again;
  EXPECT_TRUE(again["cases"][3]["metrics"][0].is_null()) << "a wrong number is none";
  EXPECT_NE(mbgen("plot s.csv --columns 'max(abs(x))' --over k -o s.svg").exit_code, 1);
}

TEST_F(Set, SimulateSaysHowManyNotesThereAre) {
  std::string model = kBlock;
  model.replace(model.find("[1, 1, 1]"), 9, "[1, 1, 3], \"accept_inertia\": true");
  write("noted.json", model);
  ASSERT_NE(mbgen("check noted.json").out.find("notes 1\n"), std::string::npos);
  const std::string said = "noted.json: 1 note on the model, mbgen check noted.json prints it\n";
  for (const char* command :
       {"simulate noted.json --engine generic --duration 0.1 --out o.csv", "linearize noted.json",
        "equilibrium noted.json",
        "sweep noted.json --vary k=1,2 --metric 'max(x)' --engine generic --duration 0.1 --out s.csv"}) {
    EXPECT_EQ(mbgen(command).err, said) << command;
  }
}

TEST_F(Set, CodeWithoutAStartIsNotedInTheNameOfTheModel) {
  std::string model = kBlock;
  model.replace(model.find("\"stiffness\": \"k\""), 16, "\"stiffness\": \"0*k\"");
  model.replace(model.find("[0, 0, 0],\n"), 9, "[0, 0, -9.81]");
  model.replace(model.find("\"initial\": {"), 12, "\"initial\": { \"equilibrium\": true,");
  write("falls.json", model);
  for (const char* command :
       {"check falls.json --dump=code", "inspect falls.json --dump=code", "generate falls.json --out made"}) {
    const Outcome run = mbgen(command);
    EXPECT_NE(run.err.find("falls.json: note: the solver is written without initial_state(): start from a state of "
                           "your own\n"),
              std::string::npos)
        << command << run.err;
    EXPECT_EQ(run.err.find("generate:"), std::string::npos);
  }
}

}  // namespace
}  // namespace mbgen::cli_test
