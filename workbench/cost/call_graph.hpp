#pragma once
// The call graph that g++ writes with -fcallgraph-info=su, and the deepest path through it.

#include <map>
#include <set>
#include <string>
#include <vector>

namespace mbgen {

/// A function of the graph.
struct CalledFunction {
  std::string name;             ///< without arguments and result: "four_bar::step_rk4"
  long frame = 0;               ///< bytes, return address included
  bool is_outside = true;       ///< not in the objects
  bool is_local = false;        ///< not seen outside its object
  std::set<std::string> calls;  ///< keys of CallGraph
};

/// Functions by the compiler's title.
using CallGraph = std::map<std::string, CalledFunction>;

/// Adds the functions and calls of one .ci file. A function that is there already keeps the larger frame.
/// Fails: std::runtime_error when a frame has no bound.
void add_call_graph(const std::string& text, CallGraph& graph);

/// A call path: titles, and the sum of the frames along it.
struct CallPath {
  long bytes = 0;
  std::vector<std::string> titles;
};

/// The call path from a function that needs most stack. Fails: std::runtime_error if a function calls itself.
CallPath deepest_path(const CallGraph& graph, const std::string& title);

}  // namespace mbgen
