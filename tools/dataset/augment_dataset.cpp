#include "tools/dataset/augment_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "classifier/augment.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/sha256.hpp"
#include "sim/parallel.hpp"
#include "tools/dataset/frame_blocks.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/generate/new_folders.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

constexpr double long_codes = 3e7;  ///< some seconds of work

/// Which table a step's copies are made of.
enum class Kind { codes, features };

/// Makes the copies of one block of frames.
class CopyMaker {
  public:
    CopyMaker(const Dataset& form, const AugmentRequest& request)
        : request_(request),
          kind_(form.n_samples > 0 ? Kind::codes : Kind::features),
          knows_height_(!form.unknown_truth[column_of(&Truth::height_m)]),
          knows_gain_(!form.unknown_truth[column_of(&Truth::gain_db)]) {}

    std::size_t per_frame() const {
        return static_cast<std::size_t>(request_.copies) + (request_.keeps_originals ? 1 : 0);
    }

    /// (frame, step) of what was drawn, in the order of `frames` of the last block; not a number
    /// of originals.
    struct Copies {
        Dataset frames;
        std::vector<double> drawn;
        std::vector<double> source_frame, copy;  ///< (frame)
    };

    Copies make(std::size_t first, const Dataset& block) const {
        Copies made;
        made.frames = shell_of(block);
        const std::size_t n = block.n_frames() * per_frame(), n_steps = request_.how.steps.size();
        made.frames.truth.resize(n);
        made.frames.adc.resize(n * block.codes_per_frame());
        made.frames.adc_quadrature.resize(block.adc_quadrature.empty() ? 0
                                                                       : made.frames.adc.size());
        made.frames.features.resize(kind_ == Kind::features ? n * block.feature_names.size() : 0);
        made.drawn.assign(n * n_steps, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            made.source_frame.push_back(static_cast<double>(first + i / per_frame()));
            made.copy.push_back(static_cast<double>(copy_number(i)));
        }
        for_each_index(n, request_.threads, [&](std::size_t i) { fill(first, block, i, made); });
        return made;
    }

  private:
    static std::size_t column_of(double Truth::*member) {
        for (std::size_t i = 0; i < truth_columns.size(); ++i)
            if (truth_columns[i].member == member) return i;
        return 0;
    }

    /// 0: the frame itself.
    std::size_t copy_number(std::size_t i) const {
        return i % per_frame() + (request_.keeps_originals ? 0 : 1);
    }

    /// The form alone: what copies are made of has other numbers.
    static Dataset shell_of(const Dataset& block) {
        Dataset shell = block;
        shell.truth.clear();
        shell.adc.clear();
        shell.adc_quadrature.clear();
        shell.features.clear();
        shell.profile.clear();
        shell.probability.clear();
        return shell;
    }

    void fill(std::size_t first, const Dataset& block, std::size_t i, Copies& made) const {
        const std::size_t source = i / per_frame();
        const auto copy = static_cast<std::uint32_t>(copy_number(i));
        Truth& truth = made.frames.truth[i] = block.truth[source];
        const StreamKey key{.seed = request_.seed,
                            .purpose = "augment",
                            .world = copy,
                            .item = static_cast<std::uint32_t>(first + source)};
        const double range_m = knows_height_ ? truth.height_m : -1.0;
        std::vector<double> drawn;
        if (kind_ == Kind::codes)
            drawn = fill_codes(block, source, copy, range_m, key, made.frames, i);
        else
            drawn = fill_features(block, source, copy, range_m, key, made.frames, i);
        for (std::size_t step = 0; step < drawn.size(); ++step) {
            made.drawn[i * request_.how.steps.size() + step] = drawn[step];
            note(request_.how.steps[step], drawn[step], truth);
        }
    }

    /// The truth after a step, as far as it was known before.
    void note(const AugmentStep& step, double value, Truth& truth) const {
        const bool moves =
            std::holds_alternative<ShiftStep>(step) || std::holds_alternative<RangeStep>(step);
        if (moves && knows_height_) truth.height_m += value;
        if (std::holds_alternative<GainStep>(step) && knows_gain_) truth.gain_db += value;
    }

    static std::int16_t code_of(double lsb) {
        return static_cast<std::int16_t>(std::lround(std::clamp(lsb, -32768.0, 32767.0)));
    }

    std::vector<double> fill_codes(const Dataset& block, std::size_t source, std::uint32_t copy,
                                   double range_m, const StreamKey& key, Dataset& out,
                                   std::size_t i) const {
        const std::size_t n = block.codes_per_frame();
        FrameSamples frame;
        frame.n_rx = block.n_rx;
        frame.n_samples = block.n_samples;
        const auto rows_of = [&](const std::vector<std::int16_t>& codes) {
            const auto begin = codes.begin() + static_cast<std::ptrdiff_t>(source * n);
            return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(n));
        };
        frame.in_phase = rows_of(block.adc);
        if (!block.adc_quadrature.empty()) frame.quadrature = rows_of(block.adc_quadrature);
        std::vector<double> drawn;
        if (copy > 0) drawn = augment_codes(frame, request_.how, range_m, key);
        const auto put = [&](const std::vector<double>& samples, std::vector<std::int16_t>& codes) {
            for (std::size_t k = 0; k < samples.size(); ++k) codes[i * n + k] = code_of(samples[k]);
        };
        put(frame.in_phase, out.adc);
        put(frame.quadrature, out.adc_quadrature);
        return drawn;
    }

    std::vector<double> fill_features(const Dataset& block, std::size_t source, std::uint32_t copy,
                                      double range_m, const StreamKey& key, Dataset& out,
                                      std::size_t i) const {
        const std::size_t n = block.feature_names.size();
        const auto before = std::span(block.features).subspan(source * n, n);
        std::copy(before.begin(), before.end(),
                  out.features.begin() + static_cast<std::ptrdiff_t>(i * n));
        if (copy == 0) return {};
        std::vector<float> row(before.begin(), before.end());
        const std::vector<double> drawn = augment_row(row, request_.how, range_m, key);
        for (std::size_t k = 0; k < n; ++k) out.features[i * n + k] = row[k];
        return drawn;
    }

    const AugmentRequest& request_;
    Kind kind_;
    bool knows_height_, knows_gain_;
};

void check(const Dataset& form, const std::filesystem::path& data, const AugmentRequest& request) {
    if (form.n_samples == 0 && form.feature_names.empty())
        throw InputError(data.string() +
                         ": holds neither codes nor features; steps act on nothing else");
    if (form.sample_axis == SampleAxis::beat) return;
    for (const AugmentStep& step : request.how.steps)
        if (!std::holds_alternative<NoiseStep>(step) && !std::holds_alternative<GainStep>(step))
            throw InputError(format(
                "{}: samples are range themselves, to which step {} does not apply; use noise and "
                "gain",
                data.string(), kind_of(step)));
}

/// What the new file is like: tables computed from codes that have changed are not in it.
Dataset form_after(const Dataset& form, const AugmentRequest& request) {
    Dataset after = form;
    if (form.n_samples > 0) after.feature_names.clear();
    after.answer_names.clear();
    after.n_profile_bins = 0;
    after.origin.version = program_version;
    after.origin.recipe = format("augment_seed = {}\naugment_copies = {}\n{}", request.seed,
                                 request.copies, request.recipe);
    return after;
}

StoredTables tables_after(StoredTables tables, const Dataset& form) {
    tables.profile = tables.probability = false;
    tables.features = form.n_samples == 0;
    return tables;
}

/// Name of a step's column: its place in the recipe and what it is.
std::string column_name(const AugmentRequest& request, std::size_t step) {
    const AugmentStep& each = request.how.steps[step];
    const std::string_view unit = unit_of(each);
    return format("/augmentation/{}_{}_{}", step + 1, kind_of(each),
                  unit == "dB"    ? "db"
                  : unit == "LSB" ? "lsb"
                                  : "m");
}

/// Returns the fingerprint.
std::string write_augmented(const DatasetReader& reader, const std::filesystem::path& data,
                            const std::filesystem::path& out, const AugmentRequest& request) {
    const CopyMaker maker(reader.form(), request);
    const Dataset form = form_after(reader.form(), request);
    const std::size_t n_steps = request.how.steps.size();
    DatasetWriter writer(out, {.form = form,
                               .tables = tables_after(reader.tables(), reader.form()),
                               .n_frames = reader.n_frames() * maker.per_frame(),
                               .shard = {}});
    std::vector<std::vector<double>> drawn(n_steps);
    std::vector<double> source_frame, copy;
    std::optional<Progress> progress;
    const double codes = static_cast<double>(reader.form().codes_per_frame()) *
                         static_cast<double>(reader.n_frames() * maker.per_frame());
    if (codes > long_codes) progress.emplace("augmenting", "frames", reader.n_frames());
    for_each_block(reader, [&](std::size_t first, const Dataset& block) {
        const std::size_t step = std::max<std::size_t>(1, block.n_frames() / maker.per_frame());
        for (std::size_t at = 0; at < block.n_frames(); at += step) {
            InterruptionWatch::check();
            const std::size_t n = std::min(step, block.n_frames() - at);
            const auto made = maker.make(first + at, frames_of(block, {at, at + n}));
            writer.append(pack_frames(made.frames, {0, made.frames.n_frames()}));
            for (std::size_t i = 0; i < made.drawn.size(); ++i)
                drawn[i % n_steps].push_back(made.drawn[i]);
            source_frame.insert(source_frame.end(), made.source_frame.begin(),
                                made.source_frame.end());
            copy.insert(copy.end(), made.copy.begin(), made.copy.end());
            if (progress) progress->done() += n;
        }
    });
    writer.set_group_text("/augmentation", "source_sha256", sha256_of_file(data));
    writer.set_group_text("/augmentation", "recipe", request.recipe);
    writer.set_group_text("/augmentation", "seed", std::to_string(request.seed));
    writer.add_column({"/augmentation/source_frame", "1", "frame of the source file"},
                      source_frame);
    writer.add_column({"/augmentation/copy", "1", "number of the copy; 0: the frame itself"}, copy);
    for (std::size_t step = 0; step < n_steps; ++step)
        writer.add_column(
            {column_name(request, step), std::string(unit_of(request.how.steps[step])),
             "what the step drew; 0 of frames themselves"},
            drawn[step]);
    return writer.publish_new();
}

}  // namespace

std::string augment_dataset(const std::filesystem::path& data, const std::filesystem::path& out,
                            const AugmentRequest& request) {
    const DatasetReader reader(data);
    check(reader.form(), data, request);
    std::error_code ignored;
    if (std::filesystem::equivalent(data, out, ignored))
        throw InputError(out.string() + ": is the dataset itself; give --out another name");
    place_of_file(out);  // refuses what is no file
    // Somebody's recipe, a shard of the source, hours of work: none is told from an older output.
    if (std::filesystem::exists(out, ignored))
        throw InputError(out.string() + ": is there already; remove it or name another file");
    const InterruptionWatch watch("stopped; nothing was written: run the same command again");
    remove_abandoned_drafts(out);
    return with_folders_of(out, [&] { return write_augmented(reader, data, out, request); });
}

}  // namespace specula
