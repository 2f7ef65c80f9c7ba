#include "compiler/passes/mirror_images.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "compiler/program/mixed_words.hpp"
#include "compiler/program/rounded.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kStates = 4;
/// Times the bounds of the roundings of both values. Those that differ by a number of the model differ by more: bounds
/// are some 1e-14 of what was summed.
constexpr double kRoundings = 16;

/// A number from 0 to 1 that follows from `seed` alone, on every machine.
double random_number(std::uint64_t seed) {
  return static_cast<double>(random_word(seed) >> 11) * 0x1p-53;
}

/// Inputs of the size that they may have: angles small enough for lengths and roots to stay what they are.
double random_input(Array array, std::uint64_t seed) {
  const double number = 2 * random_number(seed) - 1;
  switch (array) {
    case Array::z:
    case Array::x:
      return 0.2 * number;
    case Array::tau:
    case Array::law_result:
      return 100 * number;
    case Array::par:
    case Array::t:
      return 1 + 0.5 * number;
    default:
      return number;
  }
}

/// All values at one state, and at its image.
struct State {
  std::vector<Rounded> here, there;
};

State state_of(const Program& program, std::span<const MirroredInput> mirror, std::size_t number) {
  const std::size_t count = program.inputs.size();
  std::map<Slot, std::size_t> place;
  std::vector<double> here(count), there(count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) {
    place.emplace(program.inputs[i], i);
    here[i] = random_input(program.inputs[i].group.array, number * count + i);
  }
  for (const auto& [slot, image, sign] : mirror) {
    const auto from = place.find(slot), to = place.find(image);
    if (from != place.end() && to != place.end()) there[to->second] = sign * here[from->second];
  }
  return {rounded_values(program, here), rounded_values(program, there)};
}

class Images {
 public:
  Images(const Program& program, std::span<const MirroredInput> mirror)
      : program_(program), images_(program.nodes.size()) {
    for (std::size_t s = 0; s < kStates; ++s) states_.push_back(state_of(program, mirror, s));
    for (ValueId v = 0; v < images_.size(); ++v)
      if (std::isfinite(here(v).value)) by_size_.push_back(v);
    std::ranges::stable_sort(by_size_, {}, [&](ValueId v) { return std::abs(here(v).value); });
  }

  std::vector<MirrorImage> found() {
    find_shared();
    for (ValueId v = 0; v < images_.size(); ++v)
      if (images_[v].kind == Kind::unknown && is_known(v)) find_pair(v);
    find_lone();
    return std::move(images_);
  }

 private:
  using Kind = MirrorImage::Kind;

  const Rounded& here(ValueId v) const { return states_[0].here[v]; }

  /// Whether a value can be told from zero, at all states and their images.
  bool is_known(ValueId v) const {
    return std::ranges::all_of(states_, [&](const State& state) {
      const auto tells = [&](const Rounded& r) { return std::abs(r.value) > 2 * kRoundings * r.error; };
      return tells(state.here[v]) && tells(state.there[v]);
    });
  }

  /// Sign of v relative to u, at the image where `crossed`; 0 when they are not equal.
  int relative_sign(ValueId v, ValueId u, bool crossed) const {
    int sign = 0;
    for (const State& state : states_) {
      const Rounded &a = state.here[v], &b = crossed ? state.there[u] : state.here[u];
      const int now = (a.value < 0) == (b.value < 0) ? 1 : -1;
      if (sign == 0) sign = now;
      if (sign != now || !(std::abs(a.value - sign * b.value) <= kRoundings * (a.error + b.error))) return 0;
    }
    return sign;
  }

  void find_shared() {
    for (ValueId v = 0; v < images_.size(); ++v) {
      const bool is_constant = program_.nodes[v].op == Op::constant;
      const int sign = is_constant ? 1 : is_known(v) ? relative_sign(v, v, true) : 0;
      if (sign != 0) images_[v] = {Kind::shared, sign, false, kNoValue};
    }
  }

  /// Values of the size of `like`, within more than roundings.
  std::span<const ValueId> near(const Rounded& like) const {
    const double size = std::abs(like.value), room = 1e-9 * size + 2 * kRoundings * like.error;
    const auto size_of = [&](ValueId v) { return std::abs(here(v).value); };
    const auto first = std::ranges::lower_bound(by_size_, size - room, {}, size_of);
    const auto last = std::ranges::upper_bound(by_size_, size + room, {}, size_of);
    return {first, last};
  }

  /// Gives v, which is the earliest, and all that are the same or its image their place. Without an image there is no
  /// pair.
  void find_pair(ValueId v) {
    std::vector<std::pair<ValueId, MirrorImage>> pair;
    bool has_image = false;
    for (const bool crossed : {false, true})
      for (const ValueId u : near(crossed ? states_[0].there[v] : here(v))) {
        if (images_[u].kind != Kind::unknown || !is_known(u)) continue;
        const int sign = relative_sign(u, v, crossed);
        if (sign == 0) continue;
        pair.push_back({u, {Kind::paired, sign, crossed, v}});
        has_image = has_image || crossed;
      }
    if (!has_image) return;
    for (const auto& [u, image] : pair) images_[u] = image;
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
  std::vector<State> states_;
  std::vector<ValueId> by_size_;
};

}  // namespace

std::vector<MirrorImage> mirror_images(const Program& program, std::span<const MirroredInput> mirror) {
  return Images(program, mirror).found();
}

}  // namespace mbgen
