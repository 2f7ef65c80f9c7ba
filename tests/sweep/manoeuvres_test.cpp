// Studies over manoeuvres: every case is the manoeuvre that `simulate` drives, its metrics are columns.

#include <signal.h>

#include <chrono>
#include <cmath>
#include <random>
#include <set>
#include <thread>

#include "tests/sweep/sweep_support.hpp"

namespace mbgen::cli_test {
namespace {

constexpr const char* kStep = R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 15, "steer": 0.01, "at": 0.3,
  "duration": 2.5, "step": 2e-3, "driver": { "understeer": 0.001 } })";

class ManoeuvreStudy : public Sweep {
 protected:
  ManoeuvreStudy() {
    std::ifstream file(kSource + "/tests/data/models/four_wheeler.json");
    std::stringstream text;
    text << file.rdbuf();
    car_ = text.str();
    change(R"("parameters": {)", R"("parameters": { "load": { "value": 1200, "unit": "kg" },)");
    change(R"("car": { "mass": 1200)", R"("car": { "mass": "load")");
    write("car.json", car_);
    write("m.json", kStep);
  }
  void change(const std::string& old, const std::string& text) {
    ASSERT_NE(car_.find(old), std::string::npos) << old;
    car_.replace(car_.find(old), old.size(), text);
  }
  Json study(const std::string& words) const {
    return json_of("sweep car.json --manoeuvre m.json --json --out s.csv " + words);
  }
  std::string car_;
};

/// The number of a case in the column of this name.
double number(const Json& study, std::size_t index, const std::string& name) {
  const Json& columns = study["manoeuvre"]["numbers"];
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c]["name"] == name) return study["cases"][index]["manoeuvre"][c];
  ADD_FAILURE() << "no column " << name;
  return std::nan("");
}

TEST_F(ManoeuvreStudy, ACaseIsTheManoeuvreThatSimulateDrives) {
  const Json table = study(
      "--vary manoeuvre.speed=10,20 --vary load=1000,1400 --metric 'end=final(vehicle_x)' --keep kept --every 10 "
      "--engine generic");
  ASSERT_EQ(table["cases"].size(), 4u);
  EXPECT_EQ(table["varied"][0]["unit"], "m/s");
  for (std::size_t i = 0; i < 4; ++i) {
    const double speed = table["cases"][i]["values"][0], load = table["cases"][i]["values"][1];
    std::string text = kStep;
    text.replace(text.find("15"), 2, fmt::format("{}", speed));
    write("one.json", text);
    const Outcome run = mbgen(fmt::format(
        "simulate car.json --manoeuvre one.json --set load={} --engine generic --every 10 --out one.csv", load));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    Json single = Json::parse(read("one.csv.run.json"));
    ASSERT_GT(single["metrics"].size(), 8u);
    for (const Json& metric : single["metrics"])
      EXPECT_EQ(number(table, i, metric["name"]), metric["value"].get<double>()) << metric["name"];
    EXPECT_EQ(number(table, i, "largest_speed_error"), single["manoeuvre"]["largest_speed_error"].get<double>());
    EXPECT_EQ(table["cases"][i]["status"], "ok");
    // The kept motion is the table that simulate writes, and says of which run it is.
    const std::string kept = fmt::format("kept/case_{}.csv", i + 1);
    EXPECT_EQ(read(kept), read("one.csv"));
    Json run_of_case = Json::parse(read(kept + ".run.json"));
    EXPECT_EQ(run_of_case["model_hash"], single["model_hash"]);
    EXPECT_EQ(run_of_case["metrics"], single["metrics"]);
    EXPECT_EQ(run_of_case["rows"], single["rows"]);
    const Table motion = this->table("one.csv");
    EXPECT_EQ(table["cases"][i]["metrics"][0], motion.last("vehicle_x [m]"));
  }
  const Outcome drawn = mbgen("plot kept/case_1.csv kept/case_4.csv --columns vehicle_yaw_rate -o yaw.svg");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

// Linear single-track vehicle: yaw rate over steering angle is U / (l + K U^2), K = m (b / C_f - a / C_r) / l.
TEST_F(ManoeuvreStudy, TheYawGainOverSpeedIsThatOfTheSingleTrackVehicle) {
  write("m.json", R"({ "mbgen_manoeuvre": 1, "type": "step_steer", "speed": 15, "steer": 0.002, "step": 2e-3 })");
  const Json table = study("--vary manoeuvre.speed=8,20 --keep kept --every 50 --engine generic");
  const double wheelbase = 2.6, mass = 1204;
  for (std::size_t i = 0; i < 2; ++i) {
    const Table motion = this->table(fmt::format("kept/case_{}.csv", i + 1));
    const auto load = [&](const std::string& axle) {
      return motion.last("vehicle_load_" + axle + "l [N]") + motion.last("vehicle_load_" + axle + "r [N]");
    };
    // N/rad, of two wheels of the set "summer" (Pacejka, 4.E25, without camber).
    const auto stiffness = [](double both) { return 2 * 15 * 3000 * std::sin(2 * std::atan(both / 2 / (1.5 * 3000))); };
    const double front = 1.1 + 0.8 / mass, rear = wheelbase - front, u = number(table, i, "speed");
    const double understeer = mass / wheelbase * (rear / stiffness(load("f")) - front / stiffness(load("r")));
    EXPECT_NEAR(number(table, i, "yaw_rate_gain") * (wheelbase + understeer * u * u) / u, 1, 2e-3) << u;
  }
}

TEST_F(ManoeuvreStudy, OneSolverServesAllCases) {
  set("XDG_CACHE_HOME", path("cache").string());
  const std::string words = "--vary manoeuvre.speed=10,20 --vary load=1000,1400 --vary manoeuvre.steer=0.01,0.02 ";
  const Json compiled = study(words + "--engine generated"), generic = study(words + "--engine generic --restart");
  int solvers = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path("cache")))
    if (entry.path().extension() == ".so") ++solvers;
  EXPECT_EQ(solvers, 1);
  for (std::size_t i = 0; i < 8; ++i) {
    const double expected = number(generic, i, "yaw_rate_gain");
    EXPECT_NEAR(number(compiled, i, "yaw_rate_gain"), expected, 1e-7 * std::abs(expected)) << i;
  }
}

TEST_F(ManoeuvreStudy, ACaseThatFailsHasItsStatus) {
  const Json table = study(
      "--vary manoeuvre.speed=15,-1 --vary load=1200,-5 --metric 'at(2.4, vehicle_x)' "
      "--duration 0.4 --engine generic");
  const char* kStatus[] = {"at(2.4, ...) is not in the motion, which ends at 0.4 s",
                           "car.json:16:22: /bodies/car/mass: must not be negative, got -5",
                           "m.json:1:56: /speed: must be positive, got -1"};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(table["cases"][i]["status"].get<std::string>(), kStatus[i]);
  EXPECT_EQ(table["failed"], 4);
  EXPECT_EQ(read("s.csv").substr(0, 64), "case,manoeuvre.speed [m/s],load [kg],\"at(2.4, vehicle_x)\",status");
}

TEST_F(ManoeuvreStudy, NumbersThatSomeCasesLackAreEmpty) {
  // The second one is over before its metrics begin.
  const Json table = study("--vary manoeuvre.at=0.3,2.45 --engine generic");
  const Json& columns = table["manoeuvre"]["numbers"];
  ASSERT_GT(columns.size(), 3u);
  int missing = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    EXPECT_FALSE(table["cases"][0]["manoeuvre"][c].is_null()) << columns[c];
    missing += table["cases"][1]["manoeuvre"][c].is_null() ? 1 : 0;
  }
  EXPECT_GT(missing, 3);
  EXPECT_NE(read("s.csv").find(",,"), std::string::npos);
}

struct BadStudy {
  const char *words, *message;
};

TEST_F(ManoeuvreStudy, SaysWhatIsWrong) {
  const BadStudy kBad[] = {
      {"--manoeuvre m.json --vary manoeuvre.sped=1",
       "--vary \"manoeuvre.sped=1\": step_steer has no number \"sped\"; did you mean \"speed\"?\n"},
      {"--manoeuvre m.json --vary manoeuvre.driver.understear=0",
       "--vary \"manoeuvre.driver.understear=0\": driver has no number \"understear\"; did you mean \"understeer\"?\n"},
      {"--manoeuvre m.json --vary manoeuvre.side=1",
       "--vary \"manoeuvre.side=1\": step_steer has no number \"side\"\n"},
      {"--manoeuvre m.json --vary manoeuvre.step=1e-3",
       "--vary \"manoeuvre.step=1e-3\": all cases have the same step; give it with --step\n"},
      {"--manoeuvre turn.json --vary manoeuvre.events.2.steer=0",
       "--vary \"manoeuvre.events.2.steer=0\": events has no item \"2\" of 1, counted from 0\n"},
      {"--vary manoeuvre.speed=1 --metric 't'",
       "--vary \"manoeuvre.speed=1\": there is no manoeuvre; give its file with --manoeuvre\n"},
      {"--manoeuvre m.json --vary speed=10",
       "--vary speed: the manoeuvre says at which speed it starts; vary manoeuvre.speed\n"},
      {"--manoeuvre m.json --vary manoeuvre.speed=10 --set speed=3",
       "--set speed: the manoeuvre says at which speed it starts\n"},
      {"--vary load=1", "--metric: give a number of each motion, or a manoeuvre, which has those of its standard\n"},
      {"--manoeuvre m.json --vary load=1200 --keep k --every 0", "--every: must be positive, found 0\n"},
      {"--manoeuvre m.json --vary load=1200 --input-table x.csv",
       "--input-table: a manoeuvre moves the inputs; leave out one of the two\n"},
  };
  write("turn.json", R"({ "mbgen_manoeuvre": 1, "type": "events", "events": [{ "at": 1, "steer": 0.1 }] })");
  for (const BadStudy& bad : kBad) {
    const Outcome run = mbgen(fmt::format("sweep car.json {} --engine generic --out s.csv", bad.words));
    EXPECT_EQ(run.exit_code, 1) << bad.words;
    EXPECT_EQ(run.err, bad.message);
    EXPECT_FALSE(std::filesystem::exists(path("s.csv")));
  }
  const Outcome spring = mbgen("sweep spring.json --manoeuvre m.json --vary mass=1 --engine generic --out s.csv");
  EXPECT_TRUE(spring.err.starts_with("spring.json: the model has no vehicle\n")) << spring.err;
}

/// A study of the number of cases that its parameter says.
class KilledManoeuvres : public ManoeuvreStudy, public ::testing::WithParamInterface<int> {};

TEST_P(KilledManoeuvres, GoOnToTheSameTable) {
  const std::string words = fmt::format(
      "sweep car.json --manoeuvre m.json --vary load=1000:{}:1399 --vary manoeuvre.speed=10,20 --duration 1.2 "
      "--step 4e-3 --engine generic --jobs 2 ",
      800.0 / GetParam());
  const Outcome whole = mbgen(words + "--keep whole --out whole.csv");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const std::string expected = read("whole.csv");
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), GetParam() + 1);
  std::mt19937 random(11);
  int killed = 0, most = 300;
  for (bool ended = false; !ended; most += 60) {
    const pid_t child = fork();
    if (child == 0) {
      const std::string command = fmt::format("cd '{}' && exec '{}' {} --keep kept --out s.csv >/dev/null 2>&1",
                                              path("").string(), MBGEN_BINARY, words);
      ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      ::_exit(3);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % static_cast<unsigned>(most)));
    ::kill(child, SIGKILL);
    int state = 0;
    ::waitpid(child, &state, 0);
    ended = !WIFSIGNALED(state);
    killed += ended ? 0 : 1;
  }
  EXPECT_GE(killed, 1);
  EXPECT_EQ(read("s.csv"), expected);
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path("kept"))) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(".")) files.insert(name);  // a killed process leaves what it had not named yet
  }
  EXPECT_EQ(static_cast<int>(files.size()), 2 * GetParam());
  for (const std::string& name : files) EXPECT_EQ(read("kept/" + name), read("whole/" + name)) << name;
}

INSTANTIATE_TEST_SUITE_P(Some, KilledManoeuvres, ::testing::Values(12));
INSTANTIATE_TEST_SUITE_P(Many, KilledManoeuvres, ::testing::Values(200));

}  // namespace
}  // namespace mbgen::cli_test
