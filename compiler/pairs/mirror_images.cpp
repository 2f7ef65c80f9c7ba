#include "compiler/pairs/mirror_images.hpp"

#include <map>
#include <utility>

#include "compiler/program/function_field.hpp"

namespace mbgen {
namespace {

/// The inputs of a program at the image; those without one are variables of their own.
std::vector<Element> inputs_at_image(const Program& program, std::span<const MirroredInput> mirror,
                                     std::span<const Element> inputs, FunctionField& field) {
  std::map<Slot, std::size_t> place;
  for (std::size_t i = 0; i < inputs.size(); ++i) place.emplace(program.inputs[i], i);
  std::vector<Element> there = input_variables(program, field);
  for (const auto& [slot, image, sign] : mirror) {
    const auto from = place.find(slot), to = place.find(image);
    if (from != place.end() && to != place.end()) there[to->second] = with_sign(inputs[from->second], sign < 0);
  }
  return there;
}

class Images {
 public:
  Images(const Program& program, std::span<const MirroredInput> mirror)
      : program_(program), images_(program.nodes.size()) {
    FunctionField field;
    const std::vector<Element> inputs = input_variables(program, field);
    const auto here = elements_of(program, field, inputs);
    const auto there = elements_of(program, field, inputs_at_image(program, mirror, inputs, field));
    const std::vector<int> widths = widths_of(program);
    for (ValueId v = 0; v < images_.size(); ++v) {
      is_known_.push_back(widths[v] < 2 && here[v][0].number != 0);
      here_.push_back(here[v][0]);
      there_.push_back(there[v][0]);
      if (is_known_[v]) with_function_[here_[v].number].push_back(v);
    }
  }

  std::vector<MirrorImage> found() {
    find_shared();
    for (ValueId v = 0; v < images_.size(); ++v)
      if (images_[v].kind == Kind::unknown && is_known_[v]) find_pair(v);
    find_lone();
    return std::move(images_);
  }

 private:
  using Kind = MirrorImage::Kind;

  static int relative_sign(Element a, Element b) { return a.negative == b.negative ? 1 : -1; }

  void find_shared() {
    for (ValueId v = 0; v < images_.size(); ++v) {
      const bool is_constant = program_.nodes[v].op == Op::constant;
      if (is_constant || (is_known_[v] && here_[v].number == there_[v].number))
        images_[v] = {Kind::shared, is_constant ? 1 : relative_sign(here_[v], there_[v]), false, kNoValue};
    }
  }

  /// Gives v, which is the earliest, and all that are the same or its image their place. Without an image there is no
  /// pair.
  void find_pair(ValueId v) {
    const auto images = with_function_.find(there_[v].number);
    if (images == with_function_.end()) return;
    for (const ValueId u : with_function_[here_[v].number])
      images_[u] = {Kind::paired, relative_sign(here_[u], here_[v]), false, v};
    for (const ValueId u : images->second) images_[u] = {Kind::paired, relative_sign(here_[u], there_[v]), true, v};
  }

  void find_lone() {
    for (ValueId v = 0; v < images_.size(); ++v) {
      const Node& node = program_.nodes[v];
      bool all = images_[v].kind == Kind::unknown && node.op != Op::input;
      for (int k = 0; k < arity(node.op); ++k) all = all && images_[node.operands[k]].kind != Kind::unknown;
      if (all) images_[v].kind = Kind::lone;
    }
  }

  const Program& program_;
  std::vector<MirrorImage> images_;
  std::vector<Element> here_, there_;
  std::vector<bool> is_known_;                         ///< a number that is not zero
  std::map<int, std::vector<ValueId>> with_function_;  ///< by the number of the function
};

}  // namespace

std::vector<MirrorImage> mirror_images(const Program& program, std::span<const MirroredInput> mirror) {
  return Images(program, mirror).found();
}

}  // namespace mbgen
