// Ropes against closed forms and motions of an independent integrator.

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/ropes_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

// The smaller tension is held by ground; the end is drawn away along the rope, which then slides on the drum.
TEST(Ropes, SlideOnADrumAtTheCapstanRatio) {
  for (const Json& row : rope_reference()["capstan"]) {
    const double mu = row["mu"], degrees = row["wrap_deg"], r = 0.1;
    const int turns = degrees > 360 ? 1 : 0;
    const double angle = (degrees - 360 * turns) * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);  // turned from z to x, about y
    const double x = r * s + 2 * c, z = r * c - 2 * s;
    const std::string path =
        rope({point("ground.A"),
              circle("ground.O", r, true, fmt::format(R"(, "friction": {}, "turns": {})", mu, turns)), point("end.O")},
             R"("EA": 1e4, "pretension": 20)");
    std::string text = plane_model({{"end", "x", 1, x, z}}, R"("A": [-1, 0, 0.1], "O": [0, 0, 0])",
                                   R"("motions": { "end": { "joint": "end", "position": "0.3*t" } }, )" + ropes(path));
    text.replace(text.find(R"("axis": "x")"), 11, fmt::format(R"("axis": [{:.17g}, 0, {:.17g}])", c, -s));
    Roped m(text);
    EXPECT_NEAR(m.shown(wrap), degrees * std::numbers::pi / 180, 1e-9);
    m.run(0.8, 1e-3);
    EXPECT_NEAR(m.shown(tension, 1) / m.shown(tension, 0), double(row["ratio"]), 1e-6 * double(row["ratio"]));
    EXPECT_GT(m.shown(tension, 0), 25);
    EXPECT_GT(m.state().x[0], 0.002);
  }
}

std::string atwood(double m1, double m2, const std::string& wheel, const std::string& law, double inertia = 0.02) {
  return plane_model({{"one", "z", m1, -0.1, -1}, {"two", "z", m2, 0.1, -1}, {"wheel", "turn", 1, 0, 0, inertia}},
                     R"("drum": [0, 0, 0])",
                     ropes(rope({point("one.O"),
                                 circle(wheel == "fixed" ? "ground.drum" : "wheel.O", 0.1, true,
                                        wheel == "fixed" ? R"(, "friction": 0.15)" : wheel),
                                 point("two.O")},
                                law)));
}

TEST(Ropes, LetAtwoodsMassesFall) {
  const Json& row = rope_reference()["atwood"];
  const double m1 = row["m1"], m2 = row["m2"], a = row["a_massless"];
  Roped m(atwood(m1, m2, "", fmt::format(R"("EA": 1e6, "pretension": {:.17g})", m1 * (kG - a))));
  m.run(0.5, 1e-3);
  EXPECT_NEAR(m.z("one"), -a * 0.125, 1e-9);
  EXPECT_NEAR(m.z("two"), a * 0.125, 1e-9);
  EXPECT_EQ(m.zd("wheel"), 0);
}

/// Fall of the first mass in half a second less the rigid one.
double error_of_fall(const std::string& text, double a, double h) {
  Roped m(text);
  m.run(0.5, h);
  return m.z("one") + a * 0.125;
}

// A wheel with inertia needs two tensions; the error of an elastic rope falls with 1 / EA.
TEST(Ropes, TurnAtwoodsWheel) {
  const Json& row = rope_reference()["atwood"];
  const double a = row["a"];
  const auto text = [&](double ea) {
    return atwood(row["m1"], row["m2"], R"(, "contact": "grips")",
                  fmt::format(R"("EA": {}, "pretension": 23.8, "damping": 1e-3)", ea));
  };
  const double soft = error_of_fall(text(1e5), a, 1e-4), stiff = error_of_fall(text(4e5), a, 1e-4);
  EXPECT_NEAR(soft / stiff, 4, 0.2);
  EXPECT_LT(std::abs(stiff), 2e-5);
  Roped m(text(4e5));
  m.run(0.5, 1e-4);
  EXPECT_NEAR(m.shown(tension, 0), double(row["T1"]), 5e-3);
  EXPECT_NEAR(m.shown(tension, 1), double(row["T2"]), 5e-3);
  EXPECT_NEAR(m.zd("wheel"), -a * 0.5 / 0.1, 1e-3);
}

TEST(Ropes, SlideOverAtwoodsFixedDrumAboveTheLimit) {
  const Json& row = rope_reference()["atwood_on_a_fixed_drum"];
  const double m1 = row["m1"], m2 = row["m2"], a = row["a"], e = row["e"];
  const auto text = [&](double mass, double ea, double lag = 1e-3) {
    return atwood(mass, m2, "fixed", fmt::format(R"("EA": {}, "pretension": 25, "damping": 1e-3, "lag": {})", ea, lag));
  };
  double errors[2];
  for (int k = 0; k < 2; ++k) {
    Roped m(text(m1, 4e5, k == 0 ? 1e-3 : 2.5e-4));
    m.run(0.3, 1e-4);
    const double before = m.zd("one");  // the tensions have come to those of the slip
    m.run(0.5, 1e-4);
    EXPECT_NEAR((before - m.zd("one")) / 0.2, a, 1e-3 * a);
    EXPECT_NEAR(m.shown(tension, 1), double(row["T2"]), 1e-3);
    errors[k] = m.shown(tension, 0) / m.shown(tension, 1) / e - 1;
    EXPECT_LT(std::abs(errors[k]), 3e-5);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.5);  // an excess that fades with the lag
  const double limit = row["slides_above_m1"];
  for (const double share : {0.8, 1.05}) {
    Roped m(text(share * limit, 1e5));
    m.run(0.5, 2e-4);
    const double before = m.z("one");
    m.run(1, 2e-4);
    EXPECT_EQ(m.z("one") - before<-1e-3, share> 1);
    if (share < 1) {
      EXPECT_NEAR(m.z("one"), before, 1e-6);
    }
  }
}

TEST(Ropes, CarryLoadsInBlocks) {
  constexpr double r = 0.05;
  for (const Json& row : rope_reference()["block_and_tackle"]) {
    const int falls = row["falls"];
    const double load = row["load"], counter = row["counter"], a = row["a_load"], force = row["tension"];
    // Falls are 2 r apart; a load's pulley is between two that it hangs on, ground's after it.
    const bool begins_at_load = falls % 2 == 1;
    std::vector<std::string> path{point(begins_at_load ? "load.A" : "ground.A")};
    std::string grounds = R"("A": [0, 0, 0])", blocks = R"("A": [0, 0, 0])";
    for (int fall = 0; fall < falls; ++fall) {
      const bool on_load = (fall % 2 == 1) == begins_at_load;
      const std::string name = fmt::format("P{}", fall),
                        at = fmt::format(R"(, "{}": [{:.17g}, 0, 0])", name, (2 * fall + 1) * r);
      (on_load ? blocks : grounds) += at;
      path.push_back(circle((on_load ? "load." : "ground.") + name, r, !on_load));
    }
    path.push_back(point("counter.O"));
    std::string text = plane_model({{"load", "z", load, 0, -2}, {"counter", "z", counter, 2 * falls * r, -1}}, grounds,
                                   ropes(rope(path, fmt::format(R"("EA": 1e6, "pretension": {:.17g})", force))));
    const std::string own = R"("points": { "O": [0, 0, 0] })";
    text.replace(text.find(own), own.size(), R"("points": { "O": [0, 0, 0], )" + blocks + " }");
    Roped m(text);
    m.run(0.3, 1e-3);
    EXPECT_NEAR(m.z("load"), a * 0.045, 1e-9) << falls;
    EXPECT_NEAR(m.z("counter"), -falls * a * 0.045, 1e-8) << falls;
    EXPECT_NEAR(m.shown(tension), force, 1e-6) << falls;
  }
}

// The hand chain runs on the large sprocket; the load chain runs off the small one onto the large one.
TEST(Ropes, BalanceTheDifferentialPulley) {
  const Json& row = rope_reference()["differential_pulley"];
  const double R = row["R"], r = row["r"], W = row["W"], F = row["F"], middle = (R - r) / 2;
  const double block = (R + r) / 2;
  const auto text = [&](double hand) {
    return plane_model(
        {{"shaft", "turn", 1, 0, 0}, {"load", "z", W / kG, middle, -2}, {"hand", "z", hand / kG, -R, -1}},
        R"("A": [0, 0, 0])",
        ropes(rope({circle("shaft.O", r, false, "", "drum"), circle("load.O", block, false),
                    circle("shaft.O", R, false, "", "drum")},
                   fmt::format(R"("EA": 1e7, "pretension": {})", W / 2), "load") +
              ", " +
              rope({circle("shaft.O", R, false, "", "drum"), point("hand.O")},
                   fmt::format(R"("EA": 1e7, "pretension": {:.17g})", hand), "hand")));
  };
  Roped balanced(text(F)), heavier(text(1.01 * F));
  balanced.accelerate();
  heavier.accelerate();
  for (const char* name : {"load", "hand"}) EXPECT_NEAR(balanced.zdd(name), 0, 1e-9) << name;
  // The strain energy of rope that is wound up is of the order of its strain, 5e-5.
  EXPECT_NEAR(balanced.zdd("shaft") / (F * R), 0, 1e-4);
  EXPECT_GT(std::abs(heavier.zdd("shaft") / (F * R)), 9e-3);
}

// A bob of 1 kg on a rope of stiffness EA: errors fall with 1 / EA.
TEST(Ropes, HoistAPendulum) {
  for (const Json& row : rope_reference()["hoisted_pendulum"]["cases"]) {
    const double l0 = row["l0"], speed = row["rate"], theta0 = row["theta0"];
    const auto largest_error = [&](double ea) {
      const double pull = row["tension_per_kg"][0], start = l0 * (1 + pull / ea);
      Roped m(plane_model(
          {{"bob", "plane", 1, start * std::sin(theta0), -start * std::cos(theta0)}}, R"("A": [0, 0, 0])",
          ropes(rope({point("ground.A"), point("bob.O")},
                     fmt::format(R"("EA": {}, "free_length": "{} + {}*t", "damping": 1e-3)", ea, l0, speed)))));
      m.state().zd.assign(3, 0.0);
      m.set("bob_tx", 0, speed * std::sin(theta0));
      m.set("bob_tz", 0, -speed * std::cos(theta0));
      double largest = 0;
      for (std::size_t k = 1; k < row["t"].size(); ++k) {
        m.run(row["t"][k], 5e-4);
        const double x = start * std::sin(theta0) + m.z("bob_tx"), z = -start * std::cos(theta0) + m.z("bob_tz");
        largest = std::max(largest, std::abs(std::atan2(x, -z) - double(row["theta"][k])));
        EXPECT_NEAR(m.shown(tension), double(row["tension_per_kg"][k]), 3e3 / ea);
      }
      return largest;
    };
    const double soft = largest_error(1e5), stiff = largest_error(4e5);
    EXPECT_NEAR(soft / stiff, 4, 0.4) << l0;
    EXPECT_LT(stiff, 6e-5) << l0;
  }
}

TEST(Ropes, SwingAtwoodsMass) {
  const Json& row = rope_reference()["swinging_atwood"];
  const double mu = row["mu"], r0 = row["r0"], theta0 = row["theta0"];
  const auto largest_error = [&](double ea) {
    Roped m(
        plane_model({{"bob", "plane", 1, r0 * std::sin(theta0), -r0 * std::cos(theta0)}, {"other", "z", mu, 0.2, -2}},
                    R"("A": [0, 0, 0], "B": [0.2, 0, 0])",
                    ropes(rope({point("bob.O"), point("ground.A"), point("ground.B"), point("other.O")},
                               fmt::format(R"("EA": {}, "pretension": {:.17g}, "damping": 1e-4)", ea,
                                           mu * kG * (1 + std::cos(theta0)) / (1 + mu))))));
    double largest = 0;
    for (std::size_t k = 1; k < row["t"].size(); ++k) {
      m.run(row["t"][k], 2.5e-4);
      const double x = r0 * std::sin(theta0) + m.z("bob_tx"), z = -r0 * std::cos(theta0) + m.z("bob_tz");
      largest = std::max(largest, std::abs(std::hypot(x, z) - double(row["r"][k])));
      largest = std::max(largest,
                         std::abs(std::remainder(std::atan2(x, -z) - double(row["theta"][k]), 2 * std::numbers::pi)));
    }
    return largest;
  };
  const double soft = largest_error(4e5), stiff = largest_error(1.6e6);
  EXPECT_NEAR(soft / stiff, 4, 1);
  EXPECT_LT(stiff, 2e-3);
}

TEST(Ropes, StretchUnderALoad) {
  const Json& row = rope_reference()["elastic_rope"];
  const double ea = row["EA"], l = row["l"], mass = row["m"];
  Roped m(plane_model({{"load", "z", mass, 0, -l}}, R"("A": [0, 0, 0])",
                      ropes(rope({point("ground.A"), point("load.O")}, fmt::format(R"("EA": {})", ea)))));
  GenericState rest = m.state();
  ASSERT_TRUE(m.solver().equilibrium(rest).ok());
  EXPECT_NEAR(-rest.z[0], double(row["sag"]), 1e-9);
  double largest = 0;
  const double h = 1e-3, omega = row["omega"];
  while (m.state().t < 1) {
    m.run(m.state().t + h, h);
    largest = std::max(largest, m.shown(tension));
    EXPECT_NEAR(-m.z("load"), double(row["sag"]) * (1 - std::cos(omega * m.state().t)), 1e-8);
  }
  EXPECT_NEAR(largest, double(row["largest_tension"]), 1e-6 * largest);
  m.set("load", 0.5, 0);  // above its rope
  EXPECT_EQ(m.shown(tension), 0);
  EXPECT_NEAR(m.zdd("load"), -kG, 1e-14);
}

// Masses on short ropes: the sag approaches that of the chain with the square of the number of pieces.
TEST(Ropes, HangAsACatenary) {
  const Json& row = rope_reference()["catenary"];
  const auto hung = [&](int pieces) {
    std::vector<HungPart> parts;
    std::string list;
    const double piece = 12.0 / pieces, parameter = row["parameter"];
    for (int k = 1; k < pieces; ++k) {
      const double s = k * piece - 6, x = parameter * std::asinh(s / parameter);
      parts.push_back(
          {fmt::format("m{}", k), "plane", 2 * piece, x, std::hypot(parameter, s) - std::hypot(parameter, 6)});
    }
    for (int k = 0; k < pieces; ++k)
      list += (k ? ", " : "") + rope({point(k == 0 ? "ground.L" : fmt::format("m{}.O", k)),
                                      point(k + 1 == pieces ? "ground.R" : fmt::format("m{}.O", k + 1))},
                                     fmt::format(R"("EA": 1e7, "free_length": {:.17g})", piece),
                                     fmt::format("r{}", k).c_str());
    Roped m(plane_model(parts, R"("L": [-5, 0, 0], "R": [5, 0, 0])", ropes(list)));
    EXPECT_TRUE(m.solver().equilibrium(m.state()).ok());
    const std::string middle = fmt::format("m{}", pieces / 2);
    const double sag = -(m.z(middle + "_tz") + parts[pieces / 2 - 1].z);
    return std::pair(sag, m.shown(tension));
  };
  const auto [coarse, coarse_pull] = hung(8);
  const auto [fine, fine_pull] = hung(16);
  const double sag = row["sag"];
  EXPECT_NEAR((coarse - sag) / (fine - sag), 4, 0.2);
  EXPECT_NEAR((4 * fine - coarse) / 3, sag, 2e-4);
  // The support carries half of its piece more than the first rope.
  const double across = row["horizontal_tension"], down = 6 * 2 * kG - 12.0 / 16 * kG;
  EXPECT_NEAR(fine_pull, std::hypot(across, down), 0.3);
  EXPECT_LT(fine_pull, coarse_pull + 10);
}

}  // namespace
}  // namespace mbgen
