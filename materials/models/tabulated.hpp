#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "materials/electrics.hpp"
#include "sim/core/document.hpp"
#include "sim/core/format.hpp"

namespace specula {

/// A measured table, read off by straight lines in eps' and eps''. Outside the table the nearest
/// row holds, and the file's band says that this is no measurement any more.
/// @eq PHYSICS.md#tabulated
struct Tabulated {
    static constexpr std::string_view kind = "tabulated";
    std::vector<double> frequency_hz;  ///< rising, two at least
    std::vector<Complex> permittivity;

    Electrics at(double f_hz) const {
        const auto above = std::upper_bound(frequency_hz.begin(), frequency_hz.end(), f_hz);
        if (above == frequency_hz.begin()) return {permittivity.front(), 1.0};
        if (above == frequency_hz.end()) return {permittivity.back(), 1.0};
        const auto i = static_cast<std::size_t>(above - frequency_hz.begin());
        const double part = (f_hz - frequency_hz[i - 1]) / (frequency_hz[i] - frequency_hz[i - 1]);
        return {permittivity[i - 1] + part * (permittivity[i] - permittivity[i - 1]), 1.0};
    }

    /// Keys: frequency_ghz (rising), permittivity >= 1 and loss_tangent >= 0, lists of one length;
    /// `valid_ghz` of the file must not reach beyond them.
    static Tabulated read(Section& section) {
        Tabulated model{
            .frequency_hz = section.quantities("frequency", Unit::frequency, 0, Range::above(0.0)),
            .permittivity = {}};
        const auto& f_hz = model.frequency_hz;
        if (f_hz.size() < 2 || !std::is_sorted(f_hz.begin(), f_hz.end(), std::less_equal<>()))
            section.fail_quantity("frequency", Unit::frequency, "is not a rising list",
                                  "give two frequencies at least, the lowest first");
        const auto real = section.numbers("permittivity", f_hz.size(), Range::at_least(1.0));
        const auto loss = section.numbers("loss_tangent", f_hz.size(), Range::between(0.0, 10.0));
        for (std::size_t i = 0; i < f_hz.size(); ++i)
            model.permittivity.emplace_back(real[i], -real[i] * loss[i]);
        if (section.has_quantity("valid", Unit::frequency)) {
            const auto valid = section.quantities("valid", Unit::frequency, 2, Range::above(0.0));
            if (valid[0] < f_hz.front() || valid[1] > f_hz.back())
                section.fail_quantity("valid", Unit::frequency, "reaches beyond the table",
                                      format("stay within {:.6g} to {:.6g} GHz",
                                             f_hz.front() * 1e-9, f_hz.back() * 1e-9));
        }
        return model;
    }
};

}  // namespace specula
