#include "tools/serve/page_description.hpp"

#include <cmath>

#include "firmware/fw_extract.h"
#include "sim/core/version.hpp"

namespace specula {

namespace {

FloatJson fields_json() {
    const SceneRequest usual;
    FloatJson fields = FloatJson::array();
    for (const NumberField& field : number_fields)
        fields.push_back({{"key", field.key},
                          {"title", field.title},
                          {"unit", field.unit},
                          {"min", static_cast<float>(field.min)},
                          {"max", static_cast<float>(field.max)},
                          {"step", static_cast<float>(field.step)},
                          {"whole", field.whole},
                          {"usual", static_cast<float>(usual.*field.member)}});
    return fields;
}

FloatJson materials_json(const PageFacts& facts) {
    FloatJson materials = FloatJson::array();
    for (const std::string& name : facts.known.materials) {
        const Material& material = *facts.catalogue.materials.find(name);
        materials.push_back({{"name", name}, {"title", material.title}, {"group", material.group}});
    }
    return materials;
}

FloatJson pieces_json(const RungSet& models) {
    FloatJson pieces = FloatJson::array();
    for (const TrainingPiece& piece : models.pieces)
        pieces.push_back({{"name", piece.name},
                          {"thickness_mm", static_cast<float>(piece.thickness_mm)},
                          {"bow_mm", static_cast<float>(piece.bow_mm)},
                          {"roughness_um", static_cast<float>(piece.roughness_um)},
                          {"correlation_mm", static_cast<float>(piece.correlation_mm)}});
    return pieces;
}

/// Where a radar sees a plate (blind_reason), in whole millimetres.
FloatJson heights_seen_mm(const Radar& radar) {
    constexpr double mm_per_m = 1e3, first_free_bin = 3.0;
    const double least_mm = std::ceil(first_free_bin * radar.chirp.bin_m() * mm_per_m);
    const double most_mm = std::floor(radar.chirp.max_range_m() * mm_per_m);
    return FloatJson::array({static_cast<float>(least_mm), static_cast<float>(most_mm)});
}

FloatJson radars_json(const KnownNames& known) {
    constexpr double mm_per_m = 1e3;
    FloatJson radars = FloatJson::array();
    for (const Radar& radar : known.radars)
        radars.push_back(
            {{"name", radar.name},
             {"title", radar.title},
             {"slope_mhz_us", static_cast<float>(radar.chirp.slope_hz_s / hz_s_per_mhz_us)},
             {"noise_figure_db", static_cast<float>(radar.receiver.noise_figure_db)},
             {"bin_mm", static_cast<float>(radar.chirp.bin_m() * mm_per_m)},
             {"heights_mm", heights_seen_mm(radar)}});
    return radars;
}

FloatJson rungs_json(const RungSet& models) {
    FloatJson rungs = FloatJson::array();
    for (const Rung& rung : models.rungs) {
        FloatJson bands = FloatJson::array(), scores = FloatJson::array();
        for (const ClassBand& band : rung.bands)
            bands.push_back({{"low", band.low}, {"middle", band.middle}, {"high", band.high}});
        for (const RungScore& score : rung.scores)
            scores.push_back(
                {{"condition", score.condition}, {"macro_f1", static_cast<float>(score.macro_f1)}});
        rungs.push_back({{"name", rung.recipe->name},
                         {"title", rung.recipe->title},
                         {"idea", rung.recipe->idea},
                         {"unit", rung.recipe->aligned ? "ln LSB" : "LSB"},
                         {"is_logarithm", rung.recipe->aligned},
                         {"bands", bands},
                         {"scores", scores}});
    }
    return rungs;
}

}  // namespace

FloatJson page_description(const PageFacts& facts) {
    FloatJson lessons = FloatJson::array();
    for (const Lesson& lesson : facts.lessons) lessons.push_back(lesson_json(lesson));
    return {{"version", program_version},
            {"fields", fields_json()},
            {"materials", materials_json(facts)},
            {"radars", radars_json(facts.known)},
            {"classes", facts.experiment.population.class_names()},
            {"pieces", pieces_json(facts.models)},
            {"training_sessions", facts.experiment.training.sessions},
            {"first_bin", FW_DEFAULT_FIRST_BIN},
            {"n_bins", FW_DEFAULT_N_BINS},
            {"models", rungs_json(facts.models)},
            {"lessons", lessons}};
}

}  // namespace specula
