#include "classifier/input_monitor.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "classifier/matrix.hpp"
#include "firmware/fw_monitor.h"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

using Index = Eigen::Index;
constexpr double ridge_share = 1e-5;
constexpr double familiar_share = 0.99;

/// Rows around their classes' means.
struct Spread {
    ColumnVector<double> mean;  ///< (feature), of all rows
    Matrix<double> class_mean;  ///< (feature, class); that of all rows where a class has none
    Matrix<double> covariance;  ///< (feature, feature), within classes
};

ColumnVector<double> row_of(const FeatureTable& rows, std::size_t i) {
    const auto row = rows.row(i);
    ColumnVector<double> values(static_cast<Index>(row.size()));
    std::copy(row.begin(), row.end(), values.begin());
    return values;
}

Spread spread_of(const FeatureTable& rows) {
    const auto n = static_cast<Index>(rows.n_features);
    const auto n_classes = static_cast<Index>(rows.class_names.size());
    Spread spread{.mean = ColumnVector<double>::Zero(n),
                  .class_mean = Matrix<double>::Zero(n, n_classes),
                  .covariance = Matrix<double>::Zero(n, n)};
    std::vector<double> count(rows.class_names.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        spread.class_mean.col(rows.label[i]) += row_of(rows, i);
        count[rows.label[i]] += 1.0;
    }
    spread.mean = spread.class_mean.rowwise().sum() / static_cast<double>(rows.size());
    for (Index c = 0; c < n_classes; ++c) {
        const double own = count[static_cast<std::size_t>(c)];
        if (own > 0.0) spread.class_mean.col(c) /= own;
        if (own == 0.0) spread.class_mean.col(c) = spread.mean;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ColumnVector<double> away = row_of(rows, i) - spread.class_mean.col(rows.label[i]);
        spread.covariance += away * away.transpose() / static_cast<double>(rows.size());
    }
    return spread;
}

float percentile(std::vector<float> values) {
    const auto rank = static_cast<std::size_t>(familiar_share * static_cast<double>(values.size()));
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace

std::optional<InputMonitor> fit_input_monitor(const FeatureTable& rows) {
    if (rows.n_features > FW_MAHALANOBIS_MAX_FEATURES) return std::nullopt;
    Spread spread = spread_of(rows);
    const auto n = static_cast<Index>(rows.n_features);
    const double ridge = ridge_share * spread.covariance.trace() / static_cast<double>(n);
    if (!(ridge > 0.0)) return std::nullopt;
    spread.covariance.diagonal().array() += ridge;
    const Eigen::LLT<Matrix<double>> root(spread.covariance);
    if (root.info() != Eigen::Success) return std::nullopt;
    const Matrix<double> whitening = root.matrixL().solve(Matrix<double>::Identity(n, n));

    InputMonitor monitor;
    for (Index i = 0; i < n; ++i) {
        monitor.mean.push_back(static_cast<float>(spread.mean(i)));
        for (Index j = 0; j <= i; ++j)
            monitor.whitening.push_back(static_cast<float>(whitening(i, j)));
    }
    const Matrix<double> centre = whitening * (spread.class_mean.colwise() - spread.mean);
    for (const double value : centre.reshaped())
        monitor.centre.push_back(static_cast<float>(value));

    const fw_mahalanobis view{static_cast<std::uint16_t>(n),
                              static_cast<std::uint16_t>(rows.class_names.size()),
                              monitor.mean.data(), monitor.whitening.data(), monitor.centre.data()};
    std::vector<float> squared(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (fw_mahalanobis_squared(&view, rows.row(i).data(), &squared[i]) != FW_OK)
            return std::nullopt;
    monitor.suspicious_squared = percentile(squared);
    return monitor.suspicious_squared > 0.0f ? std::optional(monitor) : std::nullopt;
}

}  // namespace specula
