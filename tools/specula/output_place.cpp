#include "tools/specula/output_place.hpp"

#include <algorithm>
#include <cctype>

#include "sim/core/atomic_file.hpp"
#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

void prepare_output(const fs::path& out, const std::vector<fs::path>& inputs,
                    const std::string& option) {
    std::error_code error;
    for (const fs::path& input : inputs)
        if (!input.empty() && fs::equivalent(out, input, error))
            throw InputError(format("{}: is an input of this command; give {} another name",
                                    out.string(), option));
    check_output_place(out);
}

void check_figure_place(const fs::path& where, const std::vector<std::string>& formats) {
    const std::string kind = where.extension().string();
    const bool is_kind = std::any_of(kind.begin(), kind.end(),
                                     [](unsigned char c) { return std::isalpha(c) != 0; });
    std::error_code ignored;
    if (!is_kind || fs::is_directory(where, ignored)) return;
    if (std::find(formats.begin(), formats.end(), kind) != formats.end()) return;
    throw InputError(format("--figure {}: no figure is written as {} here; name a folder{}",
                            where.string(), kind,
                            formats.empty() ? "" : ", or a file of " + quoted_list(formats)));
}

}  // namespace specula
