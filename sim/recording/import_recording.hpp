#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/dataset/dataset.hpp"
#include "sim/recording/manifest.hpp"

namespace specula {

/// The formats that recordings come in, by the names that users give them.
const std::vector<std::string>& recording_formats();

/// The format of a file or folder by its name; empty where several are possible.
std::string guessed_format(const std::filesystem::path& input);

struct ImportedRecording {
    Dataset dataset;
    std::vector<std::string> notes;  ///< what was passed over, one line each
};

/// Reads a recording into the form of a dataset; nothing is written.
/// @in  format  one of recording_formats()
/// Throws InputError `file: byte N: problem; remedy` where the input is not what the format and the
/// manifest say.
ImportedRecording import_recording(const std::string& format, const std::filesystem::path& input,
                                   const RecordingManifest& manifest);

}  // namespace specula
