#include "tools/specula/output_place.hpp"

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"

namespace specula {
namespace {

TEST_CASE("no output replaces an input, whatever it is called", "[output place]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "data.h5", "x");
    std::filesystem::create_symlink(folder / "data.h5", folder / "link.h5");
    std::filesystem::create_hard_link(folder / "data.h5", folder / "twin.h5");
    for (const char* name : {"data.h5", "link.h5", "twin.h5", "./data.h5"})
        CHECK_THROWS_AS(prepare_output(folder / name, {"", folder / "data.h5"}), InputError);
    CHECK_NOTHROW(prepare_output(folder / "other.h5", {folder / "data.h5", folder / "missing"}));
    CHECK_FALSE(std::filesystem::exists(folder / "other.h5"));
}

TEST_CASE("the folder of an output is made, or the error names it", "[output place]") {
    const TemporaryFolder folder;
    prepare_output(folder / "new" / "deep" / "x.h5", {});
    CHECK(std::filesystem::is_directory(folder / "new" / "deep"));
    write_file_atomically(folder / "file", "x");
    CHECK_THROWS_AS(prepare_output(folder / "file" / "x.h5", {}), InputError);
}

}  // namespace
}  // namespace specula
