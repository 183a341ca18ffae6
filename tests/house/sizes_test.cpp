#include <cctype>

#include "tests/check.hpp"
#include "tests/house/source_tree.hpp"

// Laws about single files: short, named for what they hold, and each header included once.

namespace specula {
namespace {

constexpr std::size_t longest = 300;  // lines

// Written by a program, so nobody reads them from top to bottom.
const std::set<std::string> generated{"firmware/fw_tables.c"};

Breaches too_long(const SourceTree& tree) {
    Breaches breaches;
    for (const auto& file : tree.files()) {
        if (file.lines.size() <= longest || generated.count(file.path) != 0) continue;
        breaches.push_back(breach(file.path, longest + 1,
                                  "has " + std::to_string(file.lines.size()) + " lines; at most " +
                                      std::to_string(longest) +
                                      ", so part it by what it is about"));
    }
    return breaches;
}

// Names that say nothing about what is inside. Folders count: util/angles.hpp says no more.
const std::set<std::string> empty_words{"util",    "common",  "helper", "misc",
                                        "manager", "handler", "base",   "impl"};

/// The words of a path in lower case, a plural also as singular: "Log_utils.hpp" -> log, utils,
/// util.
std::set<std::string> words_of(const std::string& path) {
    std::set<std::string> words;
    std::string word;
    for (const char c : path + "/") {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            continue;
        }
        words.insert(word);
        if (!word.empty() && word.back() == 's') words.insert(word.substr(0, word.size() - 1));
        word.clear();
    }
    return words;
}

Breaches emptily_named(const SourceTree& tree) {
    Breaches breaches;
    for (const auto& file : tree.files()) {
        for (const auto& word : words_of(file.path)) {
            if (empty_words.count(word) == 0) continue;
            breaches.push_back(
                breach(file.path, 1, "\"" + word + "\" names no content; say what is inside"));
        }
    }
    return breaches;
}

/// A header's first directive must be the guard, so that nothing before it is read twice.
Breaches unguarded(const SourceTree& tree) {
    Breaches breaches;
    for (const auto& file : tree.files()) {
        if (std::filesystem::path(file.path).extension() != ".hpp") continue;
        const auto first = std::find_if(file.lines.begin(), file.lines.end(),
                                        [](const auto& line) { return line.rfind("#", 0) == 0; });
        if (first == file.lines.end() || *first != "#pragma once") {
            breaches.push_back(breach(file.path, 1, "starts without #pragma once"));
        }
    }
    return breaches;
}

void check_none(const Breaches& breaches) {
    INFO(one_per_line(breaches));
    CHECK(breaches.empty());
}

TEST_CASE("no source file is too long to be read at a sitting", "[house]") {
    check_none(too_long(SourceTree(SPECULA_SOURCE_DIR)));
}

TEST_CASE("file names say what is inside", "[house]") {
    check_none(emptily_named(SourceTree(SPECULA_SOURCE_DIR)));
}

TEST_CASE("every C++ header begins with #pragma once", "[house]") {
    check_none(unguarded(SourceTree(SPECULA_SOURCE_DIR)));
}

std::string lines(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += "//\n";
    return text;
}

TEST_CASE("a file of one line too many is found, whatever its language", "[house]") {
    MadeUpTree made_up;
    made_up.with("sim/fits.cpp", lines(longest));
    made_up.with("sim/PHYSICS.md", lines(longest + 1));        // prose may be long
    made_up.with("firmware/fw_tables.c", lines(longest + 1));  // generated
    CHECK(too_long(made_up.read()).empty());

    for (const auto* path : {"sim/long.cpp", "firmware/long.h", "tests/long_test.cpp", "specula",
                             "tools/long.py", "CMakeLists.txt"}) {
        MadeUpTree longer;
        longer.with(path, lines(longest + 1));
        const auto breaches = too_long(longer.read());
        REQUIRE(breaches.size() == 1);
        CHECK(breaches.front().rfind(std::string(path) + ":301: has 301 lines", 0) == 0);
    }
}

TEST_CASE("an empty word in a name is found, a word that only contains it is not", "[house]") {
    MadeUpTree made_up;
    for (const auto* path : {"sim/database.cpp", "scenes/commonplace.toml", "tools/implicit.hpp"}) {
        made_up.with(path, "");
    }
    CHECK(emptily_named(made_up.read()).empty());

    for (const auto* path : {"sim/math_util.hpp", "sim/Utils.hpp", "tools/common/angle.hpp",
                             "tests/test-helpers.hpp", "sim/misc.cpp", "sim/task_manager.cpp",
                             "sim/handler.cpp", "scenes/base.toml", "sim/trace/rays_impl.hpp"}) {
        MadeUpTree badly_named;
        badly_named.with(path, "");
        CHECK(emptily_named(badly_named.read()).size() == 1);
    }
}

TEST_CASE("a header without its guard at the top is found", "[house]") {
    MadeUpTree made_up;
    made_up.with("a.hpp", "#pragma once\n")
        .with("b.hpp", "// why\n\n#pragma once\n#include <set>\n");
    made_up.with("c.h", "").with("d.cpp", "");
    CHECK(unguarded(made_up.read()).empty());

    for (const auto* text :
         {"", "int x;\n", "#include <set>\n#pragma once\n", "// #pragma once\n"}) {
        MadeUpTree bare;
        bare.with("bare.hpp", text);
        CHECK(unguarded(bare.read()) == Breaches{"bare.hpp:1: starts without #pragma once"});
    }
}

}  // namespace
}  // namespace specula
