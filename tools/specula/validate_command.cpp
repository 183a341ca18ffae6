#include <cstdio>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "tools/report/html_report.hpp"
#include "tools/specula/commands.hpp"
#include "tools/validate/validate.hpp"
#include "tools/validate/validation_json.hpp"
#include "tools/validate/validation_page.hpp"
#include "tools/validate/validation_table.hpp"

namespace specula {

namespace {

/// The project's own cases: installed beside materials and scenes, in the source tree among tests.
std::filesystem::path own_cases(const std::filesystem::path& root) {
    for (const char* place : {"reference", "tests/reference"})
        if (std::filesystem::is_directory(root / place)) return root / place;
    throw SystemError(root.string() + ": holds no reference cases; name a folder that does");
}

}  // namespace

int validate_command(const ValidateArguments& arguments, const Catalogue& catalogue) {
    const Validation validation =
        validate({.folder = arguments.folder.empty() ? own_cases(catalogue.root) : arguments.folder,
                  .threads = arguments.threads},
                 catalogue.materials);
    std::fputs(validation_table(validation).c_str(), stdout);
    if (!arguments.json.empty()) write_file_atomically(arguments.json, validation_json(validation));
    if (!arguments.html.empty()) write_html_report(arguments.html, validation_page(validation));
    return validation.exit_status();
}

}  // namespace specula
