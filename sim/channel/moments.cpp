#include "sim/channel/moments.hpp"

#include <algorithm>

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
          polynomial_(n_p_),
          turns_(n_f_),
          waves_(points_at_once * n_columns_),
          weights_(points_at_once * n_rows()),
          sums_(n_rows() * n_columns_) {
        for (std::size_t q = 0; q < n_f_; ++q)
            turns_per_m_.push_back(grid.frequency_hz.node(static_cast<int>(q)) /
                                   speed_of_light_m_s);
    }

    void add(std::size_t first, std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) fill(first + i, i);
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

    void fill(std::size_t point, std::size_t i) {
        const double path_m = pair_.path_m[point] - grid_.reference_path_m;
        const double phase_turns = pair_.phase_at(point) / two_pi;
        for (std::size_t q = 0; q < n_f_; ++q) turns_[q] = phase_turns - turns_per_m_[q] * path_m;
        double* wave = &waves_[i * n_columns_];
        kernels().turn(turns_.data(), n_f_, wave, wave + n_f_);
        chebyshev_polynomials(grid_.cos_incidence.unit(pair_.cos_incidence[point]), polynomial_);
        double* weight = &weights_[i * n_rows()];
        weight[0] = pair_.weight[0][point];
        for (std::size_t p = 0; p < n_p_; ++p) {
            weight[1 + p] = pair_.weight[1][point] * polynomial_[p];
            weight[1 + n_p_ + p] = pair_.weight[2][point] * polynomial_[p];
        }
    }

    const PairScatter& pair_;
    const MomentGrid& grid_;
    std::size_t n_f_, n_p_, n_columns_;
    std::vector<double> turns_per_m_, polynomial_, turns_, waves_, weights_, sums_;
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
