#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/result_figures.hpp"
#include "tools/report/result_tables.hpp"
#include "tools/report/study_numbers.hpp"

/// The first page: what was found, in sentences filled in by the numbers.
namespace specula {
namespace {

/// A merged macro-F1 that counts as recovered.
constexpr double recovered = 0.95;

const HonestyCheck* check_named(const StudySummary& study, std::string_view name) {
    const auto found = std::ranges::find_if(study.results.checks,
                                            [&](const HonestyCheck& c) { return c.name == name; });
    return found == study.results.checks.end() ? nullptr : &*found;
}

void say_failure(const StudySummary& study, std::vector<Paragraph>& words) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    const StudyCondition* anew = find_condition(study, rerecorded_condition);
    const StudyCondition* height = find_condition(study, height_condition);
    if (!nominal || !anew) return;
    std::string text = format(
        "Judged on random frames of the recordings it learnt from, the classifier scores {}; on "
        "the "
        "same samples recorded anew, {}.",
        percent_text(nominal->result.macro_f1.mean), percent_text(anew->result.macro_f1.mean));
    if (height)
        text += format(" Ten centimetres more or less of height leave {}, where guessing gives {}.",
                       percent_text(height->result.macro_f1.mean),
                       percent_text(1.0 / static_cast<double>(study.class_names.size())));
    words.push_back({.lead = "The failure.", .text = text});
}

void say_leak(const StudySummary& study, std::vector<Paragraph>& words) {
    const HonestyCheck* leak = check_named(study, "leak_meter");
    if (!leak) return;
    std::string text = format(
        "With classes dealt at random to whole sessions, so that nothing about materials can be "
        "learnt, a random split of frames still scores {}: it rewards knowing the session.",
        percent_text(leak->value.mean));
    if (const HonestyCheck* placebo = check_named(study, "placebo"))
        text += format(
            " With two plates of one metal in place of {}, new sessions give {}: what tells the "
            "two "
            "apart, as far as anything does, is the plate, not the metal.",
            merged_names(study), percent_text(placebo->value.mean));
    words.push_back({.lead = "The number on the bench.", .text = text});
}

void say_percentiles(const StudySummary& study, std::vector<Paragraph>& words) {
    std::string text;
    for (const PaperPercentile& entry : study.results.percentiles) {
        text += format("{}{}, over {} {}: ", text.empty() ? "" : "; ", short_title(entry.domain),
                       entry.n, entry.over);
        text += entry.has_percentiles()
                    ? format("{} of the predictions lie below the paper\u2019s {}, which {} them",
                             percent_text(entry.percentile), percent_text(entry.paper),
                             entry.agrees() ? "agrees with" : "differs from")
                    : format("too few to say where the paper\u2019s {} lies among them",
                             percent_text(entry.paper));
    }
    if (!text.empty())
        words.push_back({.lead = "The paper\u2019s tilt figure.", .text = text + "."});
}

std::string with_interval(const Interval& share) {
    return format("{} (95\u00a0% interval over worlds {})", percent_text(share.mean),
                  range_number(share));
}

/// On which worlds the rung was chosen, and on which its scores are counted.
std::string chosen_text(const StudySummary& study, const LadderRung& rung) {
    const std::size_t n_all = rung.domains.front().per_world.merged.size();
    const std::size_t n_choosing = study.results.choosing_worlds.size();
    const std::string rule = format(
        "\u201c{}\u201d is the rung whose worst condition, with {}, is best (of equals within half a "
        "point the cheapest)",
        rung.title, study.merged_label);
    if (rung.confirmed.empty())
        return rule + ", on the very worlds whose scores follow: a selected figure, not a fair one.";
    return rule + format(
                      " on {} of the {} worlds. The others, which had no say in it, give:",
                      n_choosing, n_all);
}

/// The price: classes that the rung does not tell apart.
std::string five_class_text(const StudySummary& study,
                            const std::vector<DomainScore>& domains) {
    const DomainScore& paper = study.results.ladder.front().domains.front();
    const DomainScore& random = domains.front();
    std::string text = format(
        " With all {} classes apart it scores {} on random frames, where the paper\u2019s classifier "
        "scores {}, and {} or more in every condition.",
        study.class_names.size(), with_interval(random.all), percent_text(paper.all.mean),
        percent_text(worst_of(domains).all.mean));
    if (random.merged.mean - random.all.mean > 0.5 * (1.0 - random.all.mean))
        text += format(" Most of what is missing there is {} taken for each other.",
                       merged_names(study));
    return text;
}

/// What of it is on disk, and what runs on the chip.
std::string device_text(const StudyResults& results) {
    if (!results.device) return {};
    const DeviceFiles& files = *results.device;
    if (files.blob.empty())
        return format(
            " Its first world\u2019s model is in {}, for evaluate and predict; it does not run in "
            "the firmware: {}.",
            files.model, files.why_no_blob);
    return format(
        " Its first world\u2019s model is in {}, for evaluate and predict, and in {}, for the "
        "firmware, which computes inputs and answers.",
        files.model, files.blob);
}

void say_remedy(const StudySummary& study, std::vector<Paragraph>& words) {
    for (const LadderRung& rung : study.results.ladder) {
        if (!rung.recommended) continue;
        const auto& domains = rung.confirmed.empty() ? rung.domains : rung.confirmed;
        std::vector<std::string> missing;
        for (const DomainScore& score : domains)
            if (score.merged.mean < recovered)
                missing.push_back(
                    format("{} ({})", short_title(score.domain), percent_text(score.merged.mean)));
        std::string text =
            chosen_text(study, rung) +
            format(" {} in its worst condition, merged.", with_interval(worst_of(domains).merged)) +
            five_class_text(study, domains) +
            format(
                " It takes {} inputs, {} multiplications and an estimated {:.0f} to "
                "{:.0f}\u00a0\u00b5s after the range profile.",
                rung.cost.n_features,
                count_text(static_cast<std::int64_t>(rung.cost.multiplications)), rung.cost.low_us,
                rung.cost.high_us);
        if (!missing.empty())
            text += format(" Below {}: {}.", percent_text(recovered), listed(missing));
        text += device_text(study.results);
        words.push_back({.lead = "The repair.", .text = text});
    }
}

void say_detectors(const StudySummary& study, std::vector<Paragraph>& words) {
    const auto find = [&](std::string_view detector, std::string_view domain) {
        const auto& all = study.results.detectors;
        return std::ranges::find_if(all, [&](const DetectorScore& s) {
            return s.detector == detector && s.domain == domain;
        });
    };
    const auto probability = find("msp", height_condition);
    const auto distance = find("mahalanobis", height_condition);
    const auto end = study.results.detectors.end();
    if (probability == end || distance == end) return;
    std::string text = format(
        "Of a frame at a wrong height, the confidence tells that it is unfamiliar with an AUROC of "
        "{}, the distance of its inputs with {}.",
        percent_text(probability->auroc.mean), percent_text(distance->auroc.mean));
    const auto tilted = find("mahalanobis", tilt_sensor_condition);
    if (tilted != end)
        text +=
            format(" For a tilted sensor the distance gives {}.", percent_text(tilted->auroc.mean));
    words.push_back({.lead = "Watching for it.", .text = text});
}

void say_checks(const StudySummary& study, std::vector<Paragraph>& words) {
    std::size_t n_judged = 0, n_weak = 0;
    std::vector<std::string> failed;
    for (const HonestyCheck& check : study.results.checks) {
        if (!check.band) continue;
        ++n_judged;
        n_weak += check.passed && check.is_weak();
        if (!check.passed) failed.push_back("\u201c" + check.title + "\u201d");
    }
    if (n_judged == 0) return;
    std::string text = failed.empty()
                           ? format("All {} honesty checks that have a band pass.", n_judged)
                           : format("Of {} honesty checks with a band, {} fail: {}.", n_judged,
                                    failed.size(), listed(failed));
    if (n_weak > 0)
        text += format(
            " {} of them {} weakly: of fewer than {} worlds, or by an interval wider than the band.",
            n_weak, n_weak == 1 ? "passes" : "pass", few_worlds);
    words.push_back({.lead = "Can this be believed?", .text = text});
}

/// A look at whether all works is no result.
void say_few_worlds(const StudySummary& study, std::vector<Paragraph>& words) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    if (!nominal) return;
    const std::size_t n = nominal->result.macro_f1_per_world.size();
    if (n >= few_worlds) return;
    words.push_back(
        {.lead = "Weak evidence.",
         .text = format("This run simulated {} {} only. Its intervals are hardly any, its checks pass "
                        "easily, and no number below is a result; run the study without --quick.",
                        n, n == 1 ? "world" : "worlds")});
}

}  // namespace

Paragraph calibration_words(const CalibrationOutcome& outcome) {
    const std::string frozen =
        format(" Frozen before any other geometry was simulated, as calibration.json, SHA-256 {}.",
               outcome.sha256);
    if (!outcome.asked) return {.lead = "Calibration.", .text = "Nothing was calibrated." + frozen};
    const std::string what = format(
        "One number may be set, by nominal recordings alone: the ratio of signal to noise, between "
        "{:+.0f} and {:+.0f}\u00a0dB of one frame of the radar file, so that random frames score "
        "{} "
        "within {}. ",
        outcome.admissible_snr_db[0], outcome.admissible_snr_db[1],
        percent_text(outcome.target_macro_f1), points_text(outcome.tolerance));
    if (outcome.reached)
        return {.lead = "Calibration.",
                .text = what + format("It is met at {:+.1f}\u00a0dB.", outcome.snr_db) + frozen};
    const double one_frame = outcome.trials.front().macro_f1;
    std::string text = what + format(
                                  "No admissible value meets it: one frame {} scores {}, so the "
                                  "radar file\u2019s own ratio "
                                  "stays.",
                                  one_frame > outcome.target_macro_f1 ? "already" : "only",
                                  percent_text(one_frame));
    if (outcome.matching)
        text += format(" It would take {:+.1f}\u00a0dB.", outcome.matching->snr_db);
    return {.lead = "Calibration.", .text = text + frozen};
}

std::vector<Paragraph> plain_words(const StudySummary& study) {
    std::vector<Paragraph> words;
    say_few_worlds(study, words);
    say_failure(study, words);
    say_leak(study, words);
    say_percentiles(study, words);
    say_remedy(study, words);
    say_detectors(study, words);
    say_checks(study, words);
    return words;
}

}  // namespace specula
