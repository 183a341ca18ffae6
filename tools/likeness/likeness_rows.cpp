#include "tools/likeness/likeness_rows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double alike = 0.2;
constexpr std::size_t quiet_bin = 8, quiet_end = 15, leakage_end = 7;

double root_mean_square(const std::vector<double>& values, std::size_t first, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += values[i] * values[i];
    return std::sqrt(sum / static_cast<double>(end - first));
}

/// The mean in decibels: what most bins hold, whatever one of them does.
double geometric_mean(const std::vector<double>& values, std::size_t first, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += std::log(std::max(values[i], 1e-3));
    return std::exp(sum / static_cast<double>(end - first));
}

double quiet_noise(const Portrait& p) {
    return root_mean_square(p.noise, quiet_bin, quiet_end);
}

double slope(const Portrait& p) {
    return root_mean_square(p.noise, 2, 5) / quiet_noise(p);
}

double percentile(const Portrait& p, int percent) {
    return p.codes[p.codes.size() * static_cast<std::size_t>(percent) / 100];
}

double span(const Portrait& p) {
    return percentile(p, 95) - percentile(p, 5);
}

/// Why a number may differ, and whether the chirps show that it is so.
struct Cause {
    const char* text;
    std::function<bool(double recorded, double simulated)> shows;
};

/// Writes rows of one RX, each a function of both portraits.
class RowWriter {
  public:
    RowWriter(std::vector<LikenessRow>& rows, int rx, const Portrait& recorded,
              const Portrait& simulated)
        : rows_(rows), rx_(rx), recorded_(recorded), simulated_(simulated) {}

    template <typename Measure>
    void add(const std::string& quantity, const char* unit, const Cause& cause,
             const Measure& measure) {
        LikenessRow row{quantity, unit, rx_, measure(recorded_), measure(simulated_), ""};
        if (!row.is_alike() && cause.shows(row.recorded, row.simulated)) row.reason = cause.text;
        rows_.push_back(row);
    }

  private:
    std::vector<LikenessRow>& rows_;
    int rx_;
    const Portrait& recorded_;
    const Portrait& simulated_;
};

struct Pair {
    const Portrait& recorded;
    const Portrait& simulated;
};

void add_noise(RowWriter& writer, double mean_recorded_lsb) {
    const Cause one_figure{
        "One noise figure serves all RX: their mean is met, this one differs from it.",
        [=](double, double simulated) {
            return std::abs(simulated - mean_recorded_lsb) <= alike * mean_recorded_lsb;
        }};
    writer.add("noise, bins 8 to 14", "LSB rms", one_figure, quiet_noise);
    const Cause not_white{
        "The recording's noise falls towards bin 0 more than the high-pass makes white noise fall.",
        [](double recorded, double simulated) { return recorded < simulated; }};
    writer.add("high-pass slope: noise of bins 2 to 4 over 8 to 14", "", not_white, slope);
}

void add_leakage(RowWriter& writer, const Pair& pair) {
    const double largest = *std::max_element(pair.recorded.leakage.begin(),
                                             pair.recorded.leakage.begin() + leakage_end);
    const Cause few_tones{
        "A few tones per RX stand for all coupling of board and package; the difference is below a "
        "tenth of the largest leakage bin.",
        [=](double recorded, double simulated) {
            return std::abs(simulated - recorded) < 0.1 * largest;
        }};
    for (std::size_t bin = 0; bin < leakage_end; ++bin)
        writer.add(format("leakage, bin {}", bin), "LSB", few_tones,
                   [&](const Portrait& p) { return p.leakage[bin]; });
}

void add_start_up(RowWriter& writer, const Radar& radar, int rx) {
    const double pulse_lsb = std::abs(radar.rx[static_cast<std::size_t>(rx)].start_up_lsb);
    const Cause soft_edge{
        "The decimation filter is taken for a tapered sinc; the difference is below a fifth of the "
        "start-up pulse.",
        [=](double recorded, double simulated) {
            return std::abs(simulated - recorded) < 0.2 * pulse_lsb;
        }};
    const int before = std::max(0, -radar.chirp.settle_samples());
    for (int n = 0; n <= before; ++n)
        writer.add(format("start-up, sample {}", n), "LSB", soft_edge,
                   [&](const Portrait& p) { return p.mean_chirp[static_cast<std::size_t>(n)]; });
}

void add_histogram(RowWriter& writer, const Pair& pair) {
    const double span_lsb = span(pair.recorded);
    const Cause near_zero{
        "A number near zero: the difference is below a twentieth of what 90 % of the codes span.",
        [=](double recorded, double simulated) {
            return std::abs(recorded) < 0.1 * span_lsb &&
                   std::abs(simulated - recorded) < 0.05 * span_lsb;
        }};
    writer.add("mean code (DC)", "LSB", near_zero, [](const Portrait& p) {
        double sum = 0.0;
        for (const double code : p.codes) sum += code;
        return sum / static_cast<double>(p.codes.size());
    });
    for (const int percent : {5, 25, 50, 75, 95})
        writer.add(format("amplitude histogram, {} % below", percent), "LSB", near_zero,
                   [&](const Portrait& p) { return percentile(p, percent); });
}

void add_spectrum(RowWriter& writer, const Pair& pair, const Radar& radar) {
    const auto last = std::min(
        static_cast<std::size_t>(radar.chirp.pass_band * radar.chirp.n_samples),
        pair.recorded.mean_spectrum.size());
    constexpr std::size_t starts[] = {7, 15, 31, 61};
    for (std::size_t i = 0; i < std::size(starts) && starts[i] < last; ++i) {
        const std::size_t first = starts[i];
        const std::size_t end = i + 1 < std::size(starts) ? std::min(starts[i + 1], last) : last;
        const Cause moving{
            "The recorded scene moves: the simulated room stands still as it was in one chirp, and "
            "holds what that chirp does.",
            [&pair, first, end](double, double simulated) {
                const double then = geometric_mean(pair.recorded.room_chirp, first, end);
                return std::abs(simulated - then) <= alike * then;
            }};
        writer.add(format("spectrum, bins {} to {}, mean of dB", first, end - 1), "LSB", moving,
                   [=](const Portrait& p) { return geometric_mean(p.mean_spectrum, first, end); });
    }
}

}  // namespace

bool LikenessRow::is_alike() const {
    const double one_code = unit == "LSB" ? 1.0 : 0.0;
    return std::abs(simulated - recorded) <= std::max(alike * std::abs(recorded), one_code);
}

std::vector<LikenessRow> likeness_rows(const std::vector<Portrait>& recorded,
                                       const std::vector<Portrait>& simulated, const Radar& radar) {
    double mean_noise_lsb = 0.0;
    for (const Portrait& p : recorded)
        mean_noise_lsb += quiet_noise(p) / static_cast<double>(recorded.size());
    std::vector<LikenessRow> rows;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        const int rx = static_cast<int>(i);
        const Pair pair{recorded[i], simulated[i]};
        RowWriter writer(rows, rx, pair.recorded, pair.simulated);
        add_noise(writer, mean_noise_lsb);
        add_leakage(writer, pair);
        add_start_up(writer, radar, rx);
        add_histogram(writer, pair);
        add_spectrum(writer, pair, radar);
    }
    return rows;
}

}  // namespace specula
