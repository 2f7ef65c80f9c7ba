#include "compiler/topology/spanning_tree.hpp"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>

#include "compiler/topology/coordinate_uses.hpp"

namespace mbgen {
namespace {

/// Priority of a joint for the tree, before its number of equations.
enum class Hold { none, used, marked };

using JointSet = std::vector<int>;  ///< ascending indices into Model::joints

/// A closure as a set of joints: the tree joints between its two bodies, and the cut joint itself (-1 for a rod).
struct Cycle {
  int joint = -1;
  JointSet path;
};

/// Hint for a body of points only in an instance's subsystem that the instance does not connect; "" for other bodies
/// without a path.
std::string forgotten_connection(const Model& model, const std::vector<int>& island) {
  for (const int index : island) {
    const Body& body = model.bodies[index];
    const std::string written = body.where.pointer.substr(body.where.pointer.rfind('/') + 1);
    const bool has_points_only = body.mass.value == 0 && body.mass.expression < 0 && !body.points.empty();
    if (!has_points_only || written == body.name || body.where.file == model.file) continue;
    const auto same = std::find_if(model.bodies.begin(), model.bodies.end(),
                                   [&](const Body& other) { return other.name == written; });
    return "connect the instance's body: \"connect\": { " + quoted(written) + ": " +
           quoted(same == model.bodies.end() ? "BODY" : written) + " }";
  }
  return {};
}

/// Hint for a body without a path to ground because of this joint.
std::string holds_no_body(const Joint& joint) {
  const std::string name = "joint " + quoted(joint.name);
  return closes_only(joint.type) ? name + " of type " + name_of(joint.type) +
                                       " has no coordinates: add the joint that the body moves by, for example of type "
                                       "free from ground"
                                 : name + " is marked \"cut\": true and holds no body";
}

/// Spanning tree under construction: it is grown first, then joints of equal rank are exchanged.
class TreeSearch {
 public:
  explicit TreeSearch(const Model& model);
  void grow();
  void shorten_loops();
  void check_reach(Diagnostics& problems) const;
  void check_marks_and_uses(Diagnostics& problems) const;
  SpanningTree result() const;

 private:
  void reach(int body, int joint, int parent);
  void add_candidates(int body);
  JointSet path_between(int a, int b) const;
  void close_cycles();
  bool exchangeable(int cut, int kept) const;
  int weight(const JointSet& joints) const;
  bool try_exchange(std::size_t cut, int kept);
  std::string reason(const Cycle& cycle) const;
  bool may_be_in_tree(int joint) const {
    return model_.joints[joint].cut != CutMark::cut && !closes_only(model_.joints[joint].type);
  }
  int equations(int joint) const { return static_cast<int>(closure_rows(model_.joints[joint].type).size()); }

  /// Candidates for the next tree joint, best first: hold, equations, distance to ground, file order.
  using Candidate = std::tuple<Hold, int, int, int>;

  const Model& model_;
  std::vector<CoordinateUse> uses_;
  std::vector<Hold> hold_;                          // per joint
  std::vector<std::vector<int>> joints_of_;         // per body, ascending
  std::vector<bool> reached_;                       // per body
  std::vector<int> depth_, parent_, parent_joint_;  // of the tree as it grew
  std::vector<bool> in_tree_, exchanged_;           // per joint
  std::priority_queue<Candidate> candidates_;
  std::vector<Cycle> cycles_;  // of the tree as it is
};

TreeSearch::TreeSearch(const Model& model)
    : model_(model),
      uses_(coordinate_uses(model)),
      hold_(model.joints.size(), Hold::none),
      joints_of_(model.bodies.size()),
      reached_(model.bodies.size()),
      depth_(model.bodies.size()),
      parent_(model.bodies.size(), -1),
      parent_joint_(model.bodies.size(), -1),
      in_tree_(model.joints.size()),
      exchanged_(model.joints.size()) {
  for (const CoordinateUse& use : uses_) hold_[use.coordinate.joint] = Hold::used;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.cut == CutMark::tree) hold_[j] = Hold::marked;
    joints_of_[joint.from.body].push_back(static_cast<int>(j));
    joints_of_[joint.to.body].push_back(static_cast<int>(j));
  }
}

// Prim's algorithm for a maximum spanning tree: repeatedly the best joint to a new body.
void TreeSearch::grow() {
  if (model_.ground < 0) return;
  reach(model_.ground, -1, -1);
  add_candidates(model_.ground);
  while (!candidates_.empty()) {
    const int joint = -std::get<3>(candidates_.top());
    candidates_.pop();
    const int from = model_.joints[joint].from.body, to = model_.joints[joint].to.body;
    if (reached_[from] && reached_[to]) continue;
    const int body = reached_[to] ? from : to;
    in_tree_[joint] = true;
    reach(body, joint, body == to ? from : to);
    add_candidates(body);
  }
}

void TreeSearch::reach(int body, int joint, int parent) {
  reached_[body] = true;
  parent_[body] = parent;
  parent_joint_[body] = joint;
  depth_[body] = parent < 0 ? 0 : depth_[parent] + 1;
}

void TreeSearch::add_candidates(int body) {
  for (int joint : joints_of_[body]) {
    if (!may_be_in_tree(joint)) continue;
    candidates_.emplace(hold_[joint], equations(joint), -depth_[body], -joint);
  }
}

JointSet TreeSearch::path_between(int a, int b) const {
  JointSet path;
  while (a != b) {
    int& lower = depth_[a] >= depth_[b] ? a : b;
    path.push_back(parent_joint_[lower]);
    lower = parent_[lower];
  }
  std::sort(path.begin(), path.end());
  return path;
}

void TreeSearch::close_cycles() {
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const Joint& joint = model_.joints[j];
    if (in_tree_[j] || joint.type == JointType::free) continue;
    cycles_.push_back({static_cast<int>(j), path_between(joint.from.body, joint.to.body)});
  }
  for (const Rod& rod : model_.rods) cycles_.push_back({-1, path_between(rod.from.body, rod.to.body)});
}

bool TreeSearch::exchangeable(int cut, int kept) const {
  const auto is_free_choice = [&](int joint) {
    return hold_[joint] == Hold::none && model_.joints[joint].cut == CutMark::automatic && may_be_in_tree(joint);
  };
  return is_free_choice(cut) && is_free_choice(kept) && equations(cut) == equations(kept);
}

int TreeSearch::weight(const JointSet& joints) const {
  int coordinates = 0;
  for (int joint : joints) coordinates += static_cast<int>(model_.joints[joint].freedoms.size());
  return coordinates;
}

// If `kept` is cut instead, every other loop through it takes the rest of this cycle: their symmetric difference.
bool TreeSearch::try_exchange(std::size_t cut, int kept) {
  JointSet cycle = cycles_[cut].path;
  cycle.insert(std::lower_bound(cycle.begin(), cycle.end(), cycles_[cut].joint), cycles_[cut].joint);
  int change = 0;
  std::vector<std::pair<std::size_t, JointSet>> rerouted;
  for (std::size_t k = 0; k < cycles_.size(); ++k) {
    const JointSet& path = cycles_[k].path;
    if (k == cut || !std::binary_search(path.begin(), path.end(), kept)) continue;
    JointSet other;
    std::set_symmetric_difference(path.begin(), path.end(), cycle.begin(), cycle.end(), std::back_inserter(other));
    change += weight(other) - weight(path);
    rerouted.emplace_back(k, std::move(other));
  }
  if (change >= 0) return false;
  in_tree_[cycles_[cut].joint] = true;
  in_tree_[kept] = false;
  exchanged_[kept] = true;
  for (auto& [k, path] : rerouted) cycles_[k].path = std::move(path);
  cycle.erase(std::lower_bound(cycle.begin(), cycle.end(), kept));
  cycles_[cut] = {kept, std::move(cycle)};
  return true;
}

// Each exchange reduces the total length, so the search terminates.
void TreeSearch::shorten_loops() {
  close_cycles();
  const auto improve = [&] {
    for (std::size_t cut = 0; cut < cycles_.size(); ++cut) {
      if (cycles_[cut].joint < 0) continue;
      for (int kept : cycles_[cut].path) {
        if (exchangeable(cycles_[cut].joint, kept) && try_exchange(cut, kept)) return true;
      }
    }
    return false;
  };
  while (improve()) {
  }
}

// One message per connected component without a joint to ground.
void TreeSearch::check_reach(Diagnostics& problems) const {
  std::vector<bool> told = reached_;
  for (std::size_t body = 0; body < model_.bodies.size(); ++body) {
    if (told[body] || static_cast<int>(body) == model_.ground) continue;
    std::vector<int> island{static_cast<int>(body)};
    told[body] = true;
    int cut_joint = -1;
    for (std::size_t i = 0; i < island.size(); ++i) {
      for (int j : joints_of_[island[i]]) {
        const Joint& joint = model_.joints[j];
        const int other = joint.from.body == island[i] ? joint.to.body : joint.from.body;
        if (!may_be_in_tree(j) && cut_joint < 0) cut_joint = j;
        if (told[other] || !may_be_in_tree(j)) continue;
        told[other] = true;
        island.push_back(other);
      }
    }
    const std::string forgotten = forgotten_connection(model_, island);
    std::string hint = !forgotten.empty() ? forgotten
                       : cut_joint < 0    ? "add a joint, for example of type free from ground"
                                          : holds_no_body(model_.joints[cut_joint]);
    const std::size_t more = island.size() - 1;
    if (more > 0) hint += "; " + std::to_string(more) + (more == 1 ? " more body" : " more bodies") + " on its island";
    const Body& first = model_.bodies[body];
    problems.push_back({first.where, "body " + quoted(first.name) + " has no path to ground", hint, ""});
  }
}

void TreeSearch::check_marks_and_uses(Diagnostics& problems) const {
  std::vector<bool> told(model_.joints.size());
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const Joint& joint = model_.joints[j];
    if (in_tree_[j] || joint.cut != CutMark::tree || !reached_[joint.from.body] || !reached_[joint.to.body]) continue;
    told[j] = true;
    problems.push_back({joint.where,
                        "joint " + quoted(joint.name) + " is marked \"cut\": false but closes a loop: body " +
                            quoted(model_.bodies[joint.to.body].name) + " would have two parents",
                        "leave one joint of the loop without the mark", ""});
  }
  for (const CoordinateUse& use : uses_) {
    const Joint& joint = model_.joints[use.coordinate.joint];
    if (in_tree_[use.coordinate.joint] || told[use.coordinate.joint]) continue;
    if (!reached_[joint.from.body] || !reached_[joint.to.body]) continue;
    told[use.coordinate.joint] = true;
    const std::string& name = freedom_of(model_, use.coordinate).name;
    const bool marked = joint.cut == CutMark::cut;
    problems.push_back({joint.where,
                        "joint " + quoted(joint.name) + " closes a loop, so its coordinate " + quoted(name) +
                            " does not exist, but it is used by " + use.user,
                        marked ? "take the mark \"cut\": true away or mark another joint of the loop"
                               : "every other joint of the loop is used or marked too; free one of them",
                        ""});
  }
}

std::string TreeSearch::reason(const Cycle& cycle) const {
  const int joint = cycle.joint;
  if (closes_only(model_.joints[joint].type)) return "no coordinates";
  if (model_.joints[joint].cut == CutMark::cut) return "marked";
  bool cheaper_kept = false, equal_kept = false;
  for (int other : cycle.path) {
    cheaper_kept |= equations(other) < equations(joint);
    equal_kept |= hold_[other] == Hold::none && equations(other) == equations(joint);
  }
  const std::string fewest = "fewest equations (" + std::to_string(equations(joint)) + ")";
  if (cheaper_kept) return fewest + " of the joints that need not stay in the tree";
  if (!equal_kept) return fewest + " in its loop";
  if (exchanged_[joint]) return fewest + ", then shortest loops";
  return fewest + ", then farthest from ground, then last in the file";
}

SpanningTree TreeSearch::result() const {
  SpanningTree tree{in_tree_, std::vector<std::string>(model_.joints.size())};
  for (const Cycle& cycle : cycles_) {
    if (cycle.joint >= 0) tree.cut_reason[cycle.joint] = reason(cycle);
  }
  return tree;
}

}  // namespace

Result<SpanningTree> choose_spanning_tree(const Model& model) {
  TreeSearch search(model);
  search.grow();
  Diagnostics problems;
  search.check_reach(problems);
  search.check_marks_and_uses(problems);
  if (!problems.empty()) return problems;
  search.shorten_loops();
  return search.result();
}

}  // namespace mbgen
