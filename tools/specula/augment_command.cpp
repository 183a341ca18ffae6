#include <cstdio>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "tools/console/console.hpp"
#include "tools/dataset/augment_dataset.hpp"
#include "tools/dataset/dataset_path.hpp"
#include "tools/specula/dataset_commands.hpp"

namespace specula {

namespace {

/// "bin 6" -> 6: where a descriptor begins that names its bins so; else 0.
int first_bin_of(const Dataset& form) {
    int bin = 0;
    if (form.feature_names.empty()) return 0;
    return std::sscanf(form.feature_names.front().c_str(), "bin %d", &bin) == 1 ? bin : 0;
}

/// The radar asked for, else the one that the dataset names and the catalogue knows; else what the
/// file says by itself.
RadarView radar_of(const AugmentArguments& arguments, const Dataset& form,
                   const Catalogue& catalogue) {
    const std::vector<std::string> known = catalogue.radar_names();
    const bool is_known = std::find(known.begin(), known.end(), form.origin.radar) != known.end();
    RadarView view;
    if (!arguments.radar.empty() || is_known)
        view = view_of(
            catalogue.radar_called(arguments.radar.empty() ? form.origin.radar : arguments.radar));
    else
        say_warning(format(
            "{}: radar \"{}\" is not in the catalogue, so neither the carrier's phase nor the IF "
            "high-pass is accounted for; --radar names one",
            arguments.data.string(), form.origin.radar));
    const double tolerance = 1e-3;
    if (form.origin.bin_m > 0.0 && view.bin_m > 0.0 &&
        std::abs(view.bin_m / form.origin.bin_m - 1.0) > tolerance)
        throw InputError(format(
            "{}: /@range_bin_m = {:.6g}: the radar's chirp has bins of {:.6g} m; name the radar "
            "that it was recorded with",
            arguments.data.string(), form.origin.bin_m, view.bin_m));
    if (form.origin.bin_m > 0.0) view.bin_m = form.origin.bin_m;
    if (form.n_samples > 0) view.n_samples = form.n_samples;
    view.first_bin = first_bin_of(form);
    return view;
}

}  // namespace

void augment_command(const AugmentArguments& arguments, const Catalogue& catalogue) {
    if (arguments.recipe.empty() == arguments.steps.empty())
        throw InputError("augment: give either --recipe or one --step or more");
    AugmentRequest request{.copies = arguments.copies,
                           .keeps_originals = !arguments.without_originals,
                           .seed = arguments.seed,
                           .threads = arguments.threads};
    if (!arguments.recipe.empty()) {
        Section recipe = Section::read(arguments.recipe);
        request.how.steps = read_steps(recipe);
        recipe.finish();
        request.recipe = recipe.source();
    }
    for (const std::string& step : arguments.steps) {
        request.how.steps.push_back(step_of(step));
        request.recipe += "step = \"" + step + "\"\n";
    }
    const std::filesystem::path data = dataset_file(arguments.data);
    const DatasetReader reader(data);
    request.how.radar = radar_of(arguments, reader.form(), catalogue);
    const std::string fingerprint = augment_dataset(data, arguments.out, request);
    const std::size_t per_frame =
        static_cast<std::size_t>(arguments.copies) + (arguments.without_originals ? 0 : 1);
    std::printf("Wrote %s: %zu frames of %zu, fingerprint %s\n", arguments.out.c_str(),
                reader.n_frames() * per_frame, reader.n_frames(), fingerprint.c_str());
    describe_written(arguments.out, arguments.threads);
}

}  // namespace specula
