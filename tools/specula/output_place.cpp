#include "tools/specula/output_place.hpp"

#include "sim/core/atomic_file.hpp"
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
    check_output_place(out);
}

}  // namespace specula
