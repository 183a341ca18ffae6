#include <algorithm>
#include <cctype>
#include <cstdio>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/study.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

fs::path experiment_file(const std::string& wanted, const Catalogue& catalogue) {
    if (fs::path(wanted).extension() == ".toml") return wanted;
    const auto names = catalogue.experiment_names();
    if (std::find(names.begin(), names.end(), wanted) == names.end()) {
        const std::string near = nearest_word(wanted, names);
        throw InputError(format("\"{}\": no such experiment; {}use {} or a .toml file", wanted,
                                near.empty() ? "" : "did you mean " + near + "? ",
                                quoted_list(names)));
    }
    return catalogue.experiment_file(wanted);
}

/// A word as a shell takes it.
std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) || c >= 128 ||
               std::string_view("_-./+,:@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

std::string percent(const Interval& interval) {
    return format("{:5.1f} [{:5.1f}, {:5.1f}]", 100.0 * interval.mean, 100.0 * interval.low,
                  100.0 * interval.high);
}

}  // namespace

void study_command(const StudyArguments& arguments, const Catalogue& catalogue) {
    StudyRequest request;
    request.experiment_file = experiment_file(arguments.experiment, catalogue);
    request.out =
        arguments.out.empty() ? fs::path("out") / request.experiment_file.stem() : arguments.out;
    request.seed = arguments.seed;
    request.threads = arguments.threads;
    request.quick = arguments.quick;
    request.full = arguments.full;
    request.command = "specula study " + shell_word(arguments.experiment) +
                      (arguments.quick  ? " --quick"
                       : arguments.full ? " --full"
                                        : "") +
                      (arguments.seed ? format(" --seed {}", *arguments.seed) : "");
    const StudySummary study = run_study(request, catalogue);

    for (const std::string& warning : study.warnings) say_warning(warning);
    std::printf("%-56s %-22s %-22s %s\n", "macro-F1, percent, with 95 % interval",
                "all classes", study.merged_label.c_str(), "paper");
    for (const StudyCondition& condition : study.conditions) {
        const std::string paper =
            condition.paper_macro_f1 ? format("{:.1f}", 100.0 * *condition.paper_macro_f1) : "-";
        std::printf("%-56s %-22s %-22s %s\n", condition.result.title.c_str(),
                    percent(condition.result.macro_f1).c_str(),
                    percent(condition.result.macro_f1_merged).c_str(), paper.c_str());
    }
    const std::size_t n_worlds = study.conditions.front().result.macro_f1_per_world.size();
    if (n_worlds < few_worlds)
        std::printf("\n%zu %s: weak evidence, to see that all works; no figure here is a result.\n",
                    n_worlds, n_worlds == 1 ? "world" : "worlds");
    std::printf("\nOpen %s in a browser.\n", (request.out / "report.html").c_str());
}

}  // namespace specula
