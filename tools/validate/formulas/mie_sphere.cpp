#include "tools/validate/formulas/mie_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace specula {

namespace {

/// Terms after which the series no longer changes (Wiscombe 1980, with a margin).
int terms_for(double ka) {
    return static_cast<int>(std::ceil(ka + 4.05 * std::cbrt(ka) + 8.0));
}

/// psi_n'(z) / psi_n(z) for n = 0 .. n_terms, psi_n(z) = z j_n(z), by downward recurrence from so
/// high an order that what it begins with is forgotten, by exp(-(order - |z|)^1.5 / |z|^0.5).
template <typename Number>
std::vector<Number> log_derivatives(Number z, int n_terms) {
    const double size = std::abs(z);
    const int start =
        std::max(n_terms, static_cast<int>(std::ceil(size))) + 32 +
        static_cast<int>(std::ceil(6.0 * std::cbrt(size)));
    std::vector<Number> result(static_cast<std::size_t>(n_terms) + 1);
    Number derivative = 0.0;
    for (int n = start; n >= 0; --n) {  // derivative is that of order n
        if (n <= n_terms) result[static_cast<std::size_t>(n)] = derivative;
        const Number ratio = static_cast<double>(n) / z;
        derivative = ratio - 1.0 / (derivative + ratio);
    }
    return result;
}

/// psi_n and chi_n of the circumference, for each order in turn.
///
/// psi upward by its recurrence while it oscillates, n <= ka; from there on, where that would lose
/// it and it has no zero, by its logarithmic derivative.
class RiccatiBessel {
  public:
    explicit RiccatiBessel(double ka) : ka_(ka), derivative_(log_derivatives(ka, terms_for(ka))) {}

    /// To the next order, the first time to order 1.
    void advance() {
        ++n_;
        const double twice = (2.0 * n_ - 1.0) / ka_;
        const double psi = n_ <= ka_ ? twice * psi_ - previous_psi_
                                     : psi_ / (n_ / ka_ + derivative_[static_cast<std::size_t>(n_)]);
        const double chi = twice * chi_ - previous_chi_;
        previous_psi_ = psi_;
        previous_chi_ = chi_;
        psi_ = psi;
        chi_ = chi;
    }
    double psi() const { return psi_; }
    double psi_derivative() const { return previous_psi_ - n_ / ka_ * psi_; }
    /// The wave that leaves, for the books' time exp(-iwt).
    Complex leaving() const { return {psi_, -chi_}; }
    Complex leaving_derivative() const {
        return {psi_derivative(), -(previous_chi_ - n_ / ka_ * chi_)};
    }

  private:
    double ka_;
    std::vector<double> derivative_;
    int n_ = 0;
    double psi_ = std::sin(ka_), previous_psi_ = std::cos(ka_);
    double chi_ = std::cos(ka_), previous_chi_ = -std::sin(ka_);
};

/// |Sum (-1)^n (2n + 1) (a_n - b_n)|^2 / ka^2, the terms from `difference(n, functions)`.
template <typename Difference>
double backscatter(double ka, const Difference& difference) {
    RiccatiBessel functions(ka);
    Complex sum = 0.0;
    for (int n = 1; n <= terms_for(ka); ++n) {
        functions.advance();
        const double sign = n % 2 == 0 ? 1.0 : -1.0;
        sum += sign * (2.0 * n + 1.0) * difference(n, functions);
    }
    return std::norm(sum) / (ka * ka);
}

}  // namespace

double conducting_sphere_backscatter(double ka) {
    return backscatter(ka, [](int, const RiccatiBessel& f) {
        return f.psi_derivative() / f.leaving_derivative() - f.psi() / f.leaving();
    });
}

double dielectric_sphere_backscatter(const DielectricSphere& sphere) {
    const Complex m = std::conj(sphere.refractive_index);  // the books' time is exp(-iwt)
    const auto inside = log_derivatives(sphere.ka * m, terms_for(sphere.ka));
    return backscatter(sphere.ka, [&](int n, const RiccatiBessel& f) {
        const Complex d = inside[static_cast<std::size_t>(n)];
        const auto coefficient = [&](Complex impedance) {
            return (impedance * f.psi() - f.psi_derivative()) /
                   (impedance * f.leaving() - f.leaving_derivative());
        };
        return coefficient(d / m) - coefficient(d * m);
    });
}

}  // namespace specula
