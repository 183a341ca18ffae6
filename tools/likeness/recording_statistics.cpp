#include "tools/likeness/recording_statistics.hpp"

#include <cmath>
#include <complex>

#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

std::vector<double> blackman(std::size_t n) {
    std::vector<double> window(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double turn = two_pi * static_cast<double>(i) / static_cast<double>(n - 1);
        window[i] = 0.42 - 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
    }
    return window;
}

/// The bins of a plain transform, 0 to n/2 - 1, by a table of one turn. A few thousand chirps of
/// 256 samples take a second; no library's worth.
class Transform {
  public:
    explicit Transform(std::size_t n) : turn_(n) {
        for (std::size_t i = 0; i < n; ++i)
            turn_[i] = std::polar(1.0, -two_pi * static_cast<double>(i) / static_cast<double>(n));
    }
    double magnitude(const std::vector<double>& values, std::size_t bin) const {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i)
            sum += values[i] * turn_[i * bin % turn_.size()];
        return std::abs(sum);
    }

  private:
    std::vector<std::complex<double>> turn_;
};

}  // namespace

std::size_t ChirpSeries::n_chirps() const {
    return codes.size() / static_cast<std::size_t>(n_rx * n_samples);
}

const std::int16_t* ChirpSeries::chirp(std::size_t i, int rx) const {
    return &codes[(i * static_cast<std::size_t>(n_rx) + static_cast<std::size_t>(rx)) *
                  static_cast<std::size_t>(n_samples)];
}

ChirpSeries ChirpSeries::part(std::size_t first, std::size_t last) const {
    const auto step = static_cast<std::ptrdiff_t>(n_rx * n_samples);
    return {n_rx,
            n_samples,
            {codes.begin() + static_cast<std::ptrdiff_t>(first) * step,
             codes.begin() + static_cast<std::ptrdiff_t>(last) * step}};
}

std::vector<double> ChirpSeries::mean_chirp(int rx) const {
    std::vector<double> mean(static_cast<std::size_t>(n_samples));
    for (std::size_t i = 0; i < n_chirps(); ++i)
        for (std::size_t n = 0; n < mean.size(); ++n) mean[n] += chirp(i, rx)[n];
    for (double& value : mean) value /= static_cast<double>(n_chirps());
    return mean;
}

ChirpSeries ChirpSeries::read(const std::filesystem::path& file) {
    const Dataset dataset = read_dataset(file);
    if (dataset.n_samples == 0)
        throw InputError(file.string() + ": holds no ADC codes; import the raw recording");
    return {dataset.n_rx, dataset.n_samples, dataset.adc};
}

std::vector<double> noise_per_bin_lsb(const ChirpSeries& series, int rx, int first) {
    SPECULA_EXPECT(series.n_chirps() >= 3);
    const auto begin = static_cast<std::size_t>(first);
    const auto n = static_cast<std::size_t>(series.n_samples) - begin;
    const auto window = blackman(n);
    const Transform transform(n);
    // Bins of the whole chirp, so that they mean the same whatever is left out.
    const auto n_bins = static_cast<std::size_t>(series.n_samples / 2);
    std::vector<double> power(n_bins), rest(n);
    double window_power = 0.0;
    for (const double w : window) window_power += w * w;
    const std::size_t n_triples = series.n_chirps() - 2;
    for (std::size_t i = 0; i < n_triples; ++i) {
        const auto *a = series.chirp(i, rx), *b = series.chirp(i + 1, rx),
                   *c = series.chirp(i + 2, rx);
        for (std::size_t k = 0; k < n; ++k)
            rest[k] = window[k] * (a[begin + k] - 2.0 * b[begin + k] + c[begin + k]);
        for (std::size_t bin = 0; bin < n_bins; ++bin) {
            const auto nearest = static_cast<std::size_t>(
                std::lround(static_cast<double>(bin * n) / series.n_samples));
            power[bin] += std::pow(transform.magnitude(rest, nearest), 2);
        }
    }
    for (double& value : power)  // 1 + 4 + 1 variances in each difference
        value = std::sqrt(value / (6.0 * window_power * static_cast<double>(n_triples)));
    return power;
}

std::vector<double> amplitude_spectrum_lsb(const std::vector<double>& chirp) {
    const auto window = blackman(chirp.size());
    const Transform transform(chirp.size());
    std::vector<double> windowed(chirp.size()), spectrum;
    double sum = 0.0;
    for (std::size_t i = 0; i < chirp.size(); ++i) {
        windowed[i] = window[i] * chirp[i];
        sum += window[i];
    }
    for (std::size_t bin = 0; bin < chirp.size() / 2; ++bin)
        spectrum.push_back((bin == 0 ? 1.0 : 2.0) / sum * transform.magnitude(windowed, bin));
    return spectrum;
}

std::vector<double> mean_spectrum_lsb(const ChirpSeries& series, int rx) {
    std::vector<double> mean(static_cast<std::size_t>(series.n_samples / 2));
    for (std::size_t i = 0; i < series.n_chirps(); ++i) {
        const std::int16_t* codes = series.chirp(i, rx);
        const auto spectrum =
            amplitude_spectrum_lsb(std::vector<double>(codes, codes + series.n_samples));
        for (std::size_t bin = 0; bin < mean.size(); ++bin) mean[bin] += spectrum[bin];
    }
    for (double& value : mean) value /= static_cast<double>(series.n_chirps());
    return mean;
}

int first_settled_sample(const Chirp& chirp) {
    const int before = std::max(0, -chirp.settle_samples());
    if (before == 0) return 0;
    return before + static_cast<int>(std::ceil(chirp.tx_on_s * chirp.sample_rate_hz)) + 9;
}

}  // namespace specula
