#include "tools/report/gnuplot.hpp"

#include <filesystem>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"

using namespace specula;

namespace {

std::string message_of(const std::string& script, const std::string& program = "gnuplot") {
    try {
        run_gnuplot(script, program);
    } catch (const SystemError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a missing program is named, with what to install", "[report]") {
    const std::string message = message_of("plot x\n", "no-such-gnuplot");
    CHECK(contains(message, "no-such-gnuplot"));
    CHECK(contains(message, "install gnuplot-nox"));
}

TEST_CASE("gnuplot's own message comes with the line of the script", "[report]") {
    const std::string message = message_of("set terminal svg\nplot nonsense(x)\nplot x\n");
    CHECK(contains(message, "line 2"));
    CHECK(contains(message, "exit status 1"));
}

TEST_CASE("a script that draws nothing is an error", "[report]") {
    CHECK(contains(message_of("set terminal svg\n"), "drew nothing"));
}

TEST_CASE("the same script gives the same picture", "[report]") {
    const std::string script = "set terminal svg\nplot [0:1] x\n";
    CHECK(run_gnuplot(script) == run_gnuplot(script));
}

TEST_CASE("a text can neither end its quotes nor run a command", "[report]") {
    const auto witness = std::filesystem::temp_directory_path() / "specula_gnuplot_witness";
    std::filesystem::remove(witness);
    const std::string text = "`touch " + witness.string() + "` '; system('touch " +
                             witness.string() + "') # \\n \"q\"\nexit";
    const std::string svg = run_gnuplot("set terminal svg noenhanced\nset title " +
                                        gnuplot_quoted(text) + "\nplot [0:1] x\n");
    CHECK_FALSE(std::filesystem::exists(witness));
    CHECK(contains(svg, "`touch"));
    CHECK(contains(svg, "\\n \"q\" exit"));
}
