#include "classifier/nearest_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "classifier/training_rows.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

using Index = Eigen::Index;

Matrix<float> standardised_rows(const FeatureTable& rows, const Standardiser& standardiser) {
    SPECULA_EXPECT(rows.n_features == standardiser.mean.size());
    Matrix<float> inputs(static_cast<Index>(rows.n_features), static_cast<Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t f = 0; f < rows.n_features; ++f)
            inputs(static_cast<Index>(f), static_cast<Index>(i)) =
                (rows.row(i)[f] - standardiser.mean[f]) * standardiser.scale[f];
    return inputs;
}

using Point = Eigen::Ref<const ColumnVector<float>>;

ColumnVector<float> squared_distances_to(const Matrix<float>& points, const Point& point) {
    return (points.colwise() - point).colwise().squaredNorm().transpose();
}

Matrix<float> columns_of(const Matrix<float>& all, const std::vector<Index>& chosen) {
    Matrix<float> columns(all.rows(), static_cast<Index>(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k)
        columns.col(static_cast<Index>(k)) = all.col(chosen[k]);
    return columns;
}

/// The first by chance, each further one with a probability as its squared distance from those.
Matrix<float> spread_centres(const Matrix<float>& points, Index n_centres, Stream& stream) {
    Matrix<float> centres(points.rows(), n_centres);
    centres.col(0) = points.col(stream.below(static_cast<std::uint32_t>(points.cols())));
    ColumnVector<float> nearest = squared_distances_to(points, centres.col(0));
    for (Index c = 1; c < n_centres; ++c) {
        double left = stream.uniform() * nearest.cast<double>().sum();
        Index pick = 0;
        while (pick + 1 < points.cols() && (left -= static_cast<double>(nearest(pick))) > 0.0)
            ++pick;
        centres.col(c) = points.col(pick);
        nearest = nearest.cwiseMin(squared_distances_to(points, centres.col(c)));
    }
    return centres;
}

/// Sum of squared distances from the nearest centres.
double spread_around(const Matrix<float>& centres, const Matrix<float>& points) {
    double sum = 0.0;
    for (Index i = 0; i < points.cols(); ++i)
        sum += static_cast<double>(squared_distances_to(centres, points.col(i)).minCoeff());
    return sum;
}

Matrix<float> cluster_means(const Matrix<float>& points, Index n_centres, int rounds,
                            Stream& stream) {
    Matrix<float> centres = spread_centres(points, n_centres, stream);
    for (int round = 0; round < rounds; ++round) {
        Matrix<double> sums = Matrix<double>::Zero(points.rows(), n_centres);
        std::vector<double> count(static_cast<std::size_t>(n_centres));
        for (Index i = 0; i < points.cols(); ++i) {
            Index own = 0;
            squared_distances_to(centres, points.col(i)).minCoeff(&own);
            sums.col(own) += points.col(i).cast<double>();
            count[static_cast<std::size_t>(own)] += 1.0;
        }
        for (Index c = 0; c < n_centres; ++c)
            if (count[static_cast<std::size_t>(c)] > 0.0)
                centres.col(c) = (sums.col(c) / count[static_cast<std::size_t>(c)]).cast<float>();
    }
    return centres;
}

}  // namespace

NearestNeighbours::NearestNeighbours(const FeatureTable& rows, int k)
    : standardiser_((check_training_rows(rows), fit_standardiser(rows))),
      inputs_(standardised_rows(rows, standardiser_)),
      label_(rows.label),
      n_classes_(rows.class_names.size()),
      k_(static_cast<std::size_t>(k)) {
    SPECULA_EXPECT(k >= 1 && k_ <= rows.size());
}

Predictions NearestNeighbours::predict(const FeatureTable& rows) const {
    const Matrix<float> asked = standardised_rows(rows, standardiser_);
    Predictions result{.n_classes = n_classes_, .label = {}, .probability = {}, .logits = {}};
    std::vector<std::size_t> order(label_.size());
    std::vector<double> votes(n_classes_);
    for (Index i = 0; i < asked.cols(); ++i) {
        const ColumnVector<float> distance = squared_distances_to(inputs_, asked.col(i));
        std::iota(order.begin(), order.end(), 0u);
        const auto nearer = [&](std::size_t a, std::size_t b) {
            const float of_a = distance(static_cast<Index>(a));
            const float of_b = distance(static_cast<Index>(b));
            return of_a < of_b || (of_a == of_b && a < b);
        };
        const auto end_of_votes = order.begin() + static_cast<std::ptrdiff_t>(k_);
        std::partial_sort(order.begin(), end_of_votes, order.end(), nearer);
        std::ranges::fill(votes, 1.0 / static_cast<double>(n_classes_));
        for (std::size_t v = 0; v < k_; ++v) votes[label_[order[v]]] += 1.0;
        const double most = *std::ranges::max_element(votes);
        const auto* const winner =
            std::find_if(order.data(), order.data() + k_,
                         [&](std::size_t row) { return votes[label_[row]] == most; });
        result.label.push_back(label_[*winner]);
        result.probability.push_back(static_cast<float>(most / static_cast<double>(k_ + 1)));
        for (const double vote : votes)
            result.logits.push_back(
                static_cast<float>(std::log(vote / static_cast<double>(k_ + 1))));
    }
    return result;
}

Prototypes fit_prototypes(const FeatureTable& rows, const PrototypeOptions& options,
                          const StreamKey& key) {
    SPECULA_EXPECT(options.per_class >= 1 && options.rounds >= 1 && rows.size() > 0);
    Prototypes prototypes{.standardiser = fit_standardiser(rows), .centre = {}};
    const Matrix<float> inputs = standardised_rows(rows, prototypes.standardiser);
    Stream stream(key);
    for (std::size_t label = 0; label < rows.class_names.size(); ++label) {
        std::vector<Index> own;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows.label[i] == label) own.push_back(static_cast<Index>(i));
        if (own.empty()) continue;
        const auto n = std::min<Index>(options.per_class, static_cast<Index>(own.size()));
        const Matrix<float> points = columns_of(inputs, own);
        Matrix<float> centres = cluster_means(points, n, options.rounds, stream);
        for (int start = 1; start < options.starts; ++start) {
            const Matrix<float> other = cluster_means(points, n, options.rounds, stream);
            if (spread_around(other, points) < spread_around(centres, points)) centres = other;
        }
        Matrix<float> all(inputs.rows(), prototypes.centre.cols() + n);
        all.leftCols(prototypes.centre.cols()) = prototypes.centre;
        all.rightCols(n) = centres;
        prototypes.centre = all;
    }
    return prototypes;
}

InputPrototypes kept(const Prototypes& prototypes) {
    const Matrix<float>& centre = prototypes.centre;
    return {.mean = prototypes.standardiser.mean,
            .scale = prototypes.standardiser.scale,
            .centre = {centre.data(), centre.data() + centre.size()}};
}

Prototypes prototypes_of(const InputPrototypes& kept) {
    const auto n_features = static_cast<Index>(kept.mean.size());
    const auto n_values = static_cast<Index>(kept.centre.size());
    return {.standardiser = {.mean = kept.mean, .scale = kept.scale},
            .centre = Eigen::Map<const Matrix<float>>(kept.centre.data(), n_features,
                                                      n_values / n_features)};
}

std::vector<double> prototype_distances(const Prototypes& prototypes, const FeatureTable& rows) {
    const Matrix<float> asked = standardised_rows(rows, prototypes.standardiser);
    std::vector<double> distances;
    for (Index i = 0; i < asked.cols(); ++i)
        distances.push_back(std::sqrt(
            static_cast<double>(squared_distances_to(prototypes.centre, asked.col(i)).minCoeff())));
    return distances;
}

}  // namespace specula
