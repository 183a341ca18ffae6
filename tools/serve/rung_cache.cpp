#include "tools/serve/rung_cache.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "classifier/json_field.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr const char* set_file = "set.json";  // written last: where it is, all is

/// FNV-1a, 64 bits.
std::uint64_t hashed(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

/// Another build may simulate otherwise.
std::string build_mark() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const auto changed = fs::last_write_time(program, error).time_since_epoch().count();
    return error ? "" : format("{} {}", changed, fs::file_size(program, error));
}

fs::path cache_home() {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value ? fs::path(value) : fs::path();
    };
    if (const fs::path home = set("XDG_CACHE_HOME"); !home.empty()) return home;
    const fs::path home = set("HOME");
    return home.empty() ? home : home / ".cache";
}

FloatJson json_of(const RungSet& set) {
    FloatJson json{{"rungs", FloatJson::array()}, {"pieces", FloatJson::array()}};
    for (const Rung& rung : set.rungs) {
        FloatJson bands = FloatJson::array(), scores = FloatJson::array();
        for (const ClassBand& band : rung.bands)
            bands.push_back({{"low", band.low}, {"middle", band.middle}, {"high", band.high}});
        for (const RungScore& score : rung.scores)
            scores.push_back(
                {{"condition", score.condition}, {"macro_f1", static_cast<float>(score.macro_f1)}});
        json["rungs"].push_back({{"bands", bands}, {"scores", scores}});
    }
    for (const TrainingPiece& piece : set.pieces)
        json["pieces"].push_back({{"name", piece.name},
                                  {"thickness_mm", static_cast<float>(piece.thickness_mm)},
                                  {"bow_mm", static_cast<float>(piece.bow_mm)},
                                  {"roughness_um", static_cast<float>(piece.roughness_um)},
                                  {"correlation_mm", static_cast<float>(piece.correlation_mm)}});
    return json;
}

/// Decimal, as it was written.
double decimal(const FloatJson& value) {
    return std::stod(value.dump());
}

RungSet set_of(const FloatJson& json, const fs::path& folder) {
    RungSet set;
    for (std::size_t i = 0; i < rung_recipes.size(); ++i) {
        const FloatJson& stored = json.at("rungs").at(i);
        Rung rung{.recipe = &rung_recipes[i],
                  .model = read_model(folder / format("{}.json", rung_recipes[i].name)),
                  .bands = {},
                  .scores = {},
                  .folded = {}};
        if (!rung.model.monitor) throw InputError("a model without its monitor");
        rung.folded = fold(rung.model);
        for (const FloatJson& band : stored.at("bands"))
            rung.bands.push_back({band.at("low"), band.at("middle"), band.at("high")});
        for (const FloatJson& score : stored.at("scores"))
            rung.scores.push_back({score.at("condition"), decimal(score.at("macro_f1"))});
        set.rungs.push_back(std::move(rung));
    }
    for (const FloatJson& piece : json.at("pieces"))
        set.pieces.push_back({.name = piece.at("name"),
                              .thickness_mm = decimal(piece.at("thickness_mm")),
                              .bow_mm = decimal(piece.at("bow_mm")),
                              .roughness_um = decimal(piece.at("roughness_um")),
                              .correlation_mm = decimal(piece.at("correlation_mm"))});
    return set;
}

}  // namespace

RungCache::RungCache(const std::string& origin) : RungCache(origin, cache_home()) {}

RungCache::RungCache(const std::string& origin, const fs::path& parent) {
    if (parent.empty()) return;
    const std::string key = format("{} {} {}", program_version, build_mark(), origin);
    folder_ = parent / "specula" / format("serve-{:016x}", hashed(key));
}

std::optional<RungSet> RungCache::load() const {
    std::error_code ignored;
    if (folder_.empty() || !fs::is_regular_file(folder_ / set_file, ignored)) return std::nullopt;
    try {
        std::ostringstream text;
        text << std::ifstream(folder_ / set_file).rdbuf();
        return set_of(FloatJson::parse(text.str()), folder_);
    } catch (const std::exception&) {  // damaged, or of another hand: train anew
        return std::nullopt;
    }
}

void RungCache::store(const RungSet& set) const {
    if (folder_.empty()) return;
    for (const Rung& rung : set.rungs)
        write_model(rung.model, folder_ / format("{}.json", rung.recipe->name));
    write_file_atomically(folder_ / set_file, json_of(set).dump());
}

}  // namespace specula
