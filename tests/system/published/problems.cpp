#include "tests/system/published/published.hpp"

namespace mbgen::published {

std::vector<Problem> problems() {
  return {
      {"A01", "Simple pendulum (IFToMM A01)", "models/iftomm/a01_simple_pendulum.json", simple_pendulum},
      {"A02", "N-four-bar, N = 2 (IFToMM A02)", "models/iftomm/a02_n_four_bar_2.json", n_four_bar},
      {"A03", "Andrews' squeezer (IVP test set; IFToMM A03)", "models/iftomm/a03_andrews.json", andrews},
      {"A04", "Bricard's mechanism (IFToMM A04)", "models/iftomm/a04_bricard.json", bricard},
      {"A05", "Flyball governor, stiff (IFToMM A05)", "models/iftomm/a05_flyball_governor.json", flyball_governor},
      {"Babyboot", "Babyboot (Kane)", "models/published/babyboot.json", babyboot},
      {"FreeBody", "Axisymmetric free body (Kane)", "models/published/free_body.json", free_body},
      {"HeavyTop", "Heavy top (Geradin, Cardona)", "models/published/heavy_top.json", heavy_top},
      {"Kuka", "KUKA iiwa (MotionGenesis, Drake)", "models/published/kuka_iiwa.json", kuka},
      {"Iltis", "Iltis (IAVSD road vehicle benchmark)", "models/published/iltis.json", iltis},
  };
}

std::vector<Problem> long_problems() {
  return {{"A02_40", "N-four-bar, N = 40 (LIM A02)", "bench/growth_model.sh",
           [] { return std::vector<Figure>{n_four_bar_of(40, 20)}; }}};
}

}  // namespace mbgen::published
