#include <cstdio>
#include <optional>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/recording/import_recording.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/output_place.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t slow_bytes = 16u << 20;  ///< from here on, it takes seconds

/// Of a file, or of the files of a folder.
std::uintmax_t bytes_of(const fs::path& input) {
    std::error_code ignored;
    if (!fs::is_directory(input, ignored)) return fs::file_size(input, ignored);
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(input, ignored))
        if (entry.is_regular_file(ignored)) bytes += entry.file_size(ignored);
    return bytes;
}

/// `[FORMAT] INPUT`.
struct Source {
    std::string format;
    fs::path input;
};

Source source_of(const std::vector<std::string>& what) {
    Source source{what.size() == 2 ? what[0] : guessed_format(what[0]), what.back()};
    std::error_code ignored;
    if (!fs::exists(source.input, ignored))
        throw InputError(source.input.string() + ": no such file or folder; check the path");
    if (source.format.empty())
        throw InputError(format("{}: its name does not tell its format; put one of {} before it",
                                source.input.string(), quoted_list(recording_formats())));
    return source;
}

/// The manifest that is named, or lies beside the input as INPUT.toml; empty where there is none.
fs::path manifest_file(const ImportArguments& arguments, const fs::path& input) {
    if (!arguments.manifest.empty()) return arguments.manifest;
    const fs::path beside = input.string() + ".toml";
    std::error_code ignored;
    return fs::exists(beside, ignored) ? beside : fs::path();
}

Section manifest_for(const ImportArguments& arguments, const fs::path& input) {
    const fs::path file = manifest_file(arguments, input);
    return file.empty() ? Section::parse("", "no manifest") : Section::read(file);
}

}  // namespace

void import_command(const ImportArguments& arguments, const Catalogue& catalogue) {
    const Source source = source_of(arguments.what);
    const RecordingManifest manifest =
        read_manifest(manifest_for(arguments, source.input), catalogue);
    std::optional<Progress> progress;
    if (bytes_of(source.input) > slow_bytes) progress.emplace("Importing", "recordings", 1);
    const ImportedRecording imported = import_recording(source.format, source.input, manifest);
    const fs::path out =
        arguments.out.empty()
            ? fs::path((fs::absolute(source.input) / "").parent_path().stem().string() + ".h5")
            : arguments.out;
    prepare_output(out, {source.input, manifest_file(arguments, source.input)});
    for (const std::string& note : imported.notes) say_warning(source.input.string() + ": " + note);
    write_dataset(out, imported.dataset);
    if (progress) ++progress->done();
    progress.reset();
    std::printf("%zu frames of %zu classes\nWrote %s; specula show %s\n",
                imported.dataset.n_frames(), imported.dataset.class_names.size(), out.c_str(),
                out.c_str());
}

}  // namespace specula
