#include "workbench/signals/fourier.hpp"

#include <unsupported/Eigen/FFT>

namespace mbgen {

std::size_t power_of_two(std::size_t n) {
  std::size_t power = 1;
  while (power < n) power *= 2;
  return power;
}

std::vector<Complex> transformed(const std::vector<Complex>& x) {
  std::vector<Complex> result;
  Eigen::FFT<double>().fwd(result, x);
  return result;
}

std::vector<Complex> transformed_back(const std::vector<Complex>& x) {
  std::vector<Complex> result;
  Eigen::FFT<double>().inv(result, x);
  return result;
}

}  // namespace mbgen
