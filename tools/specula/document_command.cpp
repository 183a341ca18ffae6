#include <cstdio>

#include "tools/dataset/dataset_path.hpp"
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

}  // namespace specula
