#pragma once

#include <vector>

namespace specula {

/// Columns of a linear model; each has as many entries as there are observations.
using Columns = std::vector<std::vector<double>>;

/// Coefficients that bring the sum of the columns nearest to `observed`; those of columns that
/// depend on others are among the least that do. QR with column pivoting (Eigen).
std::vector<double> least_squares(const Columns& columns, const std::vector<double>& observed);

/// What `observed` keeps when the columns have explained all they can.
std::vector<double> unexplained(const Columns& columns, const std::vector<double>& coefficients,
                                const std::vector<double>& observed);

/// A growing set of columns, made orthonormal one by one, to see what a further pair would explain.
class ExplainedSpace {
  public:
    /// Takes in a column; one that adds less than a millionth of itself is left out.
    void add(std::vector<double> column);
    /// The energy of `residual` that a pair of columns explains beyond this space. Pairs that lie
    /// nearly in it count as nothing: their coefficients would be large and cancel.
    double gain(std::vector<double> first, std::vector<double> second,
                const std::vector<double>& residual) const;

    /// Length of the part of a column that lies outside this space.
    double length_beyond(std::vector<double> column) const;

  private:
    void remove_from(std::vector<double>& column) const;
    Columns axes_;
};

}  // namespace specula
