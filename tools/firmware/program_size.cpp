#include "tools/firmware/program_size.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t begin = text.find(before);
    if (begin == std::string::npos) return "";
    const std::size_t from = begin + before.size();
    return text.substr(from, text.find(after, from) - from);
}

void add_section(const std::string& section, std::size_t bytes, ModuleSize& size) {
    if (section.rfind(".text", 0) == 0) size.code += bytes;
    if (section.rfind(".rodata", 0) == 0) size.constants += bytes;
    if (section.rfind(".data", 0) == 0 || section.rfind(".bss", 0) == 0) size.ram += bytes;
}

struct Frame {
    std::size_t bytes = 0;
    bool is_defined = false;  ///< here, not just called
    std::set<std::string> calls;
};
using CallGraph = std::map<std::string, Frame>;

void read_node(const std::string& line, const std::string& file, CallGraph& graph) {
    const std::string label = between(line, "label: \"", "\"");
    const std::size_t size_at = label.rfind("\\n");
    const std::string size = size_at == std::string::npos ? "" : label.substr(size_at + 2);
    if (size.find(" bytes (") == std::string::npos) return;  // a function of another file
    if (size.find("(dynamic)") != std::string::npos)
        throw SystemError(format("{}: a frame of unbounded size: {}", file, label));
    Frame& frame = graph[between(line, "title: \"", "\"")];
    frame.bytes = static_cast<std::size_t>(std::strtoul(size.c_str(), nullptr, 10));
    frame.is_defined = true;
}

CallGraph read_call_graph(const fs::path& folder) {
    CallGraph graph;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".ci") continue;
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);) {
            if (line.rfind("node:", 0) == 0) read_node(line, entry.path().string(), graph);
            if (line.rfind("edge:", 0) == 0)
                graph[between(line, "sourcename: \"", "\"")].calls.insert(
                    between(line, "targetname: \"", "\""));
        }
    }
    if (graph.empty())
        throw SystemError(format("{}: holds no .ci files; build there again", folder.string()));
    return graph;
}

StackDepth descend(const CallGraph& graph, const std::string& function,
                   std::vector<std::string>& above) {
    for (const std::string& caller : above)
        if (caller == function)
            throw SystemError(format("{}: calls itself; the firmware may not", function));
    const auto found = graph.find(function);
    if (found == graph.end()) return {.bytes = 0, .path = {function}};
    StackDepth deepest;
    above.push_back(function);
    for (const std::string& called : found->second.calls) {
        const StackDepth below = descend(graph, called, above);
        if (below.bytes > deepest.bytes || deepest.path.empty()) deepest = below;
    }
    above.pop_back();
    deepest.bytes += found->second.bytes;
    deepest.path.insert(deepest.path.begin(), function);
    return deepest;
}

}  // namespace

std::map<std::string, ModuleSize> read_module_sizes(const fs::path& map_file) {
    std::ifstream stream(map_file);
    if (!stream) throw SystemError(format("{}: cannot be read", map_file.string()));
    std::map<std::string, ModuleSize> modules;
    bool in_memory_map = false;
    std::string section;
    for (std::string line; std::getline(stream, line);) {
        if (line.rfind("Linker script and memory map", 0) == 0) in_memory_map = true;
        if (!in_memory_map) continue;  // before it stand the sections that were left out
        std::istringstream words(line);
        std::string address, bytes, object;
        if (line.rfind(" .", 0) == 0) words >> section;
        if (!(words >> address >> bytes >> object)) continue;
        const std::string module = between(object, "libspecula_firmware.a(", ".obj)");
        if (!module.empty())
            add_section(section, std::strtoul(bytes.c_str(), nullptr, 16), modules[module]);
    }
    return modules;
}

StackDepth deepest_stack(const fs::path& folder, const std::string& function) {
    std::vector<std::string> above;
    return descend(read_call_graph(folder), function, above);
}

std::vector<StackDepth> public_stacks(const fs::path& folder) {
    const CallGraph graph = read_call_graph(folder);
    std::vector<StackDepth> depths;
    for (const auto& [function, frame] : graph) {
        const bool is_public = function.rfind("fw_", 0) == 0 &&  // static: "folder/file.c:name"
                               function.find(':') == std::string::npos && frame.is_defined;
        std::vector<std::string> above;
        if (is_public) depths.push_back(descend(graph, function, above));
    }
    std::ranges::stable_sort(depths, std::ranges::greater{}, &StackDepth::bytes);
    return depths;
}

std::vector<std::string> foreign_symbols(const std::string& symbols) {
    std::set<std::string> called, held;
    std::istringstream lines(symbols);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first, kind, name;
        if (!(words >> first >> kind)) continue;  // the name of a member, or nothing
        if (first == "U")
            called.insert(kind);
        else if (words >> name)
            held.insert(name);
    }
    std::vector<std::string> foreign;
    std::ranges::set_difference(called, held, std::back_inserter(foreign));
    return foreign;
}

bool is_allowed_foreign(const std::string& symbol) {
    return symbol == "memcmp" || symbol == "memcpy" || symbol == "memset";
}

}  // namespace specula
