// States and sampled values as they are read: what names in their expressions mean, in instances too, and the order of
// the auxiliary states.

#include "compiler/model/auxiliary_states.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using Kind = ExpressionNode::Kind;

/// Nodes of the expression of a quantity that look at the mechanism's own values.
std::vector<ExpressionNode> seen(const Model& model, const Quantity& quantity) {
  std::vector<ExpressionNode> nodes;
  for (const ExpressionNode& node : model.expressions.at(static_cast<std::size_t>(quantity.expression)).nodes)
    if (node.kind == Kind::state || node.kind == Kind::length || node.kind == Kind::rate) nodes.push_back(node);
  return nodes;
}

class States : public ModelFiles {};

// A cylinder in two instances: each state sees the length of its own spring and itself.
TEST_F(States, OfInstancesSeeTheirOwnElements) {
  write("cylinder.json", R"({ "mbgen": 1,
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "foot": [0, 0, -1] } },
      "piston": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "piston": { "type": "prismatic", "from": "ground.O", "to": "piston.O", "axis": "z" } },
    "springs": { "oil": { "from": "ground.foot", "to": "piston.O", "force": "-pressure" } },
    "states": { "pressure": { "derivative": "1e5 - pressure - 1e6*rate.oil/length.oil", "initial": 2e5, "unit": "Pa" } },
    "sampled": { "valve": { "period": 0.01, "value": "valve + pressure", "delay": 2 } } })");
  const Model model = read_file(write("two.json", R"({ "mbgen": 1,
    "bodies": { "ground": { "points": { "wall": [1, 0, 0] } } },
    "air_springs": { "bag": { "from": "ground.wall", "to": "right_piston.O", "pressure": 2e5, "ambient": 1e5,
      "exponent": 1.3, "area": 0.01, "volume": 0.001 } },
    "states": { "sum": { "derivative": "left_pressure - right_valve + length.bag", "nominal": 3 } },
    "instances": { "left": { "file": "cylinder.json" }, "right": { "file": "cylinder.json", "offset": [0, 1, 0] } } })"));
  ASSERT_EQ(model.states.size(), 3u);
  EXPECT_EQ(auxiliary_state_names(model),
            (std::vector<std::string>{"sum", "left_pressure", "right_pressure", "left_valve", "right_valve",
                                      "left_valve_in1", "left_valve_in2", "right_valve_in1", "right_valve_in2"}));
  EXPECT_EQ(held_state_count(model), 6);
  for (int side = 0; side < 2; ++side) {
    const std::vector<ExpressionNode> nodes = seen(model, model.states[static_cast<std::size_t>(1 + side)].derivative);
    ASSERT_EQ(nodes.size(), 3u);
    EXPECT_TRUE(nodes[0].kind == Kind::state && nodes[0].index == 1 + side);
    EXPECT_TRUE(nodes[1].kind == Kind::rate && nodes[1].index == side);
    EXPECT_TRUE(nodes[2].kind == Kind::length && nodes[2].index == side);
  }
  const std::vector<ExpressionNode> outer = seen(model, model.states[0].derivative);
  ASSERT_EQ(outer.size(), 3u);
  EXPECT_EQ(outer[0].index, 1);  // left_pressure
  EXPECT_EQ(outer[1].index, 4);  // right_valve, after three states
  EXPECT_EQ(outer[2].index, 2);  // the air spring, after two springs
  const std::vector<AuxiliaryState> states = auxiliary_states(model);
  EXPECT_EQ(states[1].rate_unit, "Pa/s");
  EXPECT_EQ(magnitude_of(states[1]), 2e5);
  EXPECT_EQ(magnitude_of(states[0]), 3);
  EXPECT_EQ(magnitude_of(states[3]), 1);
}

}  // namespace
}  // namespace mbgen
