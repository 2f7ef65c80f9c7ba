#pragma once
// The choice of a linear algebra for the generic runtime.

namespace mbgen {

/// The library behind the dense or sparse algebra: mbgen's own, and the paper's three columns.
enum class LinearAlgebra {
  entries,  ///< each loop block by the entries of its rows, sparse products
  eigen,    ///< dense, Eigen
  blas,     ///< the paper's LU on cblas_idamax, cblas_dswap and cblas_dger, products by cblas_dgemm
  sparse    ///< KLU of SuiteSparse, sparse products
};

/// How the closures choose dependent coordinates and are solved.
enum class Factorisation { lu, qr };

struct GenericAlgebra {
  LinearAlgebra library = LinearAlgebra::entries;
  Factorisation factorisation = Factorisation::lu;
};

}  // namespace mbgen
