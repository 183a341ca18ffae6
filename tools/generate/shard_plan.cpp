#include "tools/generate/shard_plan.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20;  ///< of codes in a shard
constexpr std::size_t usual_sessions = 64;
constexpr std::size_t few_shards = 1024;
constexpr std::size_t most_shares = 1'000'000;

using Variable = std::function<std::string(const std::string&)>;

std::size_t whole_number(const std::string& text, const std::string& what) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value > most_shares)
        throw InputError(
            format("--shard: {} = \"{}\" is no whole number up to {}; write it as "
                   "INDEX/COUNT, such as 0/8, or env",
                   what, text, most_shares));
    return value;
}

Share checked(const Share& share, const std::string& text) {
    if (share.count == 0)
        throw InputError(format(
            "--shard {}: is a share of none; write INDEX/COUNT with a COUNT from 1, such as 0/8",
            text));
    if (share.index >= share.count)
        throw InputError(format("--shard {}: is none of the shares, which are {}", text,
                                share.count == 1 ? std::string("0/1 alone")
                                                 : format("0/{0} to {1}/{0}", share.count,
                                                          share.count - 1)));
    return share;
}

Share of_slurm(const Variable& variable) {
    const auto number = [&](const std::string& name, const std::string& fallback) {
        const std::string text = variable(name);
        return whole_number(text.empty() ? fallback : text, name);
    };
    const std::size_t id = number("SLURM_ARRAY_TASK_ID", "");
    const std::size_t first = number("SLURM_ARRAY_TASK_MIN", "0");
    const std::size_t step = std::max<std::size_t>(1, number("SLURM_ARRAY_TASK_STEP", "1"));
    const Share share{.index = (id - first) / step, .count = number("SLURM_ARRAY_TASK_COUNT", "")};
    if (id < first || (id - first) % step != 0)
        throw InputError(
            "--shard env: SLURM_ARRAY_TASK_ID is not of the array that the other "
            "variables describe; write --shard INDEX/COUNT");
    return checked(share, "env");
}

Share of_environment(const Variable& variable) {
    if (!variable("SLURM_ARRAY_TASK_ID").empty()) return of_slurm(variable);
    if (!variable("OMPI_COMM_WORLD_RANK").empty())
        return checked(
            {.index = whole_number(variable("OMPI_COMM_WORLD_RANK"), "OMPI_COMM_WORLD_RANK"),
             .count = whole_number(variable("OMPI_COMM_WORLD_SIZE"), "OMPI_COMM_WORLD_SIZE")},
            "env");
    throw InputError(
        "--shard env: neither SLURM_ARRAY_TASK_ID nor OMPI_COMM_WORLD_RANK is set; start it with "
        "sbatch --array or mpirun, or write --shard INDEX/COUNT");
}

}  // namespace

SessionSpan ShardPlan::span(std::size_t shard) const {
    const std::size_t first = shard * sessions_per_shard;
    return {.first = first,
            .count = std::min(sessions_per_shard, n_sessions - first),
            .n_in_all = n_sessions};
}

ShardPlan plan_shards(const Recipe& recipe) {
    const std::size_t session_bytes = sizeof(std::int16_t) * recipe.codes_per_frame() *
                                      static_cast<std::size_t>(recipe.condition.frames);
    const std::size_t wanted = std::max(usual_sessions, recipe.n_sessions() / few_shards);
    const std::size_t fitting = std::max<std::size_t>(1, most_bytes / session_bytes);
    return {.n_sessions = recipe.n_sessions(), .sessions_per_shard = std::min(wanted, fitting)};
}

std::string shard_name(std::size_t shard) {
    return format("shard-{:06}.h5", shard);
}

bool is_shard(const std::filesystem::path& file) {
    return file.filename().string().rfind("shard-", 0) == 0 && file.extension() == ".h5";
}

std::vector<std::filesystem::path> stray_shards(const std::filesystem::path& folder,
                                                const ShardPlan& plan) {
    std::set<std::string> names;
    for (std::size_t shard = 0; shard < plan.n_shards(); ++shard) names.insert(shard_name(shard));
    std::vector<std::filesystem::path> strays;
    std::error_code not_there;
    for (const auto& entry : std::filesystem::directory_iterator(folder, not_there))
        if (is_shard(entry.path()) && !names.contains(entry.path().filename().string()))
            strays.push_back(entry.path());
    std::sort(strays.begin(), strays.end());
    return strays;
}

Share read_share(const std::string& text, const Variable& variable) {
    if (text.empty()) return {};
    if (text == "env") return of_environment(variable);
    const auto slash = text.find('/');
    const std::string count = slash == std::string::npos ? "" : text.substr(slash + 1);
    return checked({.index = whole_number(text.substr(0, slash), "INDEX"),
                    .count = whole_number(count, "COUNT")},
                   text);
}

}  // namespace specula
