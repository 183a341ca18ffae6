#include "sim/recording/import_arrays.hpp"

#include <algorithm>
#include <cmath>

namespace specula {

namespace {

constexpr std::size_t most_features = 4096;

std::int16_t code_of(double value, bool wrapped, std::size_t offset) {
    if (wrapped && value > 32767.0) value -= 65536.0;
    if (!(value >= -32768.0 && value <= 32767.0) || value != std::floor(value))
        fail_at(offset, format("{}: is not an ADC code of 16 bits", value),
                value > 32767.0 && value < 65536.0
                    ? "if it stands for a negative one, say wrapped = true in [layout]"
                    : "name an array of codes, or give axes");
    return static_cast<std::int16_t>(value);
}

/// Element (row, column) of an array of two axes, whatever its order.
std::size_t place(const NpyArray& array, std::size_t row, std::size_t column) {
    return array.fortran_order ? column * array.shape[0] + row : row * array.shape[1] + column;
}

std::string label_text(const NpyArray& array, std::size_t i) {
    return array.is_number() ? format("{}", array.real(i)) : array.text(i);
}

}  // namespace

std::vector<std::int16_t> codes_of(const NpyArray& array, bool wrapped) {
    if (!array.is_number())
        fail_at(array.data_offset, "an array of texts", "name an array of codes");
    std::vector<std::int16_t> codes;
    codes.reserve(array.size() * (array.kind == 'c' ? 2 : 1));
    for (std::size_t i = 0; i < array.size(); ++i) {
        const std::size_t offset = array.data_offset + i * array.item_bytes;
        codes.push_back(code_of(array.real(i), wrapped, offset));
        if (array.kind == 'c') codes.push_back(code_of(array.imaginary(i), wrapped, offset));
    }
    return codes;
}

AxisOrder order_of(const NpyArray& array, const RecordingManifest& manifest) {
    AxisOrder order{manifest.axes, array.shape};
    if (order.axes.empty() && (array.shape.size() == 4 || array.shape.size() == 5)) {
        order.axes = {"frame", "chirp", "rx", "sample", "iq"};
        order.axes.resize(array.shape.size());
    }
    if (order.axes.size() != array.shape.size())
        throw InputError(
            format("axes: {} names for an array of {} axes; name each in [layout] of "
                   "a manifest, the slowest first",
                   order.axes.size(), array.shape.size()));
    if (array.fortran_order) {
        std::ranges::reverse(order.axes);
        std::ranges::reverse(order.shape);
    }
    if (array.kind == 'c') {
        order.axes.emplace_back("iq");
        order.shape.push_back(2);
    }
    return order;
}

bool is_feature_table(const NpyArray& array, const RecordingManifest& manifest) {
    if (!manifest.axes.empty())
        return manifest.axes == std::vector<std::string>{"frame", "feature"};
    return array.shape.size() == 2 && array.kind != 'c';
}

void take_features(const NpyArray& array, Dataset& dataset) {
    if (array.shape.size() != 2 || !array.is_number() || array.kind == 'c' || array.shape[0] == 0 ||
        array.shape[1] == 0 || array.shape[1] > most_features)
        fail_at(array.data_offset, "no table of numbers (frame, feature)",
                format("name an array of two axes, at most {} features", most_features));
    for (std::size_t k = 0; k < array.shape[1]; ++k)
        dataset.feature_names.push_back(format("feature {}", k));
    dataset.truth.resize(array.shape[0]);
    dataset.features.reserve(array.size());
    for (std::size_t i = 0; i < array.shape[0]; ++i)
        for (std::size_t k = 0; k < array.shape[1]; ++k) {
            const std::size_t at = place(array, i, k);
            const double value = array.real(at);
            if (!std::isfinite(value))
                fail_at(array.data_offset + at * array.item_bytes, "a value that is not finite",
                        "leave such frames out");
            dataset.features.push_back(value);
        }
}

LabelColumns label_members(const ZipArchive& archive, const RecordingManifest& manifest,
                           std::size_t n_frames, std::size_t n_recordings) {
    LabelColumns columns;
    for (const auto& [key, member] : manifest.columns) {
        const std::vector<std::uint8_t> content = archive.extract(member + ".npy");
        const NpyArray array = read_npy(content);
        const std::size_t n = array.size();
        if (n != n_frames && n != n_recordings)
            throw InputError(
                format("{} = \"{}\": has {} elements beside {} frames of {} "
                       "recordings; name an array of one per frame or recording",
                       key, member, n, n_frames, n_recordings));
        const std::size_t repeated = n_frames / n;
        std::vector<std::string>& texts = columns[key];
        for (std::size_t i = 0; i < n_frames; ++i) texts.push_back(label_text(array, i / repeated));
    }
    return columns;
}

}  // namespace specula
