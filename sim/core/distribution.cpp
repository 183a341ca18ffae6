#include "sim/core/distribution.hpp"

#include <cmath>

namespace specula {

namespace {

template <typename... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <typename... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

}  // namespace

double Distribution::sample(Stream& stream) const {
    const double u = stream.uniform();
    const double z = stream.normal();
    return std::visit(
        Overloaded{
            [](const Fixed& law) { return law.value; },
            [&](const Uniform& law) { return law.low + u * (law.high - law.low); },
            [&](const Normal& law) { return law.mean + z * law.sd; },
            [&](const Factor& law) { return law.median * std::exp(z * std::log(law.ratio)); },
        },
        law_);
}

double Distribution::median() const {
    return std::visit(Overloaded{
                          [](const Fixed& law) { return law.value; },
                          [](const Uniform& law) { return 0.5 * (law.low + law.high); },
                          [](const Normal& law) { return law.mean; },
                          [](const Factor& law) { return law.median; },
                      },
                      law_);
}

double Distribution::spread() const {
    return std::visit(Overloaded{
                          [](const Fixed&) { return 0.0; },
                          [](const Uniform& law) { return (law.high - law.low) / std::sqrt(12.0); },
                          [](const Normal& law) { return law.sd; },
                          [](const Factor& law) { return std::log(law.ratio); },
                      },
                      law_);
}

}  // namespace specula
