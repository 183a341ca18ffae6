#include <cstdio>

#include "tools/specula/dataset_commands.hpp"

namespace specula {

void document_command(const DocumentArguments& arguments) {
    const std::filesystem::path folder =
        arguments.out.empty() ? arguments.data.parent_path() : arguments.out;
    const std::filesystem::path written =
        arguments.what == "croissant"
            ? write_croissant(arguments.data, folder, arguments.options)
            : write_datasheet(arguments.data, folder, arguments.options, arguments.threads);
    std::printf("Wrote %s\n", written.c_str());
}

}  // namespace specula
