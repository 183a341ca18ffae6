#include <algorithm>
#include <cstdio>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/limits.hpp"
#include "tools/console/console.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/progress.hpp"
#include "tools/sweep/sweep.hpp"
#include "tools/sweep/sweep_figures.hpp"
#include "tools/sweep/sweep_table.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_lines = 40;

fs::path sweep_file(const std::string& wanted, const Catalogue& catalogue) {
    if (fs::path(wanted).extension() == ".toml") return wanted;
    const auto names = catalogue.sweep_names();
    if (std::find(names.begin(), names.end(), wanted) == names.end()) {
        const std::string near = nearest_word(wanted, names);
        throw InputError(format("\"{}\": no such sweep; {}use {} or a .toml file of a scene",
                                wanted, near.empty() ? "" : "did you mean " + near + "? ",
                                quoted_list(names)));
    }
    return catalogue.sweep_file(wanted);
}

/// The frequencies at which the sweep asks the materials.
FrequencyBand used_band(const SweepPlan& plan) {
    if (plan.frequencies_hz.empty()) return plan.scene.radar.chirp.band();
    return {plan.frequencies_hz.front(), plan.frequencies_hz.back()};
}

void warn(const SweepPlan& plan, const Library& materials) {
    std::vector<std::string> said;
    const auto say = [&](const std::string& text) {
        if (std::find(said.begin(), said.end(), text) != said.end()) return;
        said.push_back(text);
        say_warning(text);
    };
    const FrequencyBand used = used_band(plan);
    Scene scene = plan.scene;
    for (const std::string& warning : plan.scene.warnings) say(warning);
    for (const Specimen& specimen : plan.specimens) {
        scene.sample = specimen.sample;
        for (const auto& [size_x_m, size_y_m] : plan.sizes_m) {
            scene.sample.face.size_x_m = size_x_m;
            scene.sample.face.size_y_m = size_y_m;
            for (const std::string& limit : optics_limits(scene, materials))
                say(specimen.label + ": " + limit);
        }
        for (const BandWarning& warning : band_warnings(specimen.sample, materials, used))
            say(warning.text());
        if (plan.scene.solver.roughness == Solver::Roughness::coherent) continue;
        for (const std::string& warning : roughness_warnings(specimen.sample, used))
            say(specimen.label + ": " + warning);
    }
}

/// What the levels of one specimen, size and tilting run through.
void print_ranges(const Sweep& sweep) {
    const SweepPlan& plan = sweep.plan;
    std::printf("%-28s %-14s %-28s %22s %22s\n", "", "", "", "over a mirror, dB",
                "over untilted, dB");
    const std::size_t n_each = plan.heights_m.size() * plan.tilts_rad.size() * plan.n_frequencies();
    for (std::size_t first = 0; first < sweep.rows.size(); first += n_each) {
        if (first / n_each == most_lines) {
            std::printf("... and %zu more\n", sweep.rows.size() / n_each - most_lines);
            return;
        }
        const auto begin = sweep.rows.begin() + static_cast<std::ptrdiff_t>(first);
        const auto range = [&](double SweepRow::*level) {
            const auto [low, high] = std::minmax_element(
                begin, begin + static_cast<std::ptrdiff_t>(n_each),
                [&](const SweepRow& a, const SweepRow& b) { return a.*level < b.*level; });
            return format("{:7.2f} to {:7.2f}", (*low).*level, (*high).*level);
        };
        const SweepIndex& at = begin->at;
        const auto& size_m = plan.sizes_m[at.size];
        std::printf("%-28s %-14s %-28s %22s %22s\n", plan.specimens[at.specimen].label.c_str(),
                    format("{:g} x {:g} mm", size_m[0] * 1e3, size_m[1] * 1e3).c_str(),
                    plan.tilts_rad.size() > 1 ? plan.tiltings[at.tilting].title().c_str() : "",
                    range(&SweepRow::over_mirror_db).c_str(),
                    range(&SweepRow::over_untilted_db).c_str());
    }
}

}  // namespace

void sweep_command(const SweepArguments& arguments, const Catalogue& catalogue) {
    const SweepPlan plan =
        read_sweep_plan(sweep_file(arguments.what, catalogue), arguments.axes, catalogue);
    const fs::path out = arguments.out.empty() ? fs::path("out/sweep") / plan.name : arguments.out;
    make_output_folder(out);
    warn(plan, catalogue.materials);
    Sweep sweep;
    {
        Progress progress("Sweeping", "geometries", n_traces(plan));
        sweep = run_sweep(plan, catalogue.materials, arguments.threads, progress.done());
    }
    const SweepFigures drawn = sweep_figures(sweep);
    std::vector<Drawing> drawings;
    for (const Figure& figure : drawn.figures) drawings.push_back(render_figure(figure));

    write_file_atomically(out / "table.csv", sweep_csv(sweep));
    write_sweep_hdf5(out / "table.h5", sweep);
    std::string written = "table.csv, table.h5";
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        write_figure(out, drawn.figures[i], drawings[i]);
        written += ", " + drawn.figures[i].name + ".svg, .png and .csv";
    }
    print_ranges(sweep);
    const auto n_weak = std::count_if(sweep.rows.begin(), sweep.rows.end(),
                                      [](const SweepRow& row) { return row.is_weak; });
    if (n_weak > 0)
        say_warning(
            format("{} of {} levels (is_weak in the table) lie 15 dB or more below a wide "
                   "sheet's; there optics may be off by 1.5 dB",
                   n_weak, sweep.rows.size()));
    for (const std::string& remark : drawn.remarks)
        std::printf("%s; the table has them all\n", remark.c_str());
    std::printf("\n%zu rows. Wrote %s in %s\n", sweep.rows.size(), written.c_str(), out.c_str());
}

}  // namespace specula
