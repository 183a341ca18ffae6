#include "tools/firmware/cycle_model.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <unordered_map>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/firmware/process.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

bool begins(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

bool is_any(const std::string& mnemonic, std::initializer_list<const char*> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const char* beginning) { return begins(mnemonic, beginning); });
}

/// Registers in the braces of a push or an ldm: "{r4, r6-r8, lr}" has 5.
int count_registers(const std::string& operands) {
    const std::size_t open = operands.find('{');
    if (open == std::string::npos) return 1;
    std::istringstream list(operands.substr(open + 1, operands.find('}') - open - 1));
    int count = 0;
    for (std::string item; std::getline(list, item, ',');) {
        const std::size_t dash = item.find('-');
        count += 1;
        if (dash == std::string::npos) continue;
        const auto number = [](const std::string& text) {
            return std::atoi(text.c_str() + text.find_first_of("0123456789"));
        };
        count += number(item.substr(dash)) - number(item.substr(0, dash));
    }
    return count;
}

/// Whether the first operand of one floating-point instruction is read by the next.
bool is_waited_for(const Instruction& instruction, const Instruction& next) {
    const std::string result = instruction.operands.substr(0, instruction.operands.find(','));
    if (result.empty() || result[0] != 's') return false;
    const std::size_t sources = begins(next.mnemonic, "vcmp") || begins(next.mnemonic, "vstr")
                                    ? 0
                                    : next.operands.find(',');
    if (next.mnemonic.empty() || next.mnemonic[0] != 'v' || sources == std::string::npos)
        return false;
    std::string read = next.operands.substr(sources) + ",";
    for (char& c : read)
        if (c == ' ') c = ',';
    return read.find("," + result + ",") != std::string::npos || begins(read, result + ",");
}

bool is_single_access(const std::string& name) {
    return is_any(name, {"ldr", "str", "vldr", "vstr"}) && !is_any(name, {"ldrd", "strd"});
}

/// A load or store: 2 cycles, of which the next one hides 1 if it is a load or store as well.
CycleRange single_access(const Instruction& next) {
    return is_single_access(next.mnemonic) ? CycleRange{1, 1} : CycleRange{1, 2};
}

CycleRange floating_point(const Instruction& instruction, const Instruction& next) {
    const std::string& name = instruction.mnemonic;
    if (is_any(name, {"vdiv", "vsqrt"})) return {14, 14};
    const double wait = is_waited_for(instruction, next) ? 1 : 0;
    if (is_any(name, {"vmla", "vmls", "vnmla", "vnmls", "vfma", "vfms", "vfnm"}))
        return {3 + wait, 3 + wait};
    if (is_any(name, {"vldr", "vstr"})) return single_access(next);
    if (is_any(name, {"vldm", "vstm", "vpush", "vpop"})) {
        const double n = count_registers(instruction.operands);
        return {1 + n, 1 + n};
    }
    return {1 + wait, 1 + wait};
}

/// The program's instructions by address.
using Listing = std::unordered_map<std::uint32_t, std::pair<Instruction, int>>;

Listing read_listing(const fs::path& program) {
    const std::string text =
        output_of({{"arm-none-eabi-objdump", "-d", "--no-show-raw-insn", program.string()},
                   {},
                   "binutils-arm-none-eabi"});
    Listing listing;
    std::istringstream lines(text);
    std::uint32_t last = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(":\t");
        std::uint32_t address = 0;
        const char* begin = line.c_str() + std::min(line.find_first_not_of(' '), line.size());
        if (colon == std::string::npos ||
            std::from_chars(begin, line.c_str() + colon, address, 16).ec != std::errc{})
            continue;
        const std::string rest = line.substr(colon + 2);
        const std::size_t tab = rest.find('\t');
        std::string operands = tab == std::string::npos ? "" : rest.substr(tab + 1);
        operands = operands.substr(0, operands.find_first_of("@;<"));
        listing[address] = {{rest.substr(0, tab), operands}, 2};
        if (last != 0 && address == last + 4) listing[last].second = 4;
        last = address;
    }
    return listing;
}

std::uint32_t address_of(const fs::path& program, const std::string& symbol) {
    std::istringstream lines(
        output_of({{"arm-none-eabi-nm", program.string()}, {}, "binutils-arm-none-eabi"}));
    for (std::string address, kind, name; lines >> address >> kind >> name;)
        if (name == symbol) return static_cast<std::uint32_t>(std::stoul(address, nullptr, 16));
    throw SystemError(format("{}: has no symbol {}", program.string(), symbol));
}

/// Calls visit with the addresses of the instructions between each pair of marks.
template <typename Visit>
void for_each_marked_part(const fs::path& trace, std::uint32_t mark, Visit visit) {
    std::ifstream stream(trace);
    std::vector<std::uint32_t> part;
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        const std::size_t slash = line.find('/');  // Trace 0: 0x7f.. [00000000/00400344/..] name
        std::uint32_t address = 0;
        if (slash == std::string::npos ||
            std::from_chars(line.c_str() + slash + 1, line.c_str() + slash + 9, address, 16).ec !=
                std::errc{})
            continue;
        if (address == mark) {
            if (inside) visit(part);
            inside = !inside;
            part.clear();
        } else if (inside) {
            part.push_back(address);
        }
    }
}

CycleRange price(const std::vector<std::uint32_t>& part, const Listing& listing) {
    CycleRange sum;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const auto found = listing.find(part[i]);
        if (found == listing.end())
            throw SystemError("trace: an instruction that the program's listing does not hold");
        const auto& [instruction, bytes] = found->second;
        const bool is_last = i + 1 == part.size();
        const auto next = is_last ? listing.end() : listing.find(part[i + 1]);
        const bool taken = !is_last && part[i + 1] != part[i] + static_cast<std::uint32_t>(bytes);
        sum = sum + cycles_of(instruction, taken,
                              next == listing.end() ? Instruction{} : next->second.first);
    }
    return sum;
}

}  // namespace

CycleRange cycles_of(const Instruction& instruction, bool taken, const Instruction& next) {
    const std::string& name = instruction.mnemonic;
    const CycleRange refill = taken ? CycleRange{1, 3} : CycleRange{0, 0};
    if (name.empty()) return {};
    if (name[0] == 'v') return floating_point(instruction, next);
    if (is_any(name, {"it"})) return {0, 1};  // it, ite, itt: may be folded into the one before
    if (is_any(name, {"push", "pop", "ldm", "stm", "ldrd", "strd"})) {
        const double n = is_any(name, {"ldrd", "strd"}) ? 2 : count_registers(instruction.operands);
        return CycleRange{1 + n, 1 + n} + refill;
    }
    if (is_any(name, {"ldr", "str"})) return single_access(next) + refill;
    if (is_any(name, {"sdiv", "udiv"})) return {2, 12};
    if (is_any(name, {"tbb", "tbh"})) return CycleRange{2, 2} + refill;
    return CycleRange{1, 1} + refill;
}

std::map<std::string, CycleRange> estimate_cycles(const TargetBuild& build, const fs::path& folder,
                                                  const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"bench"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.push_back("1");
    const fs::path trace = folder / "trace.log";
    const std::string said = emulate(
        build, {.arguments = all, .folder = folder, .uart = {}, .counted = false, .trace = trace});
    const Listing listing = read_listing(build.program);
    std::vector<CycleRange> parts;
    for_each_marked_part(trace, address_of(build.program, "fw_bench_mark"),
                         [&](const auto& part) { parts.push_back(price(part, listing)); });
    std::error_code ignored;
    fs::remove(trace, ignored);

    std::map<std::string, CycleRange> cycles;
    std::istringstream words(said);
    std::size_t stage = 0;
    for (std::string word, name; words >> word;)
        if (word == "stage" && words >> name && stage < parts.size()) cycles[name] = parts[stage++];
    if (stage != parts.size() || cycles.count("empty") == 0)
        throw SystemError("fw_runner bench: its trace and its stages do not fit together");
    const CycleRange empty = cycles["empty"];
    cycles.erase("empty");
    for (auto& [name, range] : cycles) range = {range.low - empty.low, range.high - empty.high};
    return cycles;
}

}  // namespace specula
