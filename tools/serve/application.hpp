#pragma once

#include <atomic>

#include "tools/serve/http_message.hpp"
#include "tools/serve/lesson.hpp"
#include "tools/serve/page_bench.hpp"
#include "tools/serve/rung_training.hpp"

namespace specula {

/// What the server answers with. Const but for `stop`: requests may come from several threads.
///
/// GET  /, /page.js, ...  the page's files
/// GET  /api/page         what the page needs to know once: fields, names, models, lessons
/// POST /api/chirp        a request's chirp and everything shown of it
/// POST /api/curve/tilt   level over tilt; /api/curve/height likewise
/// POST /api/scene.toml, /api/chirp.csv, /api/chirp.h5   files to keep
class Application {
  public:
    Application(const Catalogue& catalogue, Experiment experiment, RungSet models);

    /// Files, and answers that are known already.
    std::optional<HttpResponse> at_once(const HttpRequest& request) const;
    /// Everything that has to be simulated. Never throws.
    HttpResponse worked_out(const HttpRequest& request) const;
    /// Ends what is being worked out soon.
    void stop() { stop_ = true; }

  private:
    HttpResponse answer(const HttpRequest& request) const;
    HttpResponse curve(const SceneRequest& request, const std::string& path) const;
    HttpResponse download(const SceneRequest& request, const std::string& path) const;

    const Catalogue& catalogue_;
    Experiment experiment_;
    RungSet models_;
    KnownNames known_;
    std::vector<Lesson> lessons_;
    std::string page_;  ///< of GET /api/page
    std::atomic<bool> stop_{false};
};

}  // namespace specula
