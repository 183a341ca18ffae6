#include "tools/serve/application.hpp"

#include <unistd.h>

#include <fstream>
#include <mutex>
#include <sstream>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/serve/chirp_answer.hpp"
#include "tools/serve/level_curve.hpp"
#include "tools/serve/page_description.hpp"
#include "tools/serve/page_file.hpp"

namespace specula {

namespace {

namespace fs = std::filesystem;

constexpr const char* tilt_path = "/api/curve/tilt";
constexpr const char* height_path = "/api/curve/height";

bool is_work(const std::string& path) {
    for (const char* known : {"/api/chirp", tilt_path, height_path, "/api/scene.toml",
                              "/api/chirp.csv", "/api/chirp.h5"})
        if (path == known) return true;
    return false;
}

HttpResponse json_response(const FloatJson& json) {
    return {.body = json.dump(-1, ' ', false, FloatJson::error_handler_t::replace)};
}

/// The field of "place: key = value: problem; remedy", as readers of files say it.
HttpResponse input_error_response(const std::string& message) {
    const std::size_t begin = message.find(": ");
    const std::size_t end = message.find(" = ");
    const bool named = begin != std::string::npos && end != std::string::npos && begin + 2 < end;
    const std::string field = named ? message.substr(begin + 2, end - begin - 2) : "scene";
    const std::string rest = begin == std::string::npos ? message : message.substr(begin + 2);
    const std::size_t semicolon = rest.rfind("; ");
    const std::string remedy = semicolon == std::string::npos ? "" : rest.substr(semicolon + 2);
    HttpResponse refused = json_response(
        {{"error",
          {{"field", field}, {"problem", rest.substr(0, semicolon)}, {"remedy", remedy}}}});
    refused.status = 400;
    return refused;
}

HttpResponse field_error_response(const FieldError& error) {
    HttpResponse refused = json_response(
        {{"error",
          {{"field", error.field()}, {"problem", error.what()}, {"remedy", error.remedy()}}}});
    refused.status = 400;
    return refused;
}

HttpResponse attachment(const std::string& name, const std::string& type, std::string body) {
    return {.type = type,
            .body = std::move(body),
            .headers = {{"Content-Disposition", format("attachment; filename=\"{}\"", name)}}};
}

/// A dataset's bytes. HDF5 writes files; this one has no name that anybody else could guess.
std::string hdf5_bytes(const Dataset& dataset) {
    static std::mutex one_at_a_time;  // the library has one state for all threads
    const std::lock_guard<std::mutex> hold(one_at_a_time);
    std::string folder = (fs::temp_directory_path() / "specula_serve_XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
        throw SystemError(folder + ": cannot create a folder there");
    const fs::path file = fs::path(folder) / "chirp.h5";
    std::ostringstream bytes;
    try {
        write_dataset(file, dataset);
        bytes << std::ifstream(file, std::ios::binary).rdbuf();
    } catch (...) {
        fs::remove_all(folder);
        throw;
    }
    fs::remove_all(folder);
    return bytes.str();
}

}  // namespace

Application::Application(const Catalogue& catalogue, Experiment experiment, RungSet models)
    : catalogue_(catalogue),
      experiment_(std::move(experiment)),
      models_(std::move(models)),
      known_(KnownNames::of(catalogue)),
      lessons_(read_lessons(catalogue, known_)),
      page_(json_response(page_description({.catalogue = catalogue_,
                                            .known = known_,
                                            .experiment = experiment_,
                                            .models = models_,
                                            .lessons = lessons_}))
                .body) {}

std::optional<HttpResponse> Application::at_once(const HttpRequest& request) const {
    if (is_work(request.path)) {
        if (request.method == "POST") return std::nullopt;
        HttpResponse refused = error_response(405, "is asked for by POST", "send a JSON object");
        refused.headers = {{"Allow", "POST"}};
        return refused;
    }
    if (request.method == "POST")
        return error_response(404, "there is nothing here", "see GET / for the page");
    if (request.path == "/api/page") return HttpResponse{.body = page_};
    const std::string path = request.path == "/" ? "/index.html" : request.path;
    for (const PageFile& file : page_files())
        if (file.path == path)
            return HttpResponse{.type = std::string(file.type), .body = std::string(file.content)};
    return error_response(404, "there is nothing here", "see GET / for the page");
}

HttpResponse Application::worked_out(const HttpRequest& request) const {
    try {
        return answer(request);
    } catch (const FieldError& error) {
        return field_error_response(error);
    } catch (const InputError& error) {
        return input_error_response(error.what());
    } catch (const std::bad_alloc&) {
        return error_response(503, "out of memory", "ask for a smaller sample");
    } catch (const std::exception& error) {
        return error_response(500, error.what(), "tell the makers what you asked for");
    }
}

HttpResponse Application::answer(const HttpRequest& request) const {
    const SceneRequest asked = read_request(parse_json(request.body), known_);
    if (request.path == tilt_path || request.path == height_path) return curve(asked, request.path);
    if (request.path != "/api/chirp") return download(asked, request.path);
    const PageChirp chirp = simulate_request(asked, experiment_, catalogue_, known_);
    return json_response(chirp_answer(chirp, models_, experiment_, catalogue_.materials));
}

HttpResponse Application::curve(const SceneRequest& request, const std::string& path) const {
    const Scene scene = requested_scene(request, catalogue_, known_);
    const CurveRequest wanted{.axis = path == tilt_path ? CurveAxis::tilt : CurveAxis::height,
                              .tilting = tilting_of(request),
                              .stop = stop_};
    const LevelCurve found = level_curve(scene, wanted, catalogue_.materials);
    if (found.x.empty())
        return error_response(422, "the server ends, or the radar sees nothing there",
                              "choose another radar or a smaller sample");
    return json_response({{"x", found.x},
                          {"level_db", found.level_db},
                          {"foot_margin", found.foot_margin},
                          {"command", sweep_command_line(request, wanted.axis)}});
}

HttpResponse Application::download(const SceneRequest& request, const std::string& path) const {
    const std::string scene = scene_toml(request, *known_.radar(request.radar));
    requested_scene(request, catalogue_, known_);  // refuses what the file could not be read as
    if (path == "/api/scene.toml")
        return attachment("specula_scene.toml", "application/toml", scene);
    const PageChirp chirp = simulate_request(request, experiment_, catalogue_, known_);
    if (path == "/api/chirp.csv") return attachment("chirp.csv", "text/csv", chirp_csv(chirp));
    return attachment("chirp.h5", "application/x-hdf5",
                      hdf5_bytes(dataset_of(chirp, request, scene)));
}

}  // namespace specula
