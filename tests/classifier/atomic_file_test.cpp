#include "sim/core/atomic_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"

namespace specula {
namespace {

std::string content_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::size_t n_entries(const std::filesystem::path& folder) {
    const std::filesystem::directory_iterator entries(folder);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

TEST_CASE("a file is written byte for byte, and only that file", "[atomic file]") {
    const TemporaryFolder folder;
    const std::string content("a\0\r\n\xff", 5);
    write_file_atomically(folder / "x", content);
    CHECK(content_of(folder / "x") == content);
    write_file_atomically(folder / "x", "");
    CHECK(content_of(folder / "x").empty());
    CHECK(n_entries(folder.path()) == 1);
}

TEST_CASE("a new file obeys the umask", "[atomic file]") {
    const TemporaryFolder folder;
    const mode_t kept = ::umask(027);
    write_file_atomically(folder / "x", "text");
    ::umask(kept);
    using std::filesystem::perms;
    CHECK(std::filesystem::status(folder / "x").permissions() ==
          (perms::owner_read | perms::owner_write | perms::group_read));
}

TEST_CASE("a file without a folder goes into the current one", "[atomic file]") {
    const TemporaryFolder folder;
    const auto kept = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    write_file_atomically("x", "text");
    std::filesystem::current_path(kept);
    CHECK(content_of(folder / "x") == "text");
}

TEST_CASE("who fails names path and reason, keeps the old file and leaves nothing behind",
          "[atomic file]") {
    const TemporaryFolder folder;
    const auto message = [](const std::filesystem::path& file, std::string_view content) {
        try {
            write_file_atomically(file, content);
        } catch (const SystemError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(message(folder / "none" / "x", "text") ==
          (folder / "none" / "x").string() + ": cannot create: No such file or directory");

    std::filesystem::create_directory(folder / "taken");
    CHECK(message(folder / "taken", "text") ==
          (folder / "taken").string() + ": cannot replace: Is a directory");

    write_file_atomically(folder / "x", "old");
    struct rlimit kept {};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &kept) == 0);
    struct rlimit small = kept;
    small.rlim_cur = 100;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
    const std::string too_large = message(folder / "x", std::string(1000, 'x'));
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &kept) == 0);
    std::signal(SIGXFSZ, handler);
    CHECK(too_large.find(": cannot write: File too large") != std::string::npos);
    CHECK(content_of(folder / "x") == "old");
    CHECK(n_entries(folder.path()) == 2);
}

TEST_CASE("a reader never sees a part of a file that is being replaced", "[atomic file]") {
    const TemporaryFolder folder;
    const std::string contents[]{std::string(200'000, 'a'), std::string(150'000, 'b')};
    write_file_atomically(folder / "x", contents[0]);
    std::vector<std::thread> writers;
    for (const std::string& content : contents)
        writers.emplace_back([&] {
            for (int i = 0; i < 10; ++i) write_file_atomically(folder / "x", content);
        });
    bool whole = true;
    for (int i = 0; i < 50; ++i) {
        const std::string seen = content_of(folder / "x");
        whole = whole && (seen == contents[0] || seen == contents[1]);
    }
    for (std::thread& writer : writers) writer.join();
    CHECK(whole);
}

}  // namespace
}  // namespace specula
