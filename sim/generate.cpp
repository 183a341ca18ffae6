#include "sim/generate.hpp"

#include "sim/parallel.hpp"

namespace specula {

std::size_t session_count(const Condition& condition, const Population& population, int worlds) {
    return population.classes.size() * static_cast<std::size_t>(condition.sessions_per_class()) *
           static_cast<std::size_t>(worlds);
}

Dataset generate(const Bench& bench, const Condition& condition, int worlds, int threads,
                 std::atomic<std::size_t>* done, std::size_t* weak) {
    const auto n_classes = bench.population.classes.size();
    const auto n_per_class = static_cast<std::size_t>(condition.sessions_per_class());
    std::vector<SessionFrames> sessions(session_count(condition, bench.population, worlds));
    const auto simulate = [&](std::size_t i) {
        const SessionId id{.world = static_cast<int>(i / (n_classes * n_per_class)),
                           .label = static_cast<int>(i / n_per_class % n_classes),
                           .session = static_cast<int>(i % n_per_class)};
        sessions[i] = simulate_session(bench, condition, id);
    };
    for_each_index(sessions.size(), threads, simulate, done);

    Dataset dataset;
    dataset.origin.condition = condition.name;
    dataset.origin.seed = bench.seed;
    dataset.origin.radar = bench.radar.name;
    dataset.origin.bin_m = bench.radar.chirp.bin_m();
    dataset.class_names = bench.population.class_names();
    dataset.n_chirps = bench.radar.chirps_per_frame;
    dataset.n_rx = static_cast<int>(bench.radar.rx.size());
    dataset.n_samples = bench.radar.chirp.n_samples;
    for (SessionFrames& session : sessions) {
        if (weak && session.is_weak) ++*weak;
        dataset.adc.insert(dataset.adc.end(), session.adc.begin(), session.adc.end());
        dataset.adc_quadrature.insert(dataset.adc_quadrature.end(), session.adc_quadrature.begin(),
                                      session.adc_quadrature.end());
        dataset.truth.insert(dataset.truth.end(), session.truth.begin(), session.truth.end());
        session = {};
    }
    return dataset;
}

}  // namespace specula
