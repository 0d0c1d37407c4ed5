#include "geometry/knot_rates.hpp"

#include <Eigen/LU>

namespace mrroc {

namespace {

/// One block row per knot of the spline's linear system: lower x(i-1) + diagonal x(i) + upper x(i+1) = right. The
/// unknowns x of a knot are its first derivatives, and for a quintic its second ones.
template <int Unknowns>
struct BlockRow {
  using Block = Eigen::Matrix<double, Unknowns, Unknowns>;
  Block lower = Block::Zero(), diagonal = Block::Zero(), upper = Block::Zero();
  Eigen::Matrix<double, Unknowns, Eigen::Dynamic> right;
};

/// Gauss elimination by blocks (Thomas); leaves x in `right`.
template <int Unknowns>
void solve(std::vector<BlockRow<Unknowns>>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BlockRow<Unknowns>& row = rows[i];
    if (i > 0) {
      row.diagonal -= row.lower * rows[i - 1].upper;
      row.right -= row.lower * rows[i - 1].right;
    }
    const auto inverse = row.diagonal.inverse().eval();
    row.upper = inverse * row.upper;
    row.right = inverse * row.right;
  }
  for (std::size_t i = rows.size() - 1; i-- > 0;) rows[i].right -= rows[i].upper * rows[i + 1].right;
}

/// The spline's pieces, as the systems see them.
struct Pieces {
  Pieces(const std::vector<double>& knots, const Eigen::MatrixXd& values) {
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      length.push_back(knots[i + 1] - knots[i]);
      step.emplace_back(values.row(row + 1) - values.row(row));
    }
  }
  std::size_t count() const { return length.size(); }
  std::vector<double> length;
  std::vector<Eigen::RowVectorXd> step;
};

KnotRates cubic(SplineEnds ends, const Pieces& pieces) {
  const std::size_t n = pieces.count();
  const Eigen::Index columns = pieces.step[0].size();
  std::vector<BlockRow<1>> rows(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    BlockRow<1>& row = rows[i];
    row.right = Eigen::RowVectorXd::Zero(columns);
    const bool inner = i > 0 && i < n;
    if (!inner && ends == SplineEnds::at_rest) {
      row.diagonal(0) = 1;
      continue;
    }
    // the second derivatives from the left and from the right are the same; at an end they are 0
    if (i > 0) {
      const double h = pieces.length[i - 1];
      row.lower(0) = 1 / h;
      row.diagonal(0) += 2 / h;
      row.right += pieces.step[i - 1] * (3 / (h * h));
    }
    if (i < n) {
      const double h = pieces.length[i];
      row.upper(0) = 1 / h;
      row.diagonal(0) += 2 / h;
      row.right += pieces.step[i] * (3 / (h * h));
    }
  }
  solve(rows);
  KnotRates rates{Eigen::MatrixXd(n + 1, columns), Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n + 1), columns)};
  for (std::size_t i = 0; i <= n; ++i) rates.first.row(static_cast<Eigen::Index>(i)) = rows[i].right;
  for (std::size_t i = 1; i < n; ++i) {
    const double h = pieces.length[i];
    rates.second.row(static_cast<Eigen::Index>(i)) =
        pieces.step[i] * (6 / (h * h)) - (4 * rows[i].right + 2 * rows[i + 1].right) / h;
  }
  return rates;
}

/// Third derivatives times h^3, and fourth ones times h^4, of a QuinticPiece of length h at its start (0) and end (1),
/// as factors of the step and of first h, second h^2 at the start and at the end.
struct Factors {
  double step, first_0, second_0, first_1, second_1;
};
constexpr Factors kThird[2] = {{60, -36, -9, -24, 3}, {60, -24, -3, -36, 9}};
constexpr Factors kFourth[2] = {{-360, 192, 36, 168, -24}, {360, -168, -24, -192, 36}};

/// Adds a derivative of the piece before or after knot i to one of its equations, times `sign`.
void add(BlockRow<2>& row, int equation, const Factors& f, double power, double h, const Eigen::RowVectorXd& step,
         bool after, double sign) {
  const double scale = sign / power;
  auto& start = after ? row.diagonal : row.lower;
  auto& end = after ? row.upper : row.diagonal;
  start(equation, 0) += scale * f.first_0 * h;
  start(equation, 1) += scale * f.second_0 * h * h;
  end(equation, 0) += scale * f.first_1 * h;
  end(equation, 1) += scale * f.second_1 * h * h;
  row.right.row(equation) -= scale * f.step * step;
}

KnotRates quintic(SplineEnds ends, const Pieces& pieces) {
  const std::size_t n = pieces.count();
  const Eigen::Index columns = pieces.step[0].size();
  std::vector<BlockRow<2>> rows(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    BlockRow<2>& row = rows[i];
    row.right = Eigen::MatrixXd::Zero(2, columns);
    const bool inner = i > 0 && i < n;
    if (!inner) row.diagonal(1, 1) = 1;  // no second derivative at the ends
    if (!inner && ends == SplineEnds::at_rest) {
      row.diagonal(0, 0) = 1;
      continue;
    }
    // third and fourth derivatives from the left and from the right are the same; at an end the third is 0
    if (i > 0) {
      const double h = pieces.length[i - 1], cube = h * h * h;
      add(row, 0, kThird[1], cube, h, pieces.step[i - 1], false, 1);
      if (inner) add(row, 1, kFourth[1], cube * h, h, pieces.step[i - 1], false, 1);
    }
    if (i < n) {
      const double h = pieces.length[i], cube = h * h * h;
      add(row, 0, kThird[0], cube, h, pieces.step[i], true, -1);
      if (inner) add(row, 1, kFourth[0], cube * h, h, pieces.step[i], true, -1);
    }
  }
  solve(rows);
  KnotRates rates{Eigen::MatrixXd(n + 1, columns), Eigen::MatrixXd(n + 1, columns)};
  for (std::size_t i = 0; i <= n; ++i) {
    rates.first.row(static_cast<Eigen::Index>(i)) = rows[i].right.row(0);
    rates.second.row(static_cast<Eigen::Index>(i)) = rows[i].right.row(1);
  }
  return rates;
}

}  // namespace

KnotRates knot_rates(SplineOrder order, SplineEnds ends, const std::vector<double>& knots,
                     const Eigen::MatrixXd& values) {
  const Pieces pieces(knots, values);
  return order == SplineOrder::cubic ? cubic(ends, pieces) : quintic(ends, pieces);
}

}  // namespace mrroc
