#pragma once
// A ring with everything that an opened loop block can meet: a base that moves and turns, a driven joint, a body and a
// spring on its links.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace mbgen::testing {

/// A ring of so many joints on a mast that turns about an oblique axis on a sled. spatial: axes in all directions; else
/// all of them along y of the mast.
inline std::string carried_ring(int joints, bool spatial) {
  const auto point = [&](int k) {
    const double turn = 2 * std::numbers::pi * k / joints, radius = joints * 0.1 / (2 * std::numbers::pi);
    const double r = radius * (1 + 0.1 * std::sin(3 * turn));
    return std::array{r * std::cos(turn), spatial ? 0.3 * radius * std::sin(2 * turn) : 0.1, r * std::sin(turn)};
  };
  const auto text = [](const std::array<double, 3>& p) {
    return fmt::format("[{:.6f}, {:.6f}, {:.6f}]", p[0], p[1], p[2]);
  };
  std::string bodies = fmt::format(R"("ground": {{ "points": {{ "O": [0, 0, 0], "P": [0.5, 0.3, 3] }} }},
"sled": {{ "mass": 8, "com": [0, 0, 0.1], "inertia": [0.4, 0.5, 0.6], "points": {{ "O": [0, 0, 0] }} }},
"mast": {{ "mass": 5, "com": [0.1, 0.05, 0.2], "inertia": [0.3, 0.4, 0.2, 0.01, 0.02, -0.01],
"points": {{ "O": [0, 0, 0], "J0": {}, "J{}": {} }} }},
"load": {{ "mass": 0.4, "com": [0, 0.2, -0.3], "inertia": [0.01, 0.01, 0.002], "points": {{ "L": {} }} }})",
                                   text(point(0)), joints - 1, text(point(joints - 1)), text(point(6)));
  std::string list = R"("slide": { "type": "prismatic", "from": "ground.O", "to": "sled.O", "axis": "x" },
"turn": { "type": "revolute", "from": "sled.O", "to": "mast.O", "axis": [0.3, 0.2, 1] },
"hang": { "type": "revolute", "from": "link7.J6", "to": "load.L", "axis": [1, 0.2, 0] })";
  for (int k = 0; k < joints; ++k) {
    const std::string from = k == 0 ? "mast" : fmt::format("link{}", k);
    const std::string to = k == joints - 1 ? "mast" : fmt::format("link{}", k + 1);
    const std::string axis =
        spatial ? text({std::sin(1.7 * k), std::cos(2.3 * k), std::sin(0.9 * k + 1)}) : std::string(R"("y")");
    list += fmt::format(R"(,
"J{0}": {{ "type": "revolute", "from": "{1}.J{0}", "to": "{2}.J{0}", "axis": {3} }})",
                        k, from, to, axis);
    if (k == 0) continue;
    const auto a = point(k - 1), b = point(k);
    const std::array middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2 + 0.01, (a[2] + b[2]) / 2};
    bodies += fmt::format(R"(,
"link{0}": {{ "mass": {1}, "com": {2}, "inertia": [0.002, 0.003, 0.0025],
"points": {{ "J{3}": {4}, "J{0}": {5} }} }})",
                          k, 0.5 + 0.01 * k, text(middle), k - 1, text(a), text(b));
  }
  return fmt::format(R"({{ "mbgen": 1, "name": "carried_ring", "gravity": [0, 0, -9.81],
"bodies": {{ {} }},
"joints": {{ {} }},
"springs": {{ "tie": {{ "from": "link12.J12", "to": "ground.P", "stiffness": 90, "damping": 2, "free_length": 1 }} }},
"motions": {{ "drive": {{ "joint": "J3", "angle": "sin(2*t)*0.05" }} }} }})",
                     bodies, list);
}

}  // namespace mbgen::testing
