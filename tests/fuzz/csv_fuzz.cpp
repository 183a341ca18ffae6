#include "sim/recording/csv_rows.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// A table of comma-separated values, its cells as numbers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return specula::refuses_or_reads([=] {
        const specula::CsvRows table = specula::read_csv({data, size});
        for (std::size_t i = 0; i < table.rows.size(); ++i)
            specula::csv_number(table.rows[i][0], table.columns[0], table.offset[i]);
    });
}
