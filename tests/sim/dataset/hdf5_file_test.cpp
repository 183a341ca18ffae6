#include "sim/dataset/hdf5_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> entries(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

/// What SystemError says that `work` throws.
template <typename Work>
std::string failure_of(const Work& work) {
    try {
        work();
    } catch (const SystemError& error) {
        return error.what();
    }
    return "(no error)";
}

/// Lets no file of this process grow beyond a size: a disk that is full.
class FullDisk {
  public:
    explicit FullDisk(rlim_t most_bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        signal_before_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{most_bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, signal_before_);
    }

  private:
    rlimit before_{};
    void (*signal_before_)(int);
};

TEST_CASE("tables of every type come back with shape and values", "[dataset]") {
    const TemporaryFolder folder;
    Hdf5File out = Hdf5File::create(folder / "a.h5");
    out.create_group("/group");
    out.write<std::int16_t>("/a", {2, 3}, 1, {-32768, 0, 1, 2, 3, 32767});
    out.write<std::int32_t>("/group/b", {1}, 5, {-2147483647});
    out.write<std::uint8_t>("/c", {2, 1, 1}, 2, {0, 255});
    out.write<float>("/d", {3}, 2, {0.1f, -0.0f, 3e38f});
    out.write<double>("/e", {1, 1}, 1, {1e-310});
    out.publish();

    const Hdf5File in = Hdf5File::open(folder / "a.h5");
    CHECK(in.shape("/a") == std::vector<std::size_t>{2, 3});
    CHECK(in.read<std::int16_t>("/a") == std::vector<std::int16_t>{-32768, 0, 1, 2, 3, 32767});
    CHECK(in.read<std::int32_t>("/group/b") == std::vector<std::int32_t>{-2147483647});
    CHECK(in.shape("/c") == std::vector<std::size_t>{2, 1, 1});
    CHECK(in.read<std::uint8_t>("/c") == std::vector<std::uint8_t>{0, 255});
    CHECK(in.read<float>("/d") == std::vector<float>{0.1f, -0.0f, 3e38f});
    CHECK(in.read<double>("/e") == std::vector<double>{1e-310});
}

TEST_CASE("texts and numbers come back, in any script", "[dataset]") {
    const TemporaryFolder folder;
    const std::vector<std::string> list{"a", "", "größer als andere", "雷達"};
    Hdf5File out = Hdf5File::create(folder / "a.h5");
    out.set_text("/", "text", "two\nlines");
    out.set_text("/", "none", "");
    out.set_number("/", "number", -1.5e300);
    out.set_texts("/", "list", list);
    out.publish();
    const Hdf5File in = Hdf5File::open(folder / "a.h5");
    CHECK(in.text("/", "text") == "two\nlines");
    CHECK(in.text("/", "none").empty());
    CHECK(in.number("/", "number") == -1.5e300);
    CHECK(in.texts("/", "list") == list);
}

TEST_CASE("a long constant column shrinks by the most that gzip can, and is still believed",
          "[dataset]") {
    const TemporaryFolder folder;
    const std::vector<double> zeros(1 << 20, 0.0);
    Hdf5File out = Hdf5File::create(folder / "a.h5");
    out.write("/zeros", {zeros.size()}, zeros.size(), zeros);
    out.publish();
    CHECK(fs::file_size(folder / "a.h5") < 8 * zeros.size() / 500);
    CHECK(Hdf5File::open(folder / "a.h5").read<double>("/zeros") == zeros);
}

TEST_CASE("a table is not read as another type", "[dataset]") {
    const TemporaryFolder folder;
    Hdf5File out = Hdf5File::create(folder / "a.h5");
    out.write<float>("/a", {1}, 1, {1.0f});
    out.publish();
    const Hdf5File in = Hdf5File::open(folder / "a.h5");
    CHECK(message_of([&] { return in.read<double>("/a"); }) ==
          (folder / "a.h5").string() +
              ": /a: holds another type of number; is it a dataset of this program, and whole?");
}

TEST_CASE("a table with more or fewer values than its shape is our own mistake", "[dataset]") {
    const TemporaryFolder folder;
    Hdf5File out = Hdf5File::create(folder / "a.h5");
    CHECK_THROWS_AS(out.write<float>("/a", {2, 2}, 1, {1.0f, 2.0f, 3.0f}), BrokenPromise);
}

TEST_CASE("a file that is never published leaves nothing behind", "[dataset]") {
    const TemporaryFolder folder;
    {
        Hdf5File out = Hdf5File::create(folder / "a.h5");
        out.write<float>("/a", {1}, 1, {1.0f});
        CHECK(entries(folder.path()).size() == 1);  // the draft
    }
    CHECK(entries(folder.path()).empty());
}

TEST_CASE("the old file stays until the new one is whole", "[dataset]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.h5") << "old";
    {
        Hdf5File out = Hdf5File::create(folder / "a.h5");
        CHECK(bytes_of(folder / "a.h5") == "old");
        Hdf5File moved = std::move(out);
        moved.publish();
    }
    CHECK(bytes_of(folder / "a.h5") != "old");
    CHECK(entries(folder.path()) == std::vector<std::string>{"a.h5"});
}

TEST_CASE("a folder that is missing or no folder is named, with the reason", "[dataset]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "";
    for (const fs::path& file : {folder / "none" / "a.h5", folder / "file" / "a.h5"}) {
        const std::string message = failure_of([&] { write_dataset(file, made_up_dataset()); });
        INFO(message);
        CHECK(message.rfind(file.string() + ": cannot create: ", 0) == 0);
        CHECK(message.find("unknown reason") == std::string::npos);
    }
    CHECK(entries(folder.path()) == std::vector<std::string>{"file"});
}

TEST_CASE("a name that is taken by a folder is refused and no draft is left", "[dataset]") {
    const TemporaryFolder folder;
    fs::create_directories(folder / "a.h5" / "inside");
    const std::string message = message_of([&] {
        write_dataset(folder / "a.h5", made_up_dataset());
        return 0;
    });
    CHECK(message.rfind((folder / "a.h5").string() + ": ", 0) == 0);
    CHECK(entries(folder.path()) == std::vector<std::string>{"a.h5"});
}

TEST_CASE("a full disk is reported with path and reason, leaves no draft, and ends nothing else",
          "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = made_up_dataset(400);  // some 80 kB of codes that gzip cannot shrink
    write_dataset(folder / "before.h5", dataset);
    const std::string whole = bytes_of(folder / "before.h5");
    for (const rlim_t most : {rlim_t{0}, rlim_t{1000}, rlim_t{30000}, whole.size() - 1}) {
        std::string message;
        {
            const FullDisk disk(most);
            message = failure_of([&] { write_dataset(folder / "full.h5", dataset); });
        }
        INFO(most << " bytes: " << message);
        CHECK(message.rfind((folder / "full.h5").string() + ": cannot ", 0) == 0);
        CHECK(message.find("File too large") != std::string::npos);  // the system's own words
        CHECK(message.find('\n') == std::string::npos);
        CHECK(entries(folder.path()) == std::vector<std::string>{"before.h5"});
    }
    write_dataset(folder / "after.h5", dataset);  // HDF5 is in its senses still
    CHECK(bytes_of(folder / "after.h5") == whole);
}

}  // namespace
}  // namespace specula
