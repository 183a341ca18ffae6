#include <algorithm>

#include "sim/core/document.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/run_program.hpp"

// The program as its user meets it: arguments, help, errors in general. Files with mistakes in
// them: bad_scene_test.cpp and bad_study_test.cpp.

namespace specula {
namespace {

const std::vector<std::string> commands{
    "study",   "simulate", "show",       "sweep",     "validate",
    "import",  "export",   "train",      "evaluate",  "verify-firmware",
    "latency", "list",     "completion", "calibrate", "likeness",
    "predict", "diff",     "augment",    "bench",     "generate",
    "merge",   "serve"};

/// Runs in an empty folder, in which a wrong command line may leave nothing.
Ended run(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const Ended ended = specula_in(folder.path(), arguments);
    CHECK(n_entries(folder.path()) == 0);
    return ended;
}

/// In the order of the help.
std::string all_commands() {
    const std::string help = run({"--help"}).output;
    std::vector<std::string> words = commands;
    std::sort(words.begin(), words.end(), [&](const auto& a, const auto& b) {
        return help.find("\n  " + a + " ") < help.find("\n  " + b + " ");
    });
    return quoted_list(words);
}

TEST_CASE("help names every command, where to begin and the exit statuses", "[program]") {
    const Ended help = run({"--help"});
    CHECK(help.status == 0);
    CHECK(help.errors.empty());
    for (const std::string& command : commands)
        CHECK(contains(help.output, "\n  " + command + " "));
    CHECK(contains(help.output, "specula simulate scenes/examples/metal_plate.toml"));
    CHECK(contains(help.output, "0 done, 1 the system failed"));
    CHECK(std::filesystem::exists(SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml"));
}

TEST_CASE("every command has help with an example", "[program]") {
    for (const std::string& command : commands) {
        INFO(command);
        const Ended help = run({command, "--help"});
        CHECK(help.status == 0);
        CHECK(help.errors.empty());
        CHECK(contains(help.output, "\nExample:\n  "));
        CHECK(contains(help.output, "specula " + command));
    }
    const std::string study = run({"study", "--help"}).output;
    for (const char* part : {"--seed", "--threads", "--quick", "--out", "1 to 1024", "10 s",
                             "report.html", "default out/EXPERIMENT"})
        CHECK(contains(study, part));
    CHECK(contains(run({"simulate", "--help"}).output, "ADC codes in LSB"));
}

TEST_CASE("the version is the project's", "[program]") {
    const Ended version = run({"--version"});
    CHECK(version.status == 0);
    CHECK(version.output == "specula " SPECULA_VERSION "\n");
}

TEST_CASE("wrong arguments are one line that says what would do", "[program]") {
    struct Case {
        std::vector<std::string> arguments;
        std::string message;
    };
    for (const auto& [arguments, message] : std::vector<Case>{
             {{}, "A subcommand is required; see specula --help"},
             {{"lst"}, "\"lst\": no such command; did you mean list? use " + all_commands()},
             {{"fly", "--high"}, "\"fly\": no such command; use " + all_commands()},
             {{"list"}, "KIND is required; see specula list --help"},
             {{"list", "bogus"},
              "KIND: bogus not in {materials,radars,experiments,datasets,sweeps}; see specula list "
              "--help"},
             {{"show"}, "NAME is required; see specula show --help"},
             {{"simulate"}, "SCENE is required; see specula simulate --help"},
             {{"simulate", "a", "b"},
              "The following argument was not expected: b; see specula simulate --help"},
             {{"simulate", "a", "--fast"},
              "The following argument was not expected: --fast; see specula simulate --help"},
             {{"simulate", "a", "--seed", "-5"},
              "--seed: -5 is not a whole number from 0 to 18446744073709551615; "
              "see specula simulate --help"},
             {{"study", "--seed", "1.5"},
              "--seed: 1.5 is not a whole number from 0 to 18446744073709551615; "
              "see specula study --help"},
             {{"study", "--seed", "18446744073709551616"},
              "--seed: 18446744073709551616 is not a whole number from 0 to "
              "18446744073709551615; see specula study --help"},
             {{"study", "-j", "0"},
              "--threads: Value 0 not in range 1 to 1024; see specula study --help"},
             {{"completion", "fish"},
              "SHELL: fish not in {bash,zsh}; see specula completion --help"},
         }) {
        const Ended ended = run(arguments);
        CHECK(ended.status == 2);
        CHECK(ended.output.empty());
        CHECK(ended.errors == "specula: error: " + message + "\n");
    }
}

TEST_CASE("an error is one line whatever the name of the file holds", "[program]") {
    const Ended ended = run({"show", "a\nb\x1b[2J.toml"});
    CHECK(ended.status == 2);
    CHECK(ended.errors == "specula: error: a?b?[2J.toml: no such file; check the path\n");
}

TEST_CASE("a wrong SPECULA_HOME is named", "[program]") {
    const TemporaryFolder folder;
    const Ended ended = run_program({.arguments = {SPECULA_BINARY, "list", "radars"},
                                     .folder = folder.path(),
                                     .environment = {{"SPECULA_HOME", "/nonexistent"}}});
    CHECK(ended.status == 2);
    CHECK(ended.errors ==
          "specula: error: /nonexistent/materials/library: no such folder; "
          "set SPECULA_HOME to the folder that holds it\n");
}

TEST_CASE("output that finds no room is an error, a closed pipe is none", "[program]") {
    const TemporaryFolder folder;
    Start start{.arguments = {SPECULA_BINARY, "list", "radars"},
                .folder = folder.path(),
                .environment = {{"SPECULA_HOME", SPECULA_SOURCE_DIR}},
                .output_file = "/dev/full"};
    const Ended full = run_program(start);
    CHECK(full.status == 1);
    CHECK(full.errors ==
          "specula: error: standard output: cannot write: No space left on device\n");

    start.arguments = {"bash", "-c", "set -o pipefail; '" SPECULA_BINARY "' list radars | true"};
    start.output_file.clear();
    const Ended closed = run_program(start);
    CHECK(closed.status == 0);
    CHECK(closed.errors.empty());
}

}  // namespace
}  // namespace specula
