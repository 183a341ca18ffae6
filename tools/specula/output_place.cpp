#include "tools/specula/output_place.hpp"

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

void prepare_output(const fs::path& out, const std::vector<fs::path>& inputs) {
    std::error_code error;
    for (const fs::path& input : inputs)
        if (!input.empty() && fs::equivalent(out, input, error))
            throw InputError(
                format("{}: is an input of this command; give --out another name", out.string()));
    const fs::path folder = out.parent_path();
    if (folder.empty()) return;
    fs::create_directories(folder, error);
    if (error)
        throw SystemError(format("{}: cannot create: {}", folder.string(), error.message()));
}

}  // namespace specula
