#include <algorithm>
#include <cstdio>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/console/console.hpp"
#include "tools/firmware/budget_file.hpp"
#include "tools/firmware/verify_report.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/firmware_workplace.hpp"
#include "tools/specula/home.hpp"

namespace specula {

int verify_firmware_command(const VerifyRequest& request, const Catalogue& catalogue) {
    const VerifyInput input = prepare_verification(request, catalogue);
    const TemporaryWorkplace place;
    const Verification verification = verify_firmware(input, place.get());
    std::printf("%s\n", verify_report(input, verification).c_str());
    const BudgetShape shape = budget_shape_of(input);
    const auto excess =
        find_excess(verification, home_folder() / "firmware/budget.toml", shape);
    for (const Excess& each : excess)
        say_error(format("{}: {:.0f} {}, over the budget of {:.0f} in firmware/budget.toml",
                         each.what, each.spent, each.unit, each.allowed));
    const auto foreign = std::ranges::count_if(
        verification.foreign, [](const auto& symbol) { return !is_allowed_foreign(symbol); });
    if (foreign > 0)
        say_error(format("the library needs {} functions beyond memcmp, memcpy and memset (above)",
                         foreign));
    if (verification.mismatches() > 0)
        say_error(
            format("{} mismatches between builds of the same source", verification.mismatches()));
    const bool good = excess.empty() && foreign == 0 && verification.mismatches() == 0;
    std::printf("%s\n", good ? (shape != BudgetShape::none ? "0 mismatches, within every budget"
                                                           : "0 mismatches, within the budgets of "
                                                             "sizes")
                             : "FAILED");
    return good ? 0 : 1;
}

}  // namespace specula
