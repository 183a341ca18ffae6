#include "sim/channel/moments.hpp"

#include <algorithm>
#include <array>

#include "sim/core/constants.hpp"
#include "sim/core/kernels.hpp"

namespace specula {

namespace {

/// Points that are worked on together; their numbers stay in the first-level cache.
constexpr std::size_t points_at_once = 32;

/// Numbers of a block of points: waves (point; real parts, imaginary parts) and what they are
/// multiplied with (point; incident, te by polynomial, tm by polynomial).
class Block {
  public:
    Block(const PairScatter& pair, const MomentGrid& grid)
        : pair_(pair),
          grid_(grid),
          n_f_(static_cast<std::size_t>(grid.frequency_hz.n)),
          n_p_(static_cast<std::size_t>(grid.cos_incidence.n)),
          n_columns_(Kernels::padded(2 * n_f_)),
          middle_turns_per_m_(0.5 * (grid.frequency_hz.low + grid.frequency_hz.high) /
                              speed_of_light_m_s),
          polynomial_(n_p_),
          waves_(points_at_once * n_columns_),
          weights_(points_at_once * n_rows()),
          sums_(n_rows() * n_columns_) {
        for (std::size_t q = 0; 2 * q < n_f_; ++q)
            turns_per_m_.push_back(grid.frequency_hz.node(static_cast<int>(q)) /
                                       speed_of_light_m_s -
                                   middle_turns_per_m_);
        const std::size_t most = points_at_once * std::max<std::size_t>(1, turns_per_m_.size());
        for (auto* numbers : {&turns_, &cosine_, &sine_}) numbers->resize(most);
    }

    void add(std::size_t first, std::size_t n) {
        fill_middle(first, n);
        fill_waves(first, n);
        for (std::size_t i = 0; i < n; ++i) fill_weights(first + i, &weights_[i * n_rows()]);
        kernels().add_products({n, n_rows(), n_columns_}, weights_.data(), waves_.data(),
                               sums_.data());
    }

    /// Sums of some rows, (row, frequency).
    std::vector<std::complex<double>> sums(std::size_t first_row, std::size_t n) const {
        std::vector<std::complex<double>> values(n * n_f_);
        for (std::size_t row = 0; row < n; ++row) {
            const double* sum = &sums_[(first_row + row) * n_columns_];
            for (std::size_t q = 0; q < n_f_; ++q) values[row * n_f_ + q] = {sum[q], sum[n_f_ + q]};
        }
        return values;
    }

  private:
    std::size_t n_rows() const { return 1 + 2 * n_p_; }

    /// Waves at the middle of the interval of frequencies.
    void fill_middle(std::size_t first, std::size_t n) {
        const double turns_per_m = pair_.centre_rad_m / two_pi - middle_turns_per_m_;
        for (std::size_t i = 0; i < n; ++i)
            turns_[i] = turns_per_m * (pair_.path_m[first + i] - grid_.reference_path_m);
        kernels().turn(turns_.data(), n, cosine_.data(), sine_.data());
        for (std::size_t i = 0; i < n; ++i) {
            const std::complex<double> wave(cosine_[i], sine_[i]);
            middle_[i] = pair_.factor.empty() ? wave : pair_.factor[first + i] * wave;
        }
    }

    /// From there to the nodes, which lie in pairs on both sides of it.
    void fill_waves(std::size_t first, std::size_t n) {
        const std::size_t n_turns = turns_per_m_.size();
        for (std::size_t i = 0; i < n; ++i) {
            const double path_m = pair_.path_m[first + i] - grid_.reference_path_m;
            for (std::size_t q = 0; q < n_turns; ++q)
                turns_[i * n_turns + q] = turns_per_m_[q] * path_m;
        }
        kernels().turn(turns_.data(), n * n_turns, cosine_.data(), sine_.data());
        for (std::size_t i = 0; i < n; ++i) {
            const double middle_re = middle_[i].real(), middle_im = middle_[i].imag();
            const double *cosine = &cosine_[i * n_turns], *sine = &sine_[i * n_turns];
            double* re = &waves_[i * n_columns_];
            double* im = re + n_f_;
            for (std::size_t q = 0; q < n_turns; ++q) {
                const double a = middle_re * cosine[q], b = middle_im * sine[q];
                const double c = middle_im * cosine[q], d = middle_re * sine[q];
                re[q] = a + b;
                im[q] = c - d;
                re[n_f_ - 1 - q] = a - b;
                im[n_f_ - 1 - q] = c + d;
            }
        }
    }

    void fill_weights(std::size_t point, double* weight) {
        chebyshev_polynomials(grid_.cos_incidence.unit(pair_.cos_incidence[point]), polynomial_);
        weight[0] = pair_.weight[0][point];
        for (std::size_t p = 0; p < n_p_; ++p) {
            weight[1 + p] = pair_.weight[1][point] * polynomial_[p];
            weight[1 + n_p_ + p] = pair_.weight[2][point] * polynomial_[p];
        }
    }

    const PairScatter& pair_;
    const MomentGrid& grid_;
    std::size_t n_f_, n_p_, n_columns_;
    double middle_turns_per_m_;
    std::vector<double> turns_per_m_;  ///< of one half of the nodes, from the middle
    std::array<std::complex<double>, points_at_once> middle_;
    std::vector<double> turns_, cosine_, sine_, polynomial_, waves_, weights_, sums_;
};

}  // namespace

Moments moments_of(const PairScatter& pair, const MomentGrid& grid) {
    const auto n_p = static_cast<std::size_t>(grid.cos_incidence.n);
    Block block(pair, grid);
    for (std::size_t first = 0; first < pair.path_m.size(); first += points_at_once)
        block.add(first, std::min(points_at_once, pair.path_m.size() - first));
    return {block.sums(0, 1), block.sums(1, n_p), block.sums(1 + n_p, n_p)};
}

}  // namespace specula
