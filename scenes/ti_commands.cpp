#include "scenes/ti_commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

struct KnownCommand {
    const char* name;
    std::vector<std::size_t> counts;  ///< of arguments, as firmware of different age takes them
};

/// Command set of the xWRL6432 demos (CLI help in xWRL6432-adc-reader and OpenWaves).
const std::vector<KnownCommand>& known_commands() {
    static const std::vector<KnownCommand> commands{
        {"channelCfg", {3}},      {"chirpComnCfg", {7}},     {"chirpTimingCfg", {5}},
        {"frameCfg", {6}},        {"antGeometryCfg", {14}},  {"guiMonitor", {11, 12}},
        {"sigProcChainCfg", {8}}, {"cfarCfg", {12}},         {"aoaFovCfg", {4}},
        {"rangeSelCfg", {2}},     {"clutterRemoval", {1}},   {"compRangeBiasAndRxChanPhase", {13}},
        {"adcDataSource", {2}},   {"adcLogging", {1, 2, 5}}, {"lowPowerCfg", {1}},
        {"factoryCalibCfg", {5}}, {"mpdBoundaryBox", {7}},   {"sensorPosition", {5}},
        {"minorStateCfg", {8}},   {"majorStateCfg", {6}},    {"clusterCfg", {3}},
        {"baudRate", {1}},        {"sensorStart", {4}},      {"sensorStop", {1}},
    };
    return commands;
}

std::string counts_text(const std::vector<std::size_t>& counts) {
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
        text += (i == 0 ? "" : " or ") + std::to_string(counts[i]);
    return text;
}

bool is_number(const std::string& word, double& value) {
    char* end = nullptr;
    value = std::strtod(word.c_str(), &end);  // takes 0x1ff000 too
    return end != word.c_str() && *end == '\0' && std::isfinite(value);
}

/// Words that hold only printable ASCII, for messages.
std::string printable(std::string word) {
    for (char& c : word)
        if (c < ' ' || c > '~') c = '?';
    if (word.size() > 40) word.replace(37, std::string::npos, "...");
    return word;
}

void check(const TiCommand& command, std::vector<std::string>& warnings) {
    const std::string place = format("{}:{}: {}: ", command.file, command.line, command.name);
    const auto& all = known_commands();
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const auto& each) { return each.name == command.name; });
    if (known == all.end()) {
        std::vector<std::string> names;
        for (const auto& each : all) names.push_back(each.name);
        const std::string near = nearest_word(command.name, names);
        warnings.push_back(place + "is not known and has no effect" +
                           (near.empty() ? "" : "; did you mean " + near + "?"));
        return;
    }
    const std::size_t n = command.arguments.size();
    if (std::find(known->counts.begin(), known->counts.end(), n) == known->counts.end())
        warnings.push_back(place +
                           format("has {} arguments; usual are {}", n, counts_text(known->counts)));
    const bool names_a_file = command.name == "adcDataSource";
    for (std::size_t i = 0; i < (names_a_file ? std::min<std::size_t>(n, 1) : n); ++i)
        command.number_or(i, format("argument {}", i + 1), 0.0);
}

}  // namespace

double TiCommand::number_or(std::size_t i, const std::string& what, double fallback) const {
    if (i >= arguments.size()) return fallback;
    double value = 0.0;
    if (!is_number(arguments[i], value)) fail(i, what, "is not a number", "give a number");
    return value;
}

int TiCommand::whole_or(std::size_t i, const std::string& what, int fallback) const {
    const double value = number_or(i, what, fallback);
    if (value != std::round(value) || std::abs(value) > 1e9)
        fail(i, what, "is not a whole number", "give a whole number");
    return static_cast<int>(value);
}

void TiCommand::fail(std::size_t i, const std::string& what, const std::string& problem,
                     const std::string& remedy) const {
    const std::string value = i < arguments.size() ? printable(arguments[i]) : "(missing)";
    throw InputError(
        format("{}:{}: {} {} = {}: {}; {}", file, line, name, what, value, problem, remedy));
}

TiCommandFile TiCommandFile::read(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        throw InputError(path.string() + (std::filesystem::exists(path, ignored)
                                              ? ": is no file; name a .cfg"
                                              : ": no such file; check the path"));
    if (std::filesystem::file_size(path, ignored) > (1u << 20))
        throw InputError(path.string() + ": is larger than 1 MiB; a .cfg is text of a few kB");
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return parse(text.str(), path.string());
}

TiCommandFile TiCommandFile::parse(const std::string& text, const std::string& name) {
    TiCommandFile result;
    result.file = name;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::istringstream lines(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size())
                                                               : text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line = line.substr(0, line.find('%'));
        std::istringstream words(line);
        TiCommand command{.file = name, .line = number, .name = {}, .arguments = {}};
        if (!(words >> command.name)) continue;
        command.name = printable(command.name);
        for (std::string word; words >> word;) command.arguments.push_back(word);
        check(command, result.warnings);
        result.commands.push_back(command);
    }
    return result;
}

const TiCommand* TiCommandFile::find(const std::string& name) const {
    const auto found = std::find_if(commands.rbegin(), commands.rend(),
                                    [&](const auto& each) { return each.name == name; });
    return found == commands.rend() ? nullptr : &*found;
}

const TiCommand& TiCommandFile::need(const std::string& name) const {
    if (const TiCommand* command = find(name)) return *command;
    throw InputError(
        format("{}: {}: is missing; a radar needs chirpComnCfg and chirpTimingCfg", file, name));
}

}  // namespace specula
