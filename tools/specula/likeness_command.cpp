#include <algorithm>
#include <cstdio>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/likeness/likeness.hpp"
#include "tools/likeness/likeness_figure.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

void check_fits(const LikenessArguments& arguments, const ChirpSeries& series, const Radar& radar) {
    if (series.n_rx == static_cast<int>(radar.rx.size()) &&
        series.n_samples == radar.chirp.n_samples && radar.n_tx() == 1 && series.n_chirps() >= 8)
        return;
    throw InputError(
        format("{}: has {} RX, {} samples and {} chirps; give the radar that it was made "
               "with (one TX) and 8 chirps or more",
               arguments.recording.string(), series.n_rx, series.n_samples, series.n_chirps()));
}

Likeness compared(const ChirpSeries& series, const Radar& radar, std::uint64_t seed) {
    Progress progress("Comparing", "RX", radar.rx.size());  // ends its line when done
    return compare_with_recording(series, radar, seed, &progress.done());
}

std::string verdict_of(const LikenessRow& row) {
    return row.is_alike() ? "" : row.reason.empty() ? "unexplained" : row.reason;
}

std::string table_csv(const Likeness& likeness) {
    CsvTable table({"quantity", "rx", "unit", "recorded", "simulated", "alike", "reason"});
    for (const LikenessRow& row : likeness.rows)
        table.add({row.quantity, format("{}", row.rx), row.unit, format("{:.6g}", row.recorded),
                   format("{:.6g}", row.simulated), row.is_alike() ? "yes" : "no",
                   verdict_of(row)});
    return table.text();
}

void print_table(const Likeness& likeness) {
    std::vector<std::string> reasons;
    std::size_t alike = 0, unexplained = 0;
    std::printf("%-52s %-8s %3s %10s %10s\n", "", "", "RX", "recorded", "simulated");
    for (const LikenessRow& row : likeness.rows) {
        std::string note;
        if (row.is_alike()) {
            ++alike;
        } else if (row.reason.empty()) {
            ++unexplained;
            note = "  unexplained";
        } else {
            auto known = std::find(reasons.begin(), reasons.end(), row.reason);
            if (known == reasons.end()) known = reasons.insert(reasons.end(), row.reason);
            note = format("  ({})", known - reasons.begin() + 1);
        }
        std::printf("%-52s %-8s %3d %10.4g %10.4g%s\n", row.quantity.c_str(), row.unit.c_str(),
                    row.rx, row.recorded, row.simulated, note.c_str());
    }
    std::printf("\n%zu of %zu within 20 %% or one code, %zu explained below, %zu unexplained\n",
                alike, likeness.rows.size(), likeness.rows.size() - alike - unexplained,
                unexplained);
    for (std::size_t i = 0; i < reasons.size(); ++i)
        std::printf("(%zu) %s\n", i + 1, reasons[i].c_str());
}

}  // namespace

void likeness_command(const LikenessArguments& arguments, const Catalogue& catalogue) {
    const ChirpSeries series = ChirpSeries::read(arguments.recording);
    const Radar radar = catalogue.radar_called(arguments.radar);
    check_fits(arguments, series, radar);
    const Likeness likeness = compared(series, radar, arguments.seed);
    const fs::path out = arguments.out.empty() ? fs::path("out/likeness") : arguments.out;
    write_figure(out, likeness_figure(likeness, radar.name + " beside a recording"));
    write_file_atomically(out / "likeness_table.csv", table_csv(likeness));
    print_table(likeness);
    std::printf("Wrote %s.svg, .png, .csv and likeness_table.csv\n", (out / "likeness").c_str());
}

}  // namespace specula
