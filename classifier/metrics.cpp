#include "classifier/metrics.hpp"

#include <algorithm>
#include <numeric>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

std::int64_t n_true(const Confusion& confusion, std::size_t truth) {
    std::int64_t sum = 0;
    for (std::size_t p = 0; p < confusion.n; ++p) sum += confusion.at(truth, p);
    return sum;
}

std::int64_t n_predicted(const Confusion& confusion, std::size_t predicted) {
    std::int64_t sum = 0;
    for (std::size_t t = 0; t < confusion.n; ++t) sum += confusion.at(t, predicted);
    return sum;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Confusion confusion_of(std::span<const std::uint8_t> truth, std::span<const std::uint8_t> predicted,
                       std::size_t n_classes) {
    SPECULA_EXPECT(truth.size() == predicted.size());
    Confusion confusion(n_classes);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        SPECULA_EXPECT(truth[i] < n_classes && predicted[i] < n_classes);
        ++confusion.at(truth[i], predicted[i]);
    }
    return confusion;
}

Confusion merge_classes(const Confusion& confusion, std::span<const int> merged_class) {
    SPECULA_EXPECT(merged_class.size() == confusion.n && confusion.n > 0);
    SPECULA_EXPECT(*std::ranges::min_element(merged_class) >= 0);
    Confusion merged(static_cast<std::size_t>(*std::ranges::max_element(merged_class)) + 1);
    for (std::size_t t = 0; t < confusion.n; ++t)
        for (std::size_t p = 0; p < confusion.n; ++p)
            merged.at(static_cast<std::size_t>(merged_class[t]),
                      static_cast<std::size_t>(merged_class[p])) += confusion.at(t, p);
    return merged;
}

double macro_f1(const Confusion& confusion) {
    double sum = 0.0;
    int n_present = 0;
    for (std::size_t c = 0; c < confusion.n; ++c) {
        const std::int64_t n = n_true(confusion, c);
        if (n == 0) continue;
        // 2 TP + FP + FN: those that are of the class and those called so.
        sum += 2.0 * static_cast<double>(confusion.at(c, c)) /
               static_cast<double>(n + n_predicted(confusion, c));
        ++n_present;
    }
    SPECULA_EXPECT(n_present > 0);
    return sum / n_present;
}

std::vector<std::optional<double>> recall_per_class(const Confusion& confusion) {
    std::vector<std::optional<double>> recall(confusion.n);
    for (std::size_t c = 0; c < confusion.n; ++c) {
        const std::int64_t n = n_true(confusion, c);
        if (n > 0) recall[c] = static_cast<double>(confusion.at(c, c)) / static_cast<double>(n);
    }
    return recall;
}

WorstDomain worst_domain(std::span<const double> macro_f1_per_domain) {
    SPECULA_EXPECT(!macro_f1_per_domain.empty());
    const auto worst = std::ranges::min_element(macro_f1_per_domain);
    return {.domain = static_cast<std::size_t>(worst - macro_f1_per_domain.begin()),
            .macro_f1 = *worst};
}

Interval bootstrap_mean(const std::vector<double>& per_world, const StreamKey& key) {
    SPECULA_EXPECT(!per_world.empty());
    const double mean = mean_of(per_world);
    if (per_world.size() == 1) return {.mean = mean, .low = mean, .high = mean};
    constexpr std::size_t n_resamples = 10'000;
    constexpr std::size_t n_beyond = n_resamples / 40;  // 2.5 % on either side
    Stream stream(key);
    std::vector<double> means(n_resamples);
    std::vector<double> resample(per_world.size());
    for (double& resampled_mean : means) {
        for (double& value : resample)
            value = per_world[stream.below(static_cast<std::uint32_t>(per_world.size()))];
        resampled_mean = mean_of(resample);
    }
    std::ranges::sort(means);
    return {.mean = mean, .low = means[n_beyond], .high = means[n_resamples - 1 - n_beyond]};
}

Interval bootstrap_share(const std::vector<double>& parts, const std::vector<double>& wholes,
                         const StreamKey& key) {
    SPECULA_EXPECT(!parts.empty() && parts.size() == wholes.size());
    const double whole = std::accumulate(wholes.begin(), wholes.end(), 0.0);
    SPECULA_EXPECT(whole > 0.0);
    const double share = std::accumulate(parts.begin(), parts.end(), 0.0) / whole;
    constexpr std::size_t n_resamples = 10'000;
    Stream stream(key);
    std::vector<double> shares;
    for (std::size_t k = 0; k < n_resamples; ++k) {
        double part = 0.0, all = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto world = stream.below(static_cast<std::uint32_t>(parts.size()));
            part += parts[world];
            all += wholes[world];
        }
        if (all > 0.0) shares.push_back(part / all);
    }
    std::ranges::sort(shares);
    const std::size_t n_beyond = shares.size() / 40;  // 2.5 % on either side
    return {.mean = share,
            .low = shares[n_beyond],
            .high = shares[shares.size() - 1 - n_beyond]};
}

}  // namespace specula
