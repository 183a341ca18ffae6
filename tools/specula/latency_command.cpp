#include <cstdio>

#include "tools/firmware/latency_figure.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/firmware_workplace.hpp"

namespace specula {

void latency_command(const LatencyArguments& arguments, const Catalogue& catalogue) {
    const TemporaryWorkplace place;
    const bool is_file = arguments.experiment.extension() == ".toml";
    const LatencyStudy study = study_latency(
        {.experiment_file = is_file ? arguments.experiment
                                    : catalogue.experiment_file(arguments.experiment.string()),
         .descriptor = arguments.descriptor,
         .worlds = arguments.worlds,
         .threads = arguments.threads},
        catalogue, place.get());
    std::printf("%s", latency_text(study).c_str());
    write_figure(arguments.out, latency_figure(study));
    std::printf("\nwrote latency.svg, latency.png and latency.csv in %s\n", arguments.out.c_str());
}

}  // namespace specula
