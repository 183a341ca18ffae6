#include "tools/serve/scene_request.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fw_frame.h"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr int deepest = 4;

struct TextField {
    const char* key;
    std::string SceneRequest::*member;
    std::vector<std::string> allowed;
};

std::vector<TextField> text_fields(const KnownNames& known) {
    std::vector<std::string> radars;
    for (const Radar& radar : known.radars) radars.push_back(radar.name);
    return {{"material", &SceneRequest::material, known.materials},
            {"radar", &SceneRequest::radar, radars},
            {"tilted", &SceneRequest::tilted, {"sensor", "sample"}},
            {"tilt_plane", &SceneRequest::tilt_plane, {"azimuth", "elevation"}}};
}

/// The text as far as a message can bear it.
std::string shown(const FloatJson& value) {
    constexpr std::size_t most = 40;
    using Handler = nlohmann::json::error_handler_t;
    const std::string text =
        value.dump(-1, ' ', true, static_cast<FloatJson::error_handler_t>(Handler::replace));
    return text.size() <= most ? text : text.substr(0, most) + "...";
}

void read_text(const FloatJson& value, const TextField& field, SceneRequest& request) {
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    if (std::find(field.allowed.begin(), field.allowed.end(), text) != field.allowed.end()) {
        request.*field.member = text;
        return;
    }
    const std::string near = nearest_word(text, field.allowed);
    constexpr std::size_t few = 6;
    throw FieldError(field.key, format("{} is no known choice", shown(value)),
                     !near.empty()                 ? "did you mean \"" + near + "\"?"
                     : field.allowed.size() <= few ? "use " + quoted_list(field.allowed)
                                                   : "see GET /api/page for the names");
}

void read_number(const FloatJson& value, const NumberField& field, SceneRequest& request) {
    const std::string unit = *field.unit ? format(" {}", field.unit) : "";
    const std::string remedy =
        format("use {}{:g} to {:g}{}", field.whole ? "a whole number from " : "", field.min,
               field.max, unit);
    if (!value.is_number()) throw FieldError(field.key, shown(value) + " is not a number", remedy);
    const auto number = static_cast<double>(value.get<float>());
    if (!(number >= field.min && number <= field.max))
        throw FieldError(field.key, format("{}{} is out of range", shown(value), unit), remedy);
    if (field.whole && number != std::floor(number))
        throw FieldError(field.key, shown(value) + " is not a whole number", remedy);
    // Decimal fractions come as the nearest float; the page's numbers have few digits.
    constexpr double digits = 1e6;
    request.*field.member = std::round(number * digits) / digits;
}

void refuse_unknown(const FloatJson& json, const std::vector<TextField>& texts) {
    std::vector<std::string> keys{"leakage"};
    for (const TextField& field : texts) keys.push_back(field.key);
    for (const NumberField& field : number_fields) keys.push_back(field.key);
    for (const auto& [key, value] : json.items()) {
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        const std::string near = nearest_word(key, keys);
        throw FieldError(
            shown(FloatJson(key)), "no such field",
            near.empty() ? "see GET /api/page for the fields" : "did you mean \"" + near + "\"?");
    }
}

}  // namespace

KnownNames KnownNames::of(const Catalogue& catalogue) {
    KnownNames known{.materials = catalogue.materials.names(), .radars = {}};
    for (const std::string& name : catalogue.radar_names()) {
        Radar radar = catalogue.radar_called(name);
        if (!radar.receiver.complex_samples && radar.chirp.n_samples <= FW_MAX_SAMPLES)
            known.radars.push_back(std::move(radar));
    }
    return known;
}

const Radar* KnownNames::radar(const std::string& name) const {
    for (const Radar& each : radars)
        if (each.name == name) return &each;
    return nullptr;
}

FloatJson parse_json(const std::string& text) {
    const auto shallow = [](int depth, FloatJson::parse_event_t, FloatJson&) {
        if (depth > deepest) throw FieldError("body", "is nested too deeply", "send one object");
        return true;
    };
    try {
        FloatJson json = FloatJson::parse(text, shallow);
        if (json.is_object()) return json;
    } catch (const FloatJson::exception&) {  // told below, without the library's words
    }
    throw FieldError("body", "is no JSON object", "send an object of fields, {} for the defaults");
}

SceneRequest read_request(const FloatJson& json, const KnownNames& known) {
    const std::vector<TextField> texts = text_fields(known);
    refuse_unknown(json, texts);
    SceneRequest request;
    for (const TextField& field : texts)
        if (json.contains(field.key)) read_text(json[field.key], field, request);
    const Radar* radar = known.radar(request.radar);
    if (radar == nullptr) throw FieldError("radar", "is not known here", "see GET /api/page");
    request.slope_mhz_us = radar->chirp.slope_hz_s / hz_s_per_mhz_us;
    request.noise_figure_db = radar->receiver.noise_figure_db;
    for (const NumberField& field : number_fields)
        if (json.contains(field.key)) read_number(json[field.key], field, request);
    if (json.contains("leakage")) {
        if (!json["leakage"].is_boolean())
            throw FieldError("leakage", shown(json["leakage"]) + " is no switch",
                             "use true or false");
        request.leakage = json["leakage"].get<bool>();
    }
    return request;
}

FloatJson request_json(const SceneRequest& request) {
    FloatJson json{{"material", request.material},
                   {"radar", request.radar},
                   {"tilted", request.tilted},
                   {"tilt_plane", request.tilt_plane},
                   {"leakage", request.leakage}};
    for (const NumberField& field : number_fields)
        json[field.key] = static_cast<float>(request.*field.member);
    return json;
}

}  // namespace specula
