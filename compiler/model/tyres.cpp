#include "compiler/model/tyres.hpp"

namespace mbgen {

std::vector<int> tyres_on_host(const Model& model) {
  std::vector<int> tyres;
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    const int road = model.tyres[i].road;
    if (road >= 0 && model.roads[static_cast<std::size_t>(road)].host_input >= 0) tyres.push_back(static_cast<int>(i));
  }
  return tyres;
}

}  // namespace mbgen
