#include "tools/generate/manifest.hpp"

#include <fstream>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

const std::string a(64, 'a'), b(64, 'b');

TEST_CASE("what is appended comes back, from all manifests of a folder", "[generate]") {
    const TemporaryFolder folder;
    append_to_manifest(folder / "manifest-0-of-2.sha256", "shard-000000.h5", a);
    append_to_manifest(folder / "manifest-0-of-2.sha256", "shard-000002.h5", b);
    append_to_manifest(folder / "manifest-1-of-2.sha256", "shard-000001.h5", b);
    std::ofstream(folder / "notes.sha256") << "not ours\n";
    const ShardHashes hashes = read_manifests(folder.path());
    CHECK(hashes ==
          ShardHashes{{"shard-000000.h5", a}, {"shard-000001.h5", b}, {"shard-000002.h5", b}});
    CHECK(manifest_text(hashes) ==
          a + "  shard-000000.h5\n" + b + "  shard-000001.h5\n" + b + "  shard-000002.h5\n");
}

TEST_CASE("a line that a kill cut short does not count, and the next one stands alone",
          "[generate]") {
    const TemporaryFolder folder;
    const auto file = folder / "manifest.sha256";
    const std::string whole = a + "  shard-000000.h5\n" + b + "  shard-000001.h5\n";
    for (std::size_t cut = 82; cut < whole.size(); ++cut) {
        std::ofstream(file, std::ios::trunc) << whole.substr(0, cut);
        CHECK(read_manifests(folder.path()) == ShardHashes{{"shard-000000.h5", a}});
        append_to_manifest(file, "shard-000007.h5", b);
        CHECK(read_manifests(folder.path()) ==
              ShardHashes{{"shard-000000.h5", a}, {"shard-000007.h5", b}});
    }
}

TEST_CASE("two hashes of one shard tell of a broken machine", "[generate]") {
    const TemporaryFolder folder;
    append_to_manifest(folder / "manifest-0-of-2.sha256", "shard-000000.h5", a);
    append_to_manifest(folder / "manifest-1-of-2.sha256", "shard-000000.h5", b);
    CHECK(message_of([&] {
              return read_manifests(folder.path());
          }).find("gives shard-000000.h5 another hash") != std::string::npos);
}

TEST_CASE("what is no manifest is refused by line", "[generate]") {
    const TemporaryFolder folder;
    for (const std::string& line :
         {std::string("hello"), a + " shard", a + "  ../shard", "z" + a}) {
        std::ofstream(folder / "manifest.sha256", std::ios::trunc) << a << "  shard-000000.h5\n"
                                                                   << line << "\n";
        INFO(line);
        CHECK(message_of([&] {
                  return read_manifests(folder.path());
              }).find("manifest.sha256:2: is not a hash and a name") != std::string::npos);
    }
}

TEST_CASE("a manifest in a folder that is not there is a failure of the system", "[generate]") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(append_to_manifest(folder / "none" / "manifest.sha256", "shard-000000.h5", a),
                    SystemError);
}

}  // namespace
}  // namespace specula
