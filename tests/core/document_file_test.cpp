#include <sys/stat.h>

#include <fstream>

#include "sim/core/document.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::string read_error(const std::filesystem::path& file) {
    return message_of([&] { return Section::read(file); });
}

std::string parse_error(const std::string& text) {
    return message_of([&] { return Section::parse(text, "x.toml"); });
}

TEST_CASE("a file is read whole and quoted byte for byte", "[document][file]") {
    const TemporaryFolder folder;
    const std::string text = "# a comment \xc3\xa4\r\na = 1\r\n";
    std::ofstream(folder / "x.toml", std::ios::binary) << text;
    Section section = Section::read(folder / "x.toml");
    CHECK(section.count("a", Range::any()) == 1);
    CHECK(section.source() == text);
    CHECK(section.file() == (folder / "x.toml").string());
}

TEST_CASE("an empty file is a table without keys", "[document][file]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.toml").flush();
    Section section = Section::read(folder / "x.toml");
    CHECK_NOTHROW(section.finish());
    CHECK(message_of([&] { return section.text("title"); }) ==
          (folder / "x.toml").string() + ":1: title: is missing; add it");
}

TEST_CASE("a link to a file is followed", "[document][file]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.toml") << "a = 1";
    std::filesystem::create_symlink(folder / "x.toml", folder / "y.toml");
    CHECK(Section::read(folder / "y.toml").count("a", Range::any()) == 1);
}

TEST_CASE("what is no file to read is refused at once, with its path", "[document][file]") {
    const TemporaryFolder folder;
    const std::string missing = ": no such file; check the path";
    CHECK(read_error(folder / "none.toml") == (folder / "none.toml").string() + missing);
    CHECK(read_error("") == missing);
    std::filesystem::create_symlink(folder / "none.toml", folder / "dangling.toml");
    CHECK(read_error(folder / "dangling.toml") == (folder / "dangling.toml").string() + missing);

    const std::string irregular = ": is not a regular file; name a TOML file";
    CHECK(read_error(folder.path()) == folder.path().string() + irregular);
    REQUIRE(::mkfifo((folder / "fifo.toml").c_str(), 0600) == 0);  // to open it would block
    CHECK(read_error(folder / "fifo.toml") == (folder / "fifo.toml").string() + irregular);
    CHECK(read_error("/dev/zero") == "/dev/zero" + irregular);
}

TEST_CASE("a huge file is refused before it is read", "[document][file]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.toml").flush();
    std::filesystem::resize_file(folder / "x.toml", std::uintmax_t{1} << 40);  // sparse: no space
    CHECK(read_error(folder / "x.toml") ==
          (folder / "x.toml").string() +
              ": is larger than 1 MiB; a description file is text of a few kB");
}

TEST_CASE("malformed TOML is refused with its line", "[document][file]") {
    struct Case {
        const char* text;
        const char* beginning;
    };
    for (const auto& [text, beginning] : {
             Case{"a = 1\nb = \nc = 3\n", "x.toml:2: not valid TOML: "},
             Case{"a = 1\n[open\n", "x.toml:2: not valid TOML: "},
             Case{"a = 1\na = 2\n", "x.toml:2: not valid TOML: "},
             Case{"[t]\n[t]\n", "x.toml:2: not valid TOML: "},
             Case{"a = 'x\n", "x.toml:1: not valid TOML: "},
             Case{"a = 1mm\n", "x.toml:1: not valid TOML: "},
             Case{"\n\nh\xc3\xb6he = 1\n", "x.toml:3: not valid TOML: "},
             Case{"a = '\xff'\n", "x.toml:1: not valid TOML: "},
             Case{"a = 1\n\x01\n", "x.toml:2: not valid TOML: "},
             Case{"\x89HDF\r\n\x1a\n", "x.toml:1: not valid TOML: "},
         }) {
        const std::string error = parse_error(text);
        INFO(error);
        CHECK(error.rfind(beginning, 0) == 0);
        CHECK(error.find("; see https://toml.io for the syntax") != std::string::npos);
        CHECK(error.find_first_of("\n\r\x01\x1a") == std::string::npos);  // one line
    }
}

TEST_CASE("nesting without end is malformed, not a crash", "[document][file]") {
    CHECK(parse_error("a = " + std::string(4000, '[')).rfind("x.toml:1: not valid TOML", 0) == 0);
    std::string dotted = "\na";
    for (int i = 0; i < 50'000; ++i) dotted += ".a";
    CHECK(parse_error(dotted + " = 1") ==
          "x.toml:2: is longer than 4096 characters; break the line");
    CHECK(parse_error("[" + dotted.substr(1, 4091) + "]\n") == "(no error)");
}

TEST_CASE("a name with a line break or zero bytes names no file, and does not hang",
          "[document][file]") {
    CHECK(read_error(std::string("a\nb.toml")) != "(no error)");
    CHECK(read_error(std::string(5000, 'x')) == std::string(5000, 'x') +
                                                    ": no such file; check the path");
}

}  // namespace
}  // namespace specula
