#include "firmware/fw_selftest.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "tests/check.hpp"

namespace {

std::string output_of(const std::string& command) {
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    std::array<char, 4096> block{};
    while (const auto n = std::fread(block.data(), 1, block.size(), pipe))
        text.append(block.data(), n);
    pclose(pipe);
    return text;
}

}  // namespace

TEST_CASE("this machine passes the self-test, part by part", "[firmware]") {
    std::vector<float> scratch(fw_selftest_scratch() / sizeof(float));
    fw_selftest_report report{};
    CHECK(fw_selftest(scratch.data(), scratch.size() * sizeof(float), &report) == FW_OK);
    CHECK(report.checksum);
    CHECK(report.profile);
    CHECK(report.shape);
    CHECK(report.hwa_like);
    CHECK(report.network);
    CHECK(report.softmax);
    CHECK(report.subnormal);
}

#if defined(__SSE__)
TEST_CASE("a machine that flushes subnormal numbers, in or out, fails the self-test and is named",
          "[firmware]") {
    const unsigned mode = GENERATE(0x8000u, 0x0040u);  // MXCSR: flush to zero, denormals are zero
    std::vector<float> scratch(fw_selftest_scratch() / sizeof(float));
    fw_selftest_report report{};
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | mode);
    const fw_status status = fw_selftest(scratch.data(), scratch.size() * sizeof(float), &report);
    _mm_setcsr(before);
    CHECK(status == FW_ERR_SELF_TEST);
    CHECK_FALSE(report.subnormal);
    CHECK(report.network);
    CHECK(report.profile);
}
#endif

TEST_CASE("the stored results are those of the independent statement in Python", "[firmware]") {
    const std::string folder = SPECULA_SOURCE_DIR "/firmware/";
    const std::string again = output_of("python3 '" + folder + "generate_golden.py' 2>&1");
    std::ifstream stream(folder + "fw_golden.c");
    const std::string committed{std::istreambuf_iterator<char>(stream), {}};
    REQUIRE(committed.size() > 2000);
    CHECK(again == committed);
}

TEST_CASE("the tables are those their generator writes", "[firmware]") {
    const std::string folder = SPECULA_SOURCE_DIR "/firmware/";
    const std::string again = output_of("python3 '" + folder + "generate_tables.py' 2>&1");
    std::ifstream stream(folder + "fw_tables.c");
    const std::string committed{std::istreambuf_iterator<char>(stream), {}};
    REQUIRE(committed.size() > 2000);
    CHECK(again == committed);
}

TEST_CASE("the self-test refuses scratch that is missing or too small", "[firmware]") {
    std::vector<float> scratch(fw_selftest_scratch() / sizeof(float));
    fw_selftest_report report{};
    CHECK(fw_selftest(scratch.data(), fw_selftest_scratch() - 1, &report) == FW_ERR_SCRATCH);
    CHECK(fw_selftest(nullptr, 100000, &report) == FW_ERR_NULL);
    CHECK(fw_selftest(scratch.data(), fw_selftest_scratch(), nullptr) == FW_ERR_NULL);
    CHECK_FALSE(report.checksum);
}
