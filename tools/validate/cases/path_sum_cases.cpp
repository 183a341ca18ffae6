#include "sim/channel/path.hpp"
#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

std::vector<Quantity> path_sum_point(const CasePoint& point) {
    const int n = point.inp.count("N", Range::between(1, most_samples));
    const double first_hz = point.inp.number("f0_hz", Range::above(0.0));
    const FrequencyComb comb{.first_hz = first_hz, .step_hz = point.inp.number("B_hz") / n, .n = n};
    const auto delay_s = point.inp.numbers("tau_s");
    const auto real = point.inp.numbers("amp_re"), imaginary = point.inp.numbers("amp_im");
    for (const char* name : {"amp_re", "amp_im"})
        if (point.inp.numbers(name).size() != delay_s.size())
            point.inp.fail(name, "not as long as tau_s", "give one amplitude for each delay");
    Channel channel = silent_channel(1, comb);
    for (std::size_t i = 0; i < delay_s.size(); ++i)
        add_path(channel, comb,
                 {.rx = 0,
                  .length_m = delay_s[i] * speed_of_light_m_s,
                  .transfer = {real[i], imaginary[i]}});
    Comparison compare(point);
    compare.whole({"h_re", "h_im"}, channel.h, "rel_l2");
    return compare.finish();
}

}  // namespace specula
