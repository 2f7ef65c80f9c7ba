#pragma once
// The choice of a linear algebra for the generic runtime.

namespace mbgen {

/// The library behind the dense or sparse algebra: the paper's three columns.
enum class LinearAlgebra {
  eigen,  ///< dense, Eigen
  blas,   ///< the paper's LU on cblas_idamax, cblas_dswap and cblas_dger, products by cblas_dgemm
  sparse  ///< KLU of SuiteSparse, sparse products
};

/// How the closures choose dependent coordinates and are solved.
enum class Factorisation { lu, qr };

struct GenericAlgebra {
  LinearAlgebra library = LinearAlgebra::eigen;
  Factorisation factorisation = Factorisation::lu;
};

}  // namespace mbgen
