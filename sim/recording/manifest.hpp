#pragma once

#include <array>
#include <map>
#include <optional>

#include "scenes/catalogue.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/recording/axis_order.hpp"
#include "sim/recording/code_stream.hpp"

namespace specula {

/// What is known of some frames of a recording.
struct RecordingPart {
    std::size_t first = 0, last = 0;  ///< frames, both included
    std::string class_name;
    std::int32_t world = 0, sample = 0, session = 0;
    std::optional<std::int32_t> view;
    std::array<std::optional<double>, truth_columns.size()> truth;  ///< as truth_columns
};

/// What a recording does not say itself; a small TOML file, whose keys FORMAT.md lists.
struct RecordingManifest {
    std::string source;                   ///< the file, byte for byte
    std::string condition = "recording";  ///< what was recorded
    std::string radar = "unknown";
    double bin_m = 0.0;  ///< 0: unknown
    SampleAxis sample_axis = SampleAxis::beat;
    std::vector<std::string> class_names;  ///< empty: those that labels name

    std::vector<std::string> axes;              ///< empty: the format's own
    std::map<std::string, std::size_t> length;  ///< of an axis, where it is given
    std::string member;                         ///< of an .npz archive
    std::optional<Packing> packing;
    bool packets = false;  ///< whether DCA1000 headers are still in the stream
    bool trust_axes =
        false;             ///< whether codes that look interleaved otherwise are taken all the same
    bool wrapped = false;  ///< whether 32768 to 65535 stand for negative codes

    std::map<std::string, std::string> columns;  ///< class, sample, session, view, frame, world ->
                                                 ///< column of a table, member of an archive
    std::vector<std::string> features;           ///< columns; empty: all others
    std::vector<RecordingPart> parts;
};

/// Throws InputError for unknown keys, impossible values, parts that overlap.
RecordingManifest read_manifest(Section section, const Catalogue& catalogue);

/// How manifests begin that manifest_of makes.
inline constexpr std::string_view manifest_first_line = "# Written by specula export.\n";

/// The manifest that brings classes and groups of a dataset back from a file without any; of its
/// truth, nothing.
/// @in  layout  text of a [layout] section where the format does not say it; or empty
std::string manifest_of(const Dataset& dataset, const std::string& layout);

}  // namespace specula
