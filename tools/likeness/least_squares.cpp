#include "tools/likeness/least_squares.hpp"

#include <Eigen/QR>
#include <cmath>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

void subtract(std::vector<double>& from, double factor, const std::vector<double>& what) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * what[i];
}

}  // namespace

std::vector<double> least_squares(const Columns& columns, const std::vector<double>& observed) {
    const auto rows = static_cast<Eigen::Index>(observed.size());
    Eigen::MatrixXd matrix(rows, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t c = 0; c < columns.size(); ++c) {
        SPECULA_EXPECT(columns[c].size() == observed.size());
        matrix.col(static_cast<Eigen::Index>(c)) =
            Eigen::Map<const Eigen::VectorXd>(columns[c].data(), rows);
    }
    const Eigen::Map<const Eigen::VectorXd> right(observed.data(), rows);
    const Eigen::VectorXd found = matrix.colPivHouseholderQr().solve(right);
    return {found.data(), found.data() + found.size()};
}

std::vector<double> unexplained(const Columns& columns, const std::vector<double>& coefficients,
                                const std::vector<double>& observed) {
    std::vector<double> rest = observed;
    for (std::size_t c = 0; c < columns.size(); ++c) subtract(rest, coefficients[c], columns[c]);
    return rest;
}

void ExplainedSpace::remove_from(std::vector<double>& column) const {
    for (int twice = 0; twice < 2; ++twice)  // once leaves rounding that grows with the set
        for (const auto& axis : axes_) subtract(column, dot(axis, column), axis);
}

void ExplainedSpace::add(std::vector<double> column) {
    const double before = std::sqrt(dot(column, column));
    remove_from(column);
    const double after = std::sqrt(dot(column, column));
    if (after <= 1e-6 * before) return;
    for (double& value : column) value /= after;
    axes_.push_back(std::move(column));
}

double ExplainedSpace::length_beyond(std::vector<double> column) const {
    remove_from(column);
    return std::sqrt(dot(column, column));
}

double ExplainedSpace::gain(std::vector<double> first, std::vector<double> second,
                            const std::vector<double>& residual) const {
    constexpr double least_new_share = 0.05;
    double explained = 0.0;
    std::vector<double> earlier;
    for (auto* column : {&first, &second}) {
        const double before = dot(*column, *column);
        remove_from(*column);
        if (!earlier.empty()) subtract(*column, dot(earlier, *column), earlier);
        const double after = dot(*column, *column);
        if (before == 0.0 || after < least_new_share * least_new_share * before) return 0.0;
        for (double& value : *column) value /= std::sqrt(after);
        explained += std::pow(dot(*column, residual), 2);
        earlier = *column;
    }
    return explained;
}

}  // namespace specula
