#pragma once
// Kinds of nodes that the expressions of a model mention.

#include <algorithm>
#include <initializer_list>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Whether an expression (index into Model::expressions, or -1) has a node of one of some kinds.
inline bool mentions(const Model& model, int expression, std::initializer_list<ExpressionNode::Kind> kinds) {
  if (expression < 0) return false;
  const std::vector<ExpressionNode>& nodes = model.expressions[static_cast<std::size_t>(expression)].nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const ExpressionNode& node) {
    return std::find(kinds.begin(), kinds.end(), node.kind) != kinds.end();
  });
}

}  // namespace mbgen
