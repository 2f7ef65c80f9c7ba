// Data that a fit refuses, or takes with a word, each with file and row.

#include "tests/fit/fit_support.hpp"

namespace mbgen::cli_test {
namespace {

struct BadData {
  std::string data, options, message;
};

class RefusedData : public Fit {
 protected:
  std::string refusal(const std::string& data, const std::string& options) const {
    write("bad.csv", data);
    const Outcome run =
        mbgen("fit block.json --data bad.csv --match x:1e-3 --free stiffness --engine generic " + options);
    EXPECT_EQ(run.exit_code, 1) << data << run.out;
    return run.err;
  }
};

TEST_F(RefusedData, EachHasItsMessage) {
  const std::vector<BadData> cases = {
      {"t,x\n0,0\n0.1,one\n", "", "bad.csv:3: x: must be a number, or empty for none, found \"one\"\n"},
      {"t,x\n0,0\n0.1,1e300\n", "", "bad.csv:3: x: must be at most 1e+15 in magnitude, got 1e300\n"},
      {"t,x\n0,0\n0.1,inf\n", "", "bad.csv:3: x: must be a number, or empty for none, found \"inf\"\n"},
      {"t,x\n0,0\n0.1\n", "", "bad.csv:3: must have 2 fields like the header, found 1\n"},
      {"t,x\n0,0\n0.1,1\n\n0.1,2\n", "", "bad.csv:5: t must increase, found 0.1 after 0.1\n"},
      {"t,x\n0,0\n,1\n", "", "bad.csv:3: t has no value\n"},
      {"t [ms],x\n0,0\n100,1\n50,2\n", "", "bad.csv:4: t must increase, found 0.05 after 0.1\n"},
      {"t [m],x\n0,0\n1,1\n", "", "bad.csv:1: t is in \"s\", found \"m\"\n"},
      {"t,x [m/s]\n0,0\n1,1\n", "", "bad.csv:1: x is in \"m\", found \"m/s\"\n"},
      {"t,x [furlong]\n0,0\n1,1\n", "",
       "bad.csv:1: x is in \"m\", found \"furlong\", a unit that mbgen does not know\n"},
      {"t,x\n0,0.5\n1,0.5\n2,0.5\n", "",
       "bad.csv:2: x never moves: it is 0.5 in all 3 rows from here on\n"
       "  hint: a dead channel would pull the parameters: leave it out of --match\n"},
      {"t,x\n0,\n1,nan\n", "", "bad.csv:1: x has no value in any of its 2 rows\n"},
      {"t,y\n0,0\n1,1\n", "", "bad.csv:1: has no column of a matched output, as \"x\"\n"},
      {"t;x\n0;0\n", "",
       "bad.csv:1: fields are separated by commas, found semicolons\n"
       "  hint: write the table with commas between fields, and points in numbers\n"},
      {"t,x,x\n0,0,0\n", "", "bad.csv:1: column \"x\" stands twice\n"},
      {"t,x,force\n0,0,1\n1,1,\n", "", "bad.csv:3: force has no value, and the motion needs its inputs in every row\n"},
      {"t,x\n-1,0\n0,1\n", "",
       "bad.csv:2: t = -1 s: a motion starts at 0\n"
       "  hint: shift the times, so that 0 is the instant of the model's initial state\n"},
      {"t,x\n", "", "bad.csv: the table has no rows\n"},
      {"travel,toe\n0,0\n", "",
       "bad.csv:1: needs a column \"t\", or --match kc:AXLE:COLUMN for points of a rig's curve\n"},
  };
  for (const BadData& one : cases) EXPECT_EQ(refusal(one.data, one.options), one.message) << one.data;
}

TEST_F(RefusedData, GapsArePassedAndTold) {
  std::string text = "t,x\n";
  for (int k = 0; k <= 100; ++k) {
    if (k > 40 && k < 60) continue;
    text += fmt::format("{},{}\n", 0.02 * k,
                        k == 10   ? ""
                        : k == 20 ? "NaN"
                                  : fmt::format("{}", 0.1 * std::cos(0.06 * k)));
  }
  write("gaps.csv", text);
  const Outcome run =
      mbgen("fit block.json --data gaps.csv --match x:1e-3 --free stiffness --engine generic --step 5e-3 --json");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err,
            "gaps.csv:43: note: a pause of 0.4 s before this row, rows are 0.02 s apart elsewhere\n"
            "gaps.csv:12: note: x has no value here, nor in 1 other rows: left out\n");
  // 0.06 per 0.02 s: 3 rad/s, 18 N/m.
  EXPECT_NEAR(Json::parse(run.out)["unknowns"][0]["value"].get<double>(), 18, 1e-5);
}

TEST_F(RefusedData, OptionsHaveTheirMessages) {
  write("run.csv", block_data(4, 0.1, 0.01));
  const std::string words = "fit block.json --data run.csv --engine generic ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--match y --free mass", "--match: the model has no output \"y\"\n"},
      {"--match x:-1 --free mass", "--match x: the standard deviation must be above 0, found -1\n"},
      {"--match x,x:2 --free mass", "--match: \"x\" stands twice\n"},
      {"--match x --free masss", "--free: the model has no parameter \"masss\"\n  hint: did you mean \"mass\"?\n"},
      {"--match x --free mass=3:1", "--free mass: the lower bound 3 must be below the upper 1\n"},
      {"--match x --free mass=3:5",
       "--free mass: it starts at 2, outside of its bounds 3 to 5\n  hint: write LOW:START:HIGH\n"},
      {"--match x --free mass,mass", "--free: \"mass\" stands twice\n"},
      {"--match x --free mass --set mass=3", "--set mass: --free finds the value of \"mass\"\n"},
      {"--match x --free mass --data ./run.csv", "--data: \"./run.csv\" stands twice\n"},
      {"--match x --free mass --hold-out ./run.csv",
       "--hold-out: \"./run.csv\" is one of --data: it would test nothing\n"},
      {"--match x --free mass=1:1e16", "--free mass: must be at most 1e+15 in magnitude, got 1e16\n"},
      {"--match x --free mass --loss huber", "--loss: must be squares, huber:LIMIT or cauchy:LIMIT, found \"huber\"\n"},
      {"--match x --free mass --nuisance x:drift", "--nuisance x: \"drift\" is not among gain, bias, delay\n"},
      {"--match x --free mass --nuisance x", "--nuisance x: name the faults that are found, x:gain:bias:delay\n"},
      {"--match x --free mass --free-start z.slid=0:1",
       "--free-start: the model has no coordinate \"z.slid\"; write z.NAME or zd.NAME\n"
       "  hint: did you mean \"z.slide\"?\n"},
      {"--match x --free mass --target mode:0:frequency=1:1",
       "--target \"mode:0:frequency\": modes are numbered from 1, found 0\n"},
      {"--match x --free mass --target y=1:1", "--target \"y\":1:1: unknown name \"y\"\n"},
      {"--free mass --target mode:2:frequency=1:1 --match x",
       "fit: no result at the start values: --target: mode:2:frequency: the model has 1 oscillation\n"},
      {"--match x --free mass -o run.csv", "run.csv: cannot write: it is read by this command\n"},
      {"--match x --free mass -o f.json --report ./f.json", "./f.json: --out and --report must be two files\n"},
      {"--match x --free mass -o f.json --report f.json.journal",
       "f.json.journal: --report and the journal beside --out must be two files\n"},
  };
  for (const auto& [options, message] : cases) {
    const Outcome run = mbgen(words + options);
    EXPECT_EQ(run.exit_code, 1) << options;
    EXPECT_TRUE(run.err.starts_with(message.substr(0, message.find('\n')))) << options << "\n" << run.err;
  }
}

TEST_F(RefusedData, AStartWithoutAMotionIsTold) {
  write("run.csv", block_data(4, 0.1, 0.01));
  const Outcome run = mbgen("fit block.json --data run.csv --match x:1 --free mass=-2:-1:3 --engine generic");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("must not be negative, got -1"), std::string::npos) << run.err;
}

TEST_F(RefusedData, UnitsThatNobodyWroteAreDoubted) {
  std::string text = "t,x\n";
  for (int k = 0; k <= 200; ++k) text += fmt::format("{},{}\n", 0.02 * k, 100 * std::cos(4.9 * 0.02 * k));
  write("mm.csv", text);
  const Outcome run =
      mbgen("fit block.json --data mm.csv --match x:1e-3 --free stiffness --engine generic --step 1e-2");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.starts_with("mm.csv:1: note: x is ")) << run.err;
  EXPECT_NE(run.err.find("times the model's at the start values: are they in a thousandth of the unit, as mm?"),
            std::string::npos)
      << run.err;
}

TEST_F(RefusedData, AParameterOfAnInstanceIsToldBeforeTheWork) {
  write("two.json", R"({ "mbgen": 1, "name": "two", "instances": { "a": { "file": "block.json" } } })");
  write("run.csv", block_data(4, 0.1, 0.01));
  const Outcome run = mbgen("fit two.json --data run.csv --match a_x=x --free a_mass -o out.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.err.starts_with("out.json: cannot hold \"a_mass\", which belongs to an instance in two.json\n"))
      << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
