#include "tests/check.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

/// What bash would offer for a command line whose last word is being typed, one per line.
std::string offered(const MadeUpFolder& folder, const std::string& line) {
    const Ended ended =
        run_program({.arguments = {"bash", "--norc", "-c",
                                   "source ./script; COMP_WORDS=(" + line +
                                       "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _specula; "
                                       "printf '%s\\n' \"${COMPREPLY[@]}\""},
                     .folder = folder.path(),
                     .environment = {{"SPECULA_HOME", SPECULA_SOURCE_DIR}}});
    CHECK(ended.status == 0);
    CHECK(ended.errors.empty());
    return ended.output;
}

TEST_CASE("the completion script is valid and completes", "[program][completion]") {
    const MadeUpFolder folder;
    const Ended script = specula_in(folder.path(), {"completion", "bash"});
    REQUIRE(script.status == 0);
    folder.with("script", script.output);
    const Ended checked =
        run_program({.arguments = {"bash", "-n", "script"}, .folder = folder.path()});
    CHECK(checked.status == 0);
    CHECK(checked.errors.empty());

    const std::string program = "'" SPECULA_BINARY "' ";
    CHECK(offered(folder, program + "s").find("study\nsimulate\n") != std::string::npos);
    CHECK(offered(folder, program + "l") == "latency\nlikeness\nlist\n");
    CHECK(offered(folder, program + "list r") == "radars\n");
    CHECK(offered(folder, program + "completion z") == "zsh\n");
    CHECK(offered(folder, program + "study --q") == "--quick\n");
    CHECK(offered(folder, program + "study pap") == "paper\n");
    CHECK(offered(folder, program + "show plexi") == "plexiglass\n");
    CHECK(offered(folder, program + "show iwrl") == "iwrl6432boost\niwrl6432boost_recorded\n");
    // Nothing of ours: bash then offers files, as `-o default` tells it.
    CHECK(offered(folder, program + "simulate sc") == "\n");
    CHECK(offered(folder, program + "show name") == "\n");  // a heading is no name
    CHECK(script.output.find("complete -o default -F _specula specula ./specula") !=
          std::string::npos);
}

TEST_CASE("zsh is given what it needs to read a script of bash", "[program][completion]") {
    const MadeUpFolder folder;
    const std::string zsh = specula_in(folder.path(), {"completion", "zsh"}).output;
    const std::string bash = specula_in(folder.path(), {"completion"}).output;
    CHECK(zsh == "autoload -U +X bashcompinit && bashcompinit\n" + bash);
}

}  // namespace
}  // namespace specula
