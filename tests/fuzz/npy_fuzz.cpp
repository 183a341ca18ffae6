#include "sim/recording/import_arrays.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// An .npy file: header, elements as codes and as features.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads([=] {
        const specula::NpyArray array = specula::read_npy({data, size});
        for (std::size_t i = 0; i < std::min<std::size_t>(array.size(), 64); ++i)
            if (!array.is_number()) array.text(i);
        specula::Dataset dataset;
        if (specula::is_feature_table(array, {}))
            specula::take_features(array, dataset);
        else
            specula::arrange(specula::codes_of(array, true), specula::order_of(array, {}));
    });
}
