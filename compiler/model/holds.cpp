#include "compiler/model/holds.hpp"

namespace mbgen {

std::vector<std::string> hold_names(const Model& model) {
  std::vector<std::string> names;
  each_kind([&](auto kind) {
    if constexpr (requires { kind.holds(model, std::size_t{}, names); })
      for (std::size_t i = 0; i < kind.list(model).size(); ++i) kind.holds(model, i, names);
  });
  return names;
}

}  // namespace mbgen
