#pragma once

#include <Eigen/QR>
#include <utility>

namespace mrroc {

/// The x of least norm among those that minimise |A x - b|, at any rank of A, as
/// `Eigen::CompleteOrthogonalDecomposition::solve` computes it, bit for bit. That function allocates where the rank is
/// less than the number of columns; this one does not, if A and b have a bounded size. Any thread; never throws.
template <class Matrix, class Vector>
auto least_norm_solution(const Matrix& a, const Vector& b) noexcept {
  using Solution =
      Eigen::Matrix<double, Matrix::ColsAtCompileTime, 1, Eigen::ColMajor, Matrix::MaxColsAtCompileTime, 1>;
  const Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition(a);
  const Eigen::Index rank = decomposition.rank(), count = decomposition.cols();
  Solution solution = Solution::Zero(count);
  if (rank == 0) return solution;
  Vector rotated = b;
  rotated.applyOnTheLeft(decomposition.matrixQ().setLength(rank).adjoint());
  solution.head(rank) = decomposition.matrixT()
                            .topLeftCorner(rank, rank)
                            .template triangularView<Eigen::Upper>()
                            .solve(rotated.head(rank));
  double workspace = 0;
  for (Eigen::Index k = 0; rank < count && k < rank; ++k) {
    std::swap(solution[k], solution[rank - 1]);
    solution.segment(rank - 1, count - rank + 1)
        .applyHouseholderOnTheLeft(decomposition.matrixQTZ().row(k).tail(count - rank).adjoint(),
                                   decomposition.zCoeffs()[k], &workspace);
    std::swap(solution[k], solution[rank - 1]);
  }
  return Solution(decomposition.colsPermutation() * solution);
}

}  // namespace mrroc
