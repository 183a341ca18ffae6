#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/dataset/dataset.hpp"
#include "sim/recording/infineon_config.hpp"

namespace specula {

/// The formats that datasets go out in; import_recording reads each back.
const std::vector<std::string>& export_formats();

/// Whether a format carries features instead of codes.
bool carries_features(const std::string& format);

/// What a dataset does not say of the radar, and some formats ask for.
struct SentChirps {
    InfineonConfig infineon;  ///< its counts are ignored
    std::size_t n_tx = 1;     ///< that take turns in a frame
};

struct ExportedFile {
    std::filesystem::path name;
    std::string content;
};

/// What a dataset is in another format: the file or files of that format, and behind them the
/// manifest `OUT.toml` that brings classes and groups back (a table, csv, holds them itself).
///
/// Codes come back bit by bit, and so do features; npy holds codes where there are any.
/// @in  format  one of export_formats()
/// @in  chirps  for infineon and injection only
/// Throws InputError where the dataset has what the format cannot say: complex codes, codes beyond
/// its bits, features that are no whole numbers.
std::vector<ExportedFile> export_recording(const std::string& format, const Dataset& dataset,
                                           const std::filesystem::path& out,
                                           const SentChirps& chirps);

}  // namespace specula
