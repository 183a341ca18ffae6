#include <cstdio>

#include "sim/core/error.hpp"
#include "tools/console/console.hpp"
#include "tools/dataset/dataset_path.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/specula/dataset_commands.hpp"

namespace specula {

void document_command(const DocumentArguments& arguments) {
    const std::filesystem::path data = dataset_file(arguments.data);
    const std::filesystem::path folder = arguments.out.empty() ? data.parent_path() : arguments.out;
    const std::filesystem::path written =
        arguments.what == "croissant"
            ? write_croissant(data, folder, arguments.options)
            : write_datasheet(data, folder, arguments.options, arguments.threads);
    std::printf("Wrote %s\n", written.c_str());
}

void describe_written(const std::filesystem::path& dataset, int threads) {
    const InterruptionWatch watch("stopped; " + dataset.string() +
                                  " is finished, its documents are not: specula export datasheet "
                                  "and specula export croissant write them");
    try {
        if (!write_documents(dataset, threads)) return;
        const DocumentFiles documents = document_files(dataset, "");
        std::printf("Beside it %s and %s\n", documents.datasheet.c_str(),
                    documents.croissant.c_str());
    } catch (const InputError& taken) {  // by another dataset of the same name
        say_warning(taken.what());
    }
}

}  // namespace specula
