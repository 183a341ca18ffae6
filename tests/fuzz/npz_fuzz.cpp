#include "sim/recording/zip_archive.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// An .npz archive: directory, members, checksums.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads([=] {
        const specula::ZipArchive archive({data, size});
        for (const std::string& name : archive.names()) archive.extract(name);
    });
}
