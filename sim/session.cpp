#include "sim/session.hpp"

#include <cmath>

#include "sim/clutter.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/limits.hpp"
#include "sim/session_drift.hpp"
#include "sim/simulate.hpp"

namespace specula {

namespace {

/// Names a session, or a frame of it, among all of a world: 4 + 6 + 10 (+ 12) bits.
std::uint32_t item_of(const Condition& condition, const SessionId& id) {
    return (static_cast<std::uint32_t>(condition.number) << 16) |
           (static_cast<std::uint32_t>(id.label) << 10) | static_cast<std::uint32_t>(id.session);
}

StreamKey key_of(const Bench& bench, const SessionId& id, std::string_view purpose,
                 std::uint32_t item) {
    return {.seed = bench.seed,
            .purpose = purpose,
            .world = static_cast<std::uint32_t>(id.world),
            .item = item};
}

/// For truth columns: a number of at most 21 bits of one world, made unique over worlds.
std::int32_t over_worlds(std::uint32_t number, const SessionId& id) {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(id.world) << 21) | number);
}

/// The number of a physical piece in its world: one per class for the known, then one per class
/// and session for the new.
int piece_of(const Condition& condition, const SessionId& id) {
    if (!condition.new_samples) return id.label;
    return (1 + id.session / condition.sessions_per_piece) * 64 + id.label +
           (condition.number << 16);
}

/// How sensor and sample were to stand, before anybody put them so.
Pose asked_pose(const Bench& bench, const Condition& condition, const SessionId& id) {
    if (!condition.geometry_law) return condition.pose(id.session);
    const int index = id.world * condition.sessions_per_class() + id.session;
    return condition.geometry_law->pose(
        {.seed = bench.seed,
         .group = static_cast<std::uint32_t>(id.label),
         .index = static_cast<std::uint32_t>(index),
         .n = static_cast<std::uint32_t>(condition.geometry_law->n_sessions)});
}

/// A short correlation scatters next to nothing; none at all would divide by zero.
constexpr double least_correlation_m = 1e-5;

/// Seed of the heights: the same for every session of a physical piece.
std::uint64_t seed_of_piece(const Bench& bench, const Condition& condition, const SessionId& id) {
    Stream stream(key_of(bench, id, "piece", static_cast<std::uint32_t>(piece_of(condition, id))));
    const std::uint64_t high = stream.bits();
    return high << 32 | stream.bits();
}

Sample draw_sample(const Bench& bench, const Condition& condition, const SessionId& id) {
    const SampleLaw& law = bench.population.classes[static_cast<std::size_t>(id.label)];
    Stream stream(key_of(bench, id, "sample", static_cast<std::uint32_t>(piece_of(condition, id))));
    // The tail of a normal law that would lie below zero is folded back.
    const auto positive = [&](const Distribution& of) { return std::abs(of.sample(stream)); };
    Sample sample = law.nominal;
    sample.thickness_m = positive(law.thickness_m);
    sample.face.bow_m = law.bow_m.sample(stream);
    sample.roughness_m = positive(law.roughness_m);
    sample.permittivity_factor = positive(law.permittivity_factor);
    sample.loss_factor = positive(law.loss_factor);
    sample.correlation_m = std::max(least_correlation_m, positive(law.correlation_m));
    sample.piece = seed_of_piece(bench, condition, id);
    return sample;
}

/// The board's state and the sample's place for one session.
struct Placed {
    Pose asked;
    Pose pose;
    double gain_db = 0.0;
    BoardDrift board;
};

Placed draw_placement(const Bench& bench, const Condition& condition, const SessionId& id) {
    const SessionLaw& law = bench.population.session;
    Stream stream(key_of(bench, id, "placement", item_of(condition, id)));
    Placed placed;
    placed.pose = placed.asked = asked_pose(bench, condition, id);
    placed.pose.height_m += law.height_m.sample(stream);
    placed.pose.sample.about_x_rad += law.tilt_rad.sample(stream);
    placed.pose.sample.about_y_rad += law.tilt_rad.sample(stream);
    placed.pose.offset_x_m += law.offset_m.sample(stream);
    placed.pose.offset_y_m += law.offset_m.sample(stream);
    placed.pose.yaw_rad += law.yaw_rad.sample(stream);
    placed.gain_db = law.gain_db.sample(stream);
    placed.board.leakage_db = law.leakage_db.sample(stream);
    placed.board.leakage_rad = law.leakage_rad.sample(stream);
    return placed;
}

/// The room, and the board's leakage unless that drifts by itself.
Channel still_channel(const Bench& bench, const Condition& condition, const SessionId& id,
                      Channel channel) {
    const FrequencyComb comb = comb_of(bench.radar.chirp);
    const double mirror = mirror_transfer(bench.radar, bench.nominal_height_m);
    Stream world(key_of(bench, id, "world clutter", 0));
    add_clutter(channel, comb, bench.population.world_clutter, bench.radar, mirror, world);
    Stream session(key_of(bench, id, "session clutter", item_of(condition, id)));
    add_clutter(channel, comb, bench.population.session_clutter, bench.radar, mirror, session);
    return channel;
}

/// The state of one frame, but for what its session adds.
FrameState draw_frame(const FrameLaw& law, const StreamKey& key) {
    Stream stream(key);
    FrameState state{.displacement_m = law.displacement_m.sample(stream),
                     .gain_db = law.gain_db.sample(stream)};
    state.motion = {.velocity_m_s = law.velocity_m_s.sample(stream),
                    .vibration_m = law.vibration_m.sample(stream),
                    .vibration_hz = law.vibration_hz.sample(stream),
                    .vibration_rad = two_pi * stream.uniform()};
    state.draw = key;
    return state;
}

Truth session_truth(const Condition& condition, const SessionId& id, const Sample& sample,
                    const Placed& placed) {
    const Pose& pose = placed.pose;
    Truth truth;
    truth.label = static_cast<std::uint8_t>(id.label);
    truth.world = id.world;
    truth.sample = over_worlds(static_cast<std::uint32_t>(piece_of(condition, id)), id);
    truth.session = over_worlds(item_of(condition, id), id);
    truth.height_m = pose.height_m;
    truth.nominal_height_m = placed.asked.height_m;
    truth.sensor_tilt_x_rad = pose.sensor.about_x_rad;
    truth.sensor_tilt_y_rad = pose.sensor.about_y_rad;
    truth.sample_tilt_x_rad = pose.sample.about_x_rad;
    truth.sample_tilt_y_rad = pose.sample.about_y_rad;
    truth.offset_x_m = pose.offset_x_m;
    truth.offset_y_m = pose.offset_y_m;
    truth.yaw_rad = pose.yaw_rad;
    truth.size_x_m = sample.face.size_x_m;
    truth.size_y_m = sample.face.size_y_m;
    truth.thickness_m = sample.thickness_m;
    truth.bow_m = sample.face.bow_m;
    truth.roughness_m = sample.roughness_m;
    truth.correlation_m = sample.correlation_m;
    truth.permittivity_factor = sample.permittivity_factor;
    truth.loss_factor = sample.loss_factor;
    return truth;
}

}  // namespace

SessionFrames simulate_session(const Bench& bench, const Condition& condition,
                               const SessionId& id) {
    SPECULA_EXPECT(id.session >= 0 && id.session < condition.sessions_per_class());
    SPECULA_EXPECT(id.world >= 0 && id.world < SessionId::most_worlds);
    const Sample sample = draw_sample(bench, condition, id);
    const Placed placed = draw_placement(bench, condition, id);
    const Scene scene{bench.radar, sample, placed.pose, bench.solver};
    const Channel echo = echo_channel(scene, bench.materials);
    const bool board_drifts = bench.population.session.board_drifts();
    const Channel leakage = leakage_channel(bench.radar, placed.board);
    const Channel silence = silent_channel(leakage.n_rx, comb_of(bench.radar.chirp));
    const Channel still = still_channel(bench, condition, id, board_drifts ? silence : leakage);
    const ReceiverInput input{
        .echo = dechirp(echo, bench.radar.chirp),
        .still = dechirp(still, bench.radar.chirp),
        .board = board_drifts ? dechirp(leakage, bench.radar.chirp) : BeatSignal{}};
    const ReceiverChain chain(bench.radar);
    Stream drift_stream(key_of(bench, id, "drift", item_of(condition, id)));
    const SessionDrift drift(bench.population.session, bench.radar.rx.size(), drift_stream);

    SessionFrames out;
    out.is_weak = !echo_limits(scene, bench.materials, echo).empty();
    Truth truth = session_truth(condition, id, sample, placed);
    const std::size_t per_frame = chain.codes_per_frame();
    out.adc.resize(static_cast<std::size_t>(condition.frames) * per_frame);
    if (bench.radar.receiver.complex_samples) out.adc_quadrature.resize(out.adc.size());
    ReceiverScratch scratch;
    for (int i = 0; i < condition.frames; ++i) {
        const std::uint32_t item = (item_of(condition, id) << 12) | static_cast<std::uint32_t>(i);
        const double share = condition.frames > 1 ? i / (condition.frames - 1.0) : 0.5;
        FrameState state = draw_frame(bench.population.frame, key_of(bench, id, "frame", item));
        state.gain_db += placed.gain_db + drift.gain_db(share);
        if (board_drifts) state.board_factor = drift.board_factor(share);
        Stream noise(key_of(bench, id, "thermal noise", item));
        const auto codes_of = [&](std::vector<std::int16_t>& all) {
            return all.empty()
                       ? std::span<std::int16_t>{}
                       : std::span(all).subspan(static_cast<std::size_t>(i) * per_frame, per_frame);
        };
        chain.record(input, state,
                     {noise, scratch, {codes_of(out.adc), codes_of(out.adc_quadrature)}});
        truth.frame = i;
        truth.gain_db = state.gain_db;
        truth.displacement_m = state.displacement_m;
        out.truth.push_back(truth);
    }
    return out;
}

}  // namespace specula
