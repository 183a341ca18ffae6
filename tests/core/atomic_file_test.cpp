#include "sim/core/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/new_file.hpp"
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

template <typename Work>
std::string failure(const Work& work) {
    try {
        work();
    } catch (const SystemError& error) {
        return error.what();
    } catch (const InputError& error) {
        return std::string("the user's: ") + error.what();
    }
    return "(no error)";
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
        return failure([&] { write_file_atomically(file, content); });
    };
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
    CHECK(n_entries(folder.path()) == 1);
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

TEST_CASE("a missing folder is made, a name below a file is refused", "[atomic file]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "new" / "deep" / "x", "text");
    CHECK(content_of(folder / "new" / "deep" / "x") == "text");
    CHECK(failure([&] { write_file_atomically(folder / "new" / "deep" / "x" / "y", ""); }) ==
          "the user's: " + (folder / "new" / "deep" / "x").string() +
              ": cannot create: Not a directory; give another place");
}

TEST_CASE("a place is tried before the work, and nothing is left in it", "[atomic file]") {
    const TemporaryFolder folder;
    check_output_place(folder / "new" / "x");
    CHECK(std::filesystem::is_empty(folder / "new"));
    write_file_atomically(folder / "x", "kept");
    check_output_place(folder / "x");
    CHECK(content_of(folder / "x") == "kept");
    const auto problem = [](const std::filesystem::path& file) {
        return failure([&] { check_output_place(file); });
    };
    CHECK(problem("/proc/specula.json") ==
          "the user's: /proc/specula.json: cannot create: No such file or directory; give another "
          "place");
    CHECK(problem(folder / "new").find("is there, and is no file") != std::string::npos);
    CHECK(problem(folder / std::string(300, 'x')).find("File name too long; give another place") !=
          std::string::npos);
    CHECK(failure([&] { make_output_folder(folder / "x"); }).find("Not a directory") !=
          std::string::npos);
}

TEST_CASE("a symbolic link stays one, and what it names is replaced", "[atomic file]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "target", "old");
    std::filesystem::create_symlink(folder / "target", folder / "link");
    write_file_atomically(folder / "link", "new");
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(content_of(folder / "target") == "new");
    CHECK(n_entries(folder.path()) == 2);
}

TEST_CASE("what is no file is not replaced by one", "[atomic file]") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    std::filesystem::create_directory(folder / "folder");
    for (const char* name : {"pipe", "folder"}) {
        CHECK_THROWS_AS(write_file_atomically(folder / name, "x"), InputError);
        write_file_atomically(folder / "draft", "x");
        CHECK_THROWS_AS(publish_file(folder / "draft", folder / name), InputError);
        CHECK_FALSE(std::filesystem::is_regular_file(folder / name));
        CHECK(content_of(folder / "draft") == "x");
    }
}

TEST_CASE("a published file has its content under its final name only", "[atomic file]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "x", "old");
    write_file_atomically(folder / "draft", "new");
    publish_file(folder / "draft", folder / "x");
    CHECK(content_of(folder / "x") == "new");
    CHECK(n_entries(folder.path()) == 1);
}

TEST_CASE("a file that cannot be published stays a draft, and the error names the culprit",
          "[atomic file]") {
    const TemporaryFolder folder;
    CHECK(failure([&] { publish_file(folder / "none", folder / "x"); }) ==
          (folder / "none").string() + ": cannot open: No such file or directory");

    write_file_atomically(folder / "draft", "new");
    CHECK(failure([&] { publish_file(folder / "draft", folder / "none" / "x"); }) ==
          (folder / "none" / "x").string() + ": cannot replace: No such file or directory");
    CHECK(content_of(folder / "draft") == "new");
    CHECK(n_entries(folder.path()) == 1);
}

/// The number of a process that has ended.
int ended_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

TEST_CASE("drafts of ended processes go, those of living ones and other files stay",
          "[atomic file]") {
    const TemporaryFolder folder;
    const std::string dead = std::to_string(ended_process());
    const std::string own = std::to_string(::getpid());
    for (const std::string& name : {"x.h5.draft-" + dead, "x.h5.draft-" + dead + "-3",
                                   "x.h5.draft-" + own, "y.h5.draft-" + dead,
                                   std::string("x.h5.draft-"), std::string("x.h5")})
        std::ofstream(folder / name) << "half";
    const int held = ::open((folder / ("x.h5.draft-" + dead + "-3")).c_str(), O_RDONLY);
    REQUIRE(::flock(held, LOCK_EX | LOCK_NB) == 0);  // as another machine's process would
    remove_abandoned_drafts(folder / "x.h5");
    CHECK_FALSE(std::filesystem::exists(folder / ("x.h5.draft-" + dead)));
    CHECK(n_entries(folder.path()) == 5);
    ::close(held);
    remove_abandoned_drafts(folder / "x.h5");
    CHECK(n_entries(folder.path()) == 4);
}

TEST_CASE("a new file never replaces one that appeared meanwhile", "[atomic file]") {
    const TemporaryFolder folder;
    const auto draft = folder / "x.h5.draft", file = folder / "x.h5";
    std::ofstream(draft) << "mine";
    std::ofstream(file) << "theirs";
    CHECK(failure([&] { publish_new_file(draft, file); }).find("x.h5: was made by another process") !=
          std::string::npos);
    CHECK(content_of(file) == "theirs");
    CHECK(content_of(draft) == "mine");
    std::filesystem::remove(file);
    publish_new_file(draft, file);
    CHECK(content_of(file) == "mine");
    CHECK(n_entries(folder.path()) == 1);
}

TEST_CASE("a link to what is not there yet is followed, not replaced", "[atomic file]") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "far");
    std::filesystem::create_symlink("far/target", folder / "second");
    std::filesystem::create_symlink(folder / "second", folder / "link");
    write_file_atomically(folder / "link", "text");
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(std::filesystem::is_symlink(folder / "second"));
    CHECK(content_of(folder / "far" / "target") == "text");
    std::filesystem::create_symlink("round", folder / "round");
    CHECK(failure([&] { write_file_atomically(folder / "round", "text"); }).find("cannot follow") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
