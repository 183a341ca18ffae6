#include <cstdio>

#include "sim/core/format.hpp"
#include "tools/console/console.hpp"
#include "tools/serve/application.hpp"
#include "tools/serve/http_server.hpp"
#include "tools/serve/interruption.hpp"
#include "tools/serve/request_guard.hpp"
#include "tools/serve/rung_cache.hpp"
#include "tools/specula/commands.hpp"

namespace specula {

namespace {

/// All that the models depend on but the program itself.
std::string origin_of(const Experiment& experiment, const Catalogue& catalogue) {
    std::string origin = experiment.source + experiment.radar.description;
    for (const SampleLaw& law : experiment.population.classes) {
        const std::string file = "materials/library/" + law.nominal.material + ".toml";
        origin += Section::read(catalogue.root / file).source();
    }
    return origin;
}

RungSet rungs_of(const Experiment& experiment, const Catalogue& catalogue, int threads) {
    const RungCache cache(origin_of(experiment, catalogue));
    if (auto kept = cache.load()) return *kept;
    std::fprintf(stderr, "First start: the page's models are recorded and trained.\n");
    RungSet set = train_rungs(experiment, catalogue.materials, threads);
    try {
        cache.store(set);
    } catch (const std::exception& error) {
        say_warning(format("{}; the next start trains the models again", error.what()));
    }
    return set;
}

/// A curve takes a while, and the chirp under the mouse shall not wait for it.
constexpr int least_workers = 2;

}  // namespace

void serve_command(const ServeArguments& arguments, const Catalogue& catalogue) {
    ListenSocket socket({arguments.listen, arguments.port});  // a taken port is told at once
    const ListenAddress where = socket.where();
    const std::string token = where.is_loopback() ? "" : random_token();
    Experiment experiment = page_experiment(catalogue);
    RungSet models = rungs_of(experiment, catalogue, arguments.threads);
    Application application(catalogue, std::move(experiment), std::move(models));
    const RequestGuard guard(where, token);
    const Interruption interruption;
    const HttpServer server(
        socket,
        {.guard = [&](const HttpRequest& request) { return guard.check(request); },
         .at_once = [&](const HttpRequest& request) { return application.at_once(request); },
         .worked_out = [&](const HttpRequest& request) { return application.worked_out(request); }},
        std::max(least_workers, arguments.threads));
    if (!token.empty())
        say_warning("others on the network can reach this page; only who has the token gets in");
    std::printf("Specula's page: http://%s/%s\nCtrl-C ends it.\n", where.to_type().text().c_str(),
                token.empty() ? "" : ("?token=" + token).c_str());
    std::fflush(stdout);
    interruption.wait();
    application.stop();
    std::printf("\nEnded.\n");
}

}  // namespace specula
