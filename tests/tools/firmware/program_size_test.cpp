#include "tools/firmware/program_size.hpp"

#include <fstream>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"

namespace specula {
namespace {

/// A call graph as the compiler writes it.
std::string calls(const std::string& from, const std::string& to) {
    return "edge: { sourcename: \"" + from + "\" targetname: \"" + to + "\" label: \"x.c:1:1\" }\n";
}
std::string frame(const std::string& function, const std::string& size) {
    return "node: { title: \"" + function + "\" label: \"" + function + "\\nx.c:1:1\\n" + size +
           "\" }\n";
}

StackDepth depth_of(const std::string& text) {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.c.ci") << text;
    return deepest_stack(folder.path(), "top");
}

TEST_CASE("the deepest stack is that of the worst way down", "[stack]") {
    const StackDepth depth =
        depth_of(frame("top", "16 bytes (static)") + frame("wide", "100 bytes (static)") +
                 frame("near", "40 bytes (static)") + frame("far", "80 bytes (static)") +
                 calls("top", "wide") + calls("top", "near") + calls("near", "far") +
                 calls("near", "memcpy"));
    CHECK(depth.bytes == 16 + 40 + 80);
    CHECK(depth.path == std::vector<std::string>{"top", "near", "far"});
}

TEST_CASE("recursion and frames without a bound are refused", "[stack]") {
    CHECK_THROWS_AS(depth_of(frame("top", "8 bytes (static)") + frame("b", "8 bytes (static)") +
                             calls("top", "b") + calls("b", "top")),
                    SystemError);
    CHECK_THROWS_AS(depth_of(frame("top", "8 bytes (dynamic)")), SystemError);
    CHECK_THROWS_AS(depth_of(""), SystemError);
}

TEST_CASE("every public function has its own depth, the deepest first", "[stack]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.c.ci")
        << frame("fw_shallow", "8 bytes (static)") + frame("fw_deep", "100 bytes (static)") +
               frame("a/x.c:fw_hidden", "400 bytes (static)") + frame("main", "90 bytes (static)") +
               frame("fw_middle", "16 bytes (static)") + calls("fw_middle", "fw_shallow") +
               calls("fw_deep", "a/x.c:fw_hidden") + calls("fw_deep", "fw_elsewhere");
    const std::vector<StackDepth> depths = public_stacks(folder.path());
    REQUIRE(depths.size() == 3);
    CHECK(depths[0].bytes == 500);
    CHECK(depths[0].path == std::vector<std::string>{"fw_deep", "a/x.c:fw_hidden"});
    CHECK(depths[1].bytes == 24);
    CHECK(depths[2].path == std::vector<std::string>{"fw_shallow"});
}

TEST_CASE("what a library calls and does not hold is foreign", "[size]") {
    const auto foreign = foreign_symbols(
        "\nfw_a.c.obj:\n00000000 T fw_a\n         U fw_b\n         U memcpy\n"
        "         U __aeabi_uldivmod\n\nfw_b.c.obj:\n00000010 t static_one\n00000000 T fw_b\n");
    CHECK(foreign == std::vector<std::string>{"__aeabi_uldivmod", "memcpy"});
    CHECK(is_allowed_foreign("memcpy"));
    CHECK_FALSE(is_allowed_foreign("__aeabi_uldivmod"));
}

TEST_CASE("the map's sections are summed by module, those left out are not", "[size]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "x.map")
        << "Discarded input sections\n"
           " .text.unused  0x0000000000000000  0x99 libspecula_firmware.a(fw_a.c.obj)\n"
           "Linker script and memory map\n"
           " .text.fw_a    0x0000000000400010  0x20 libspecula_firmware.a(fw_a.c.obj)\n"
           " .text.fw_a_with_a_long_name\n"
           "                0x0000000000400030  0x10 libspecula_firmware.a(fw_a.c.obj)\n"
           " .rodata.t     0x0000000000400100  0x8 libspecula_firmware.a(fw_a.c.obj)\n"
           " .bss.x        0x0000000000460000  0x4 libspecula_firmware.a(fw_b.c.obj)\n"
           " .text.main    0x0000000000400200  0x40 CMakeFiles/fw_runner.dir/fw_runner.c.obj\n";
    const auto sizes = read_module_sizes(folder / "x.map");
    REQUIRE(sizes.size() == 2);
    CHECK(sizes.at("fw_a.c").code == 0x30);
    CHECK(sizes.at("fw_a.c").constants == 8);
    CHECK(sizes.at("fw_b.c").ram == 4);
}

}  // namespace
}  // namespace specula
