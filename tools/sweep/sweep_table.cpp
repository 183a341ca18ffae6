#include "tools/sweep/sweep_table.hpp"

#include <functional>

#include "firmware/fw_extract.h"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {

namespace {

constexpr const char* sweep_format_name = "specula-sweep";
constexpr int sweep_format_version = 1;
constexpr std::size_t rows_per_chunk = 1 << 16;
constexpr double degrees = 180.0 / pi;

using ValueOf = std::function<double(const SweepRow&)>;

void add(std::vector<SweepColumn>& columns, const Sweep& sweep, SweepColumn column,
         const ValueOf& value_of) {
    column.values.reserve(sweep.rows.size());
    for (const SweepRow& row : sweep.rows) column.values.push_back(value_of(row));
    columns.push_back(std::move(column));
}

void add_setting(std::vector<SweepColumn>& columns, const Sweep& sweep) {
    const SweepPlan& p = sweep.plan;
    add(columns, sweep, {"thickness_mm", "mm", "of all layers of the sample together", {}},
        [&](const SweepRow& r) { return p.specimens[r.at.specimen].sample.thickness_m * 1e3; });
    add(columns, sweep, {"roughness_um", "um", "rms height of the face towards the radar", {}},
        [&](const SweepRow& r) { return p.specimens[r.at.specimen].sample.roughness_m * 1e6; });
    add(columns, sweep, {"correlation_mm", "mm", "correlation length of these heights", {}},
        [&](const SweepRow& r) { return p.specimens[r.at.specimen].sample.correlation_m * 1e3; });
    add(columns, sweep, {"size_x_mm", "mm", "length of the sample in azimuth", {}},
        [&](const SweepRow& r) { return p.sizes_m[r.at.size][0] * 1e3; });
    add(columns, sweep, {"size_y_mm", "mm", "length of the sample in elevation", {}},
        [&](const SweepRow& r) { return p.sizes_m[r.at.size][1] * 1e3; });
    add(columns, sweep, {"tilts_sensor", "1", "1: the sensor is tilted, 0: the sample", {}},
        [&](const SweepRow& r) { return p.tiltings[r.at.tilting].sensor ? 1.0 : 0.0; });
    add(columns, sweep, {"in_elevation", "1", "1: tilted in elevation, 0: in azimuth", {}},
        [&](const SweepRow& r) { return p.tiltings[r.at.tilting].elevation ? 1.0 : 0.0; });
    add(columns, sweep, {"height_mm", "mm", "phase centre over the untilted face", {}},
        [&](const SweepRow& r) { return p.heights_m[r.at.height] * 1e3; });
    add(columns, sweep, {"tilt_deg", "deg", "angle of the tilt", {}},
        [&](const SweepRow& r) { return p.tilts_rad[r.at.tilt] * degrees; });
    if (!p.frequencies_hz.empty())
        add(columns, sweep, {"frequency_ghz", "GHz", "frequency of the level", {}},
            [&](const SweepRow& r) { return p.frequencies_hz[r.at.frequency] * 1e-9; });
}

void add_levels(std::vector<SweepColumn>& columns, const Sweep& sweep) {
    const Radar& radar = sweep.plan.scene.radar;
    const std::string mean =
        sweep.plan.frequencies_hz.empty() ? ", mean over RX and chirp" : ", mean over RX";
    add(columns, sweep, {"level_db", "dB", "received over transmitted power" + mean, {}},
        [](const SweepRow& r) { return r.level_db; });
    add(columns, sweep, {"diffuse_db", "dB", "the part of it that rough faces scatter", {}},
        [](const SweepRow& r) { return r.diffuse_db; });
    add(columns, sweep, {"received_dbm", "dBm", "power at the RX port" + mean, {}},
        [&](const SweepRow& r) { return r.level_db + radar.tx_power_dbm; });
    add(columns, sweep,
        {"received_lsb", "LSB", "amplitude of a tone of that power in the ADC codes", {}},
        [&](const SweepRow& r) { return radar.amplitude_lsb(r.level_db + radar.tx_power_dbm); });
    add(columns, sweep,
        {"over_mirror_db", "dB", "level over an infinite mirror at the same height", {}},
        [](const SweepRow& r) { return r.over_mirror_db; });
    add(columns, sweep, {"over_untilted_db", "dB", "level over the same sample untilted", {}},
        [](const SweepRow& r) { return r.over_untilted_db; });
    add(columns, sweep,
        {"over_nominal_db", "dB", "level over the same untilted at the scene's height", {}},
        [](const SweepRow& r) { return r.over_nominal_db; });
}

void add_bins(std::vector<SweepColumn>& columns, const Sweep& sweep) {
    if (!sweep.plan.frequencies_hz.empty()) return;
    add(columns, sweep, {"peak_bin", "1", "range bin of the highest magnitude", {}},
        [](const SweepRow& r) { return static_cast<double>(r.peak_bin); });
    add(columns, sweep, {"centroid_bin", "1", "mean range bin, weighted by power", {}},
        [](const SweepRow& r) { return r.centroid_bin; });
    add(columns, sweep,
        {"is_weak", "1", "1: coherent echo 15 dB below a wide sheet's, up to 1.5 dB off", {}},
        [](const SweepRow& r) { return r.is_weak ? 1.0 : 0.0; });
    for (std::size_t i = 0; i < sweep.rows.front().bin_lsb.size(); ++i)
        add(columns, sweep,
            {format("bin_{:02}_lsb", FW_DEFAULT_FIRST_BIN + i),
             "LSB",
             "mean magnitude over the RX in this bin, coherent echo alone",
             {}},
            [i](const SweepRow& r) { return r.bin_lsb[i]; });
}

}  // namespace

std::vector<SweepColumn> sweep_columns(const Sweep& sweep) {
    std::vector<SweepColumn> columns;
    add_setting(columns, sweep);
    add_levels(columns, sweep);
    add_bins(columns, sweep);
    return columns;
}

std::string sweep_csv(const Sweep& sweep) {
    const std::vector<SweepColumn> columns = sweep_columns(sweep);
    std::vector<std::string> cells{"specimen"};
    for (const SweepColumn& column : columns) cells.push_back(column.name);
    CsvTable table(cells);
    for (std::size_t i = 0; i < sweep.rows.size(); ++i) {
        cells = {sweep.plan.specimens[sweep.rows[i].at.specimen].label};
        for (const SweepColumn& column : columns)
            cells.push_back(format("{:.9g}", column.values[i]));
        table.add(cells);
    }
    return table.text();
}

void write_sweep_hdf5(const std::filesystem::path& file, const Sweep& sweep) {
    Hdf5File out = Hdf5File::create(file);
    out.set_text("/", "format", sweep_format_name);
    out.set_number("/", "format_version", sweep_format_version);
    out.set_text("/", "software", "specula");
    out.set_text("/", "software_version", program_version);
    out.set_text("/", "title", sweep.plan.title);
    out.set_text("/", "radar", sweep.plan.scene.radar.name);
    out.set_text("/", "source_toml", sweep.plan.source);
    std::vector<std::string> labels;
    for (const Specimen& specimen : sweep.plan.specimens) labels.push_back(specimen.label);
    const std::size_t n = sweep.rows.size();
    std::vector<std::int32_t> specimens;
    for (const SweepRow& row : sweep.rows)
        specimens.push_back(static_cast<std::int32_t>(row.at.specimen));
    out.write("/specimen", {n}, rows_per_chunk, specimens);
    out.set_texts("/specimen", "labels", labels);
    out.create_group("/column");
    std::vector<std::string> names;
    for (const SweepColumn& column : sweep_columns(sweep)) {
        const std::string name = "/column/" + column.name;
        out.write(name, {n}, rows_per_chunk, column.values);
        out.set_text(name, "units", column.unit);
        out.set_text(name, "long_name", column.meaning);
        names.push_back(column.name);
    }
    out.set_texts("/", "column_names", names);
    out.publish();
}

bool is_sweep_hdf5(const std::filesystem::path& file) {
    return Hdf5File::open(file).text("/", "format") == sweep_format_name;
}

StoredSweep read_sweep_hdf5(const std::filesystem::path& file) {
    const Hdf5File in = Hdf5File::open(file);
    if (in.text("/", "format") != sweep_format_name)
        throw InputError(file.string() +
                         ": /@format: is not a table of specula sweep; write one "
                         "with specula sweep");
    if (const double version = in.number("/", "format_version"); version != sweep_format_version)
        throw InputError(
            format("{}: /@format_version = {}: this program reads version {}; use the "
                   "program that wrote it",
                   file.string(), version, sweep_format_version));
    StoredSweep stored{.title = in.text("/", "title"),
                       .radar = in.text("/", "radar"),
                       .version = in.text("/", "software_version"),
                       .specimens = in.texts("/specimen", "labels"),
                       .columns = {}};
    for (const std::string& name : in.texts("/", "column_names")) {
        const std::string object = "/column/" + name;
        stored.columns.push_back({name, in.text(object, "units"), in.text(object, "long_name"),
                                  in.read<double>(object)});
        if (stored.columns.back().values.empty())
            throw InputError(file.string() + ": " + object + ": is empty; the file is damaged");
    }
    return stored;
}

}  // namespace specula
