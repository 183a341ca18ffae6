#include <cstdio>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "tools/bench/bench_figures.hpp"
#include "tools/bench/bench_text.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/progress.hpp"

namespace specula {

void bench_command(const BenchArguments& arguments, const Catalogue& catalogue) {
    BenchPlan plan{.parts = arguments.parts,
                   .budget_s = arguments.seconds,
                   .threads = arguments.threads,
                   .growth_decades = arguments.decades};
    if (!arguments.figure.empty()) {
        if (!draws_figures(plan))
            throw InputError("--figure: these parts have none; measure stages or growth too");
        make_output_folder(arguments.figure);
    }
    BenchReport report;
    {
        Progress progress("Measuring", "parts", bench_steps(plan));
        report = run_bench(plan, catalogue, progress.done());
    }
    const std::string json = bench_json(report, plan);
    std::fputs(arguments.json ? json.c_str() : bench_text(report).c_str(), stdout);
    for (const Figure& figure : bench_figures(report))
        if (!arguments.figure.empty()) write_figure(arguments.figure, figure);
}

}  // namespace specula
