#include "compiler/linearisation/frequency_response.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "compiler/algebra/dense.hpp"

namespace mbgen {
namespace {

using Complex = std::complex<double>;

/// Solves (s - A) x = b for upper Hessenberg A by elimination of its one subdiagonal, with row exchanges.
Eigen::VectorXcd solve_shifted(const Eigen::MatrixXd& hessenberg, Complex s, Eigen::VectorXcd b) {
  const Eigen::Index n = hessenberg.rows();
  Eigen::MatrixXcd m = -hessenberg.cast<Complex>();
  m.diagonal().array() += s;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::abs(m(k + 1, k)) > std::abs(m(k, k))) {
      m.row(k).tail(n - k).swap(m.row(k + 1).tail(n - k));
      std::swap(b[k], b[k + 1]);
    }
    if (m(k + 1, k) == Complex(0)) continue;
    const Complex factor = m(k + 1, k) / m(k, k);
    m.row(k + 1).tail(n - k) -= factor * m.row(k).tail(n - k);
    b[k + 1] -= factor * b[k];
  }
  m.triangularView<Eigen::Upper>().solveInPlace(b);
  return b;
}

/// Column of an input with those of its rates, each times another i w.
Eigen::VectorXcd with_rates(const Model& model, const Eigen::MatrixXd& columns, int input, Complex s) {
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(columns.rows());
  Complex factor = 1;
  for (int i = input; i >= 0; i = model.inputs[static_cast<std::size_t>(i)].derivative) {
    sum += factor * columns.col(i).cast<Complex>();
    factor *= s;
  }
  return sum;
}

}  // namespace

std::vector<Complex> frequency_response(const Model& model, const LinearSystem& system, int input, int output,
                                        const std::vector<double>& frequencies) {
  std::vector<Complex> response;
  const Hessenberg form = hessenberg(system.A);  // Q' of A = Q H Q' does not change with the frequency
  for (const double frequency : frequencies) {
    const Complex s(0, 2 * std::numbers::pi * frequency);
    Complex value = with_rates(model, system.D, input, s)[output];
    if (system.A.rows() > 0) {
      const Eigen::VectorXcd b = form.vectors.transpose().cast<Complex>() * with_rates(model, system.B, input, s);
      const Eigen::VectorXcd x = solve_shifted(form.h, s, b);
      value += ((system.C.row(output) * form.vectors).cast<Complex>() * x)(0);
    }
    const bool is_finite = std::isfinite(value.real()) && std::isfinite(value.imag());
    response.push_back(is_finite ? value : Complex(std::numeric_limits<double>::infinity(), 0));
  }
  return response;
}

}  // namespace mbgen
