#include "tools/firmware/target_build.hpp"

#include <fstream>
#include <sstream>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/output_lock.hpp"
#include "tools/firmware/process.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr const char* compiler_packages = "gcc-arm-none-eabi libnewlib-arm-none-eabi";

/// mps2-an386 counts SysTick at 25 MHz; with one instruction per nanosecond that is one tick in 40.
constexpr double instructions_per_tick = 40.0;
constexpr int bench_repeats = 200;

/// What the cache says of one of CMake's own entries; empty: nothing.
fs::path cached_folder(const fs::path& cache, const std::string& entry) {
    std::ifstream lines(cache);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(entry)) return line.substr(entry.size());
    return {};
}

bool is_same(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored);
}

}  // namespace

void forget_build_of_another_place(const fs::path& home, const fs::path& folder) {
    const fs::path cache = folder / "CMakeCache.txt";
    std::error_code ignored;
    if (is_same(cached_folder(cache, "CMAKE_HOME_DIRECTORY:INTERNAL="), home) &&
        is_same(cached_folder(cache, "CMAKE_CACHEFILE_DIR:INTERNAL="), folder))
        return;
    for (const char* made : {"CMakeCache.txt", "CMakeFiles", "build.ninja", ".ninja_deps"})
        fs::remove_all(folder / made, ignored);
}

TargetBuild build_for_target(const fs::path& home, const fs::path& folder) {
    output_of({{"arm-none-eabi-gcc", "--version"}, {}, compiler_packages});
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    const OutputLock turn(folder / "lock", OutputLock::Kind::in_turn);
    forget_build_of_another_place(home, folder);
    if (!fs::exists(folder / "build.ninja", ignored))
        output_of({{"cmake", "-S", home.string(), "-B", folder.string(), "-G", "Ninja",
                    "-DCMAKE_TOOLCHAIN_FILE=" + (home / "firmware/port/cortex-m4.cmake").string(),
                    "-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DSPECULA_FIRMWARE_ONLY=ON"},
                   {},
                   "cmake"});
    output_of({{"cmake", "--build", folder.string(), "--target", "fw_runner"}, {}, "cmake"});
    return {.program = folder / "fw_runner.elf",
            .map = folder / "fw_runner.map",
            .archive = folder / "libspecula_firmware.a",
            .folder = folder};
}

std::string emulate(const TargetBuild& build, const Emulation& emulation) {
    std::string semihosting = "enable=on,target=native,chardev=said,arg=fw_runner";
    for (const std::string& argument : emulation.arguments) semihosting += ",arg=" + argument;
    std::vector<std::string> words{"qemu-system-arm", "-M",   "mps2-an386", "-display",     "none",
                                   "-monitor",        "none", "-chardev",   "stdio,id=said"};
    words.insert(words.end(),
                 {"-semihosting-config", semihosting, "-serial",
                  emulation.uart.empty() ? "none" : "file:" + emulation.uart.string()});
    if (emulation.counted) words.insert(words.end(), {"-icount", "shift=0"});
    if (!emulation.trace.empty())
        words.insert(words.end(),
                     {"-singlestep", "-d", "exec,nochain", "-D", emulation.trace.string()});
    words.insert(words.end(), {"-kernel", build.program.string()});
    return output_of({words, emulation.folder, "qemu-system-arm"});
}

std::map<std::string, double> count_instructions(const TargetBuild& build, const fs::path& folder,
                                                 const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"bench"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.push_back(format("{}", bench_repeats));
    const std::string output = emulate(
        build, {.arguments = all, .folder = folder, .uart = {}, .counted = true, .trace = {}});
    std::map<std::string, double> counts;
    std::istringstream lines(output);
    for (std::string word, name; lines >> word;) {
        double ticks = 0.0;
        if (word == "stage" && lines >> name >> ticks)
            counts[name] = ticks * instructions_per_tick / bench_repeats;
    }
    if (counts.count("empty") == 0 || counts.size() < 2)
        throw SystemError("fw_runner bench: printed no stages; look at firmware/port/fw_bench.c");
    const double empty = counts["empty"];
    counts.erase("empty");
    for (auto& [name, count] : counts) count -= empty;
    return counts;
}

}  // namespace specula
