#include "sim/core/format.hpp"
#include "sim/dataset/sha256.hpp"
#include "tools/dataset/dataset_documents.hpp"
#include "tools/dataset/dataset_summary.hpp"
#include "tools/dataset/text_histogram.hpp"

namespace specula {

namespace {

/// What the sections are made of.
struct Subject {
    const std::filesystem::path& file;
    const DatasetSummary& summary;
    const DocumentOptions& options;

    const Origin& origin() const { return summary.head.origin; }
    bool simulated() const { return origin().source == "simulation"; }
};

/// Text in a table's cell.
std::string cell(std::string text) {
    for (char& c : text)
        if (c == '|' || c == '\n') c = ' ';
    return text;
}

std::string motivation(const Subject& subject) {
    const std::string purpose =
        subject.simulated()
            ? "Simulated frames of a 60 GHz FMCW radar over flat samples of material, to train and "
              "to test classifiers of materials under known geometry. A simulation gives what a "
              "bench does not: the truth of every frame, and conditions changed one at a time."
            : "Recorded frames of a radar, brought into one form with simulated ones, so that both "
              "can be trained on and compared.";
    return format(
        "## Motivation\n\n{}\n\nCondition `{}`. Made by: {}. What it was made for beyond this, "
        "its maker must add here.\n\n",
        purpose, subject.origin().condition,
        subject.options.creator.empty() ? "not told" : subject.options.creator);
}

std::string shape_lines(const Subject& subject) {
    const Dataset& head = subject.summary.head;
    std::string text = format("- {} frames", subject.summary.n_frames);
    if (head.n_samples > 0)
        text +=
            format(", each of {} chirps x {} receivers x {} samples, int16 codes in LSB{}",
                   head.n_chirps, head.n_rx, head.n_samples,
                   head.sample_axis == SampleAxis::range ? "; samples are range, not time" : "");
    text += ".\n";
    if (!head.feature_names.empty())
        text += format("- {} features per frame, from `{}` to `{}`.\n", head.feature_names.size(),
                       head.feature_names.front(), head.feature_names.back());
    text += format(
        "- Worlds: {}, physical samples: {}, sessions: {}{}. Frames of a session differ by noise "
        "and "
        "vibration only: **split by `/group/session`, or by `/group/sample` to judge new pieces, "
        "never by frame.**\n",
        subject.summary.worlds.size(), subject.summary.samples.size(),
        subject.summary.sessions.size(),
        head.has_views ? format(", views: {}", subject.summary.views.size()) : "");
    return text;
}

std::string class_table(const Subject& subject) {
    std::string text = "\n| class | label | frames | samples | sessions |\n|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < subject.summary.classes.size(); ++i) {
        const ClassSummary& each = subject.summary.classes[i];
        text += format("| {} | {} | {} | {} | {} |\n", cell(each.name), i, each.n_frames,
                       each.samples.size(), each.sessions.size());
    }
    return text;
}

std::string truth_table(const Subject& subject) {
    std::string text =
        "\n| truth of every frame | least | mean | most | unit | meaning |\n"
        "|---|---|---|---|---|---|\n";
    std::string unknown;
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        const Spread& spread = subject.summary.truth[i];
        const TruthColumn& column = truth_columns[i];
        if (spread.n > 0)
            text += format("| {} | {:.6g} | {:.6g} | {:.6g} | {} | {} |\n", column.name,
                           spread.least, spread.mean(), spread.most, column.unit, column.meaning);
        else
            unknown += (unknown.empty() ? "" : ", ") + std::string(column.name);
    }
    if (!unknown.empty())
        text += "\nNot known, and left out instead of guessed: " + unknown + ".\n";
    return text;
}

std::string distributions(const Subject& subject) {
    std::string text;
    for (const FrameQuantity& each : subject.summary.quantities)
        if (!each.values.empty()) text += text_histogram(each.name, each.unit, each.values) + "\n";
    return text.empty() ? "" : "\n```\n" + text + "```\n";
}

std::string composition(const Subject& subject) {
    std::string text = "## Composition\n\n" + shape_lines(subject) + class_table(subject) +
                       truth_table(subject) + distributions(subject);
    text +=
        "\nSNR is the sample's peak over the median of the far half of the range profile. "
        "No frame is about people, and nothing in the file is personal.";
    text += subject.simulated()
                ? " Nothing is missing: every frame has its full truth.\n\n"
                : " The file holds what the recording and its manifest say, no more.\n\n";
    return text;
}

std::string collection(const Subject& subject) {
    if (!subject.simulated())
        return format(
            "## Collection\n\nImported (`{}`), radar `{}`. The manifest is kept in the attribute "
            "`experiment_toml`. How, where and by whom it was recorded, its maker must add "
            "here.\n\n",
            subject.origin().source, subject.origin().radar);
    return format(
        "## Collection\n\nComputed, not measured: specula {}, radar `{}`, seed {}. Embree decides "
        "what the antennas see, the near-field physical-optics integral over it gives the channel, "
        "and leakage, thermal noise, IF filters and quantisation make it ADC codes "
        "(sim/PHYSICS.md of the program has every equation and its limits). All laws that frames "
        "are drawn from stand in the experiment below, which is also in the attribute "
        "`experiment_toml`; the same program, experiment and seed give the same bytes.\n\n",
        subject.origin().version, subject.origin().radar, subject.origin().seed);
}

/// What `specula augment` notes of itself begins with its seed.
std::string preprocessing(const Subject& subject) {
    const std::string& recipe = subject.origin().recipe;
    if (recipe.rfind("augment_seed", 0) != 0)
        return "None after the ADC: codes are as the receiver gives them.";
    std::string text =
        "Copies of frames were changed by `specula augment`; `/augmentation/copy` is 0 for the "
        "frames themselves, and the group says what was drawn for the others. Counts above are of "
        "both together: only samples and sessions count as evidence.\n\n```\n" +
        recipe;
    return text + (text.back() == '\n' ? "" : "\n") + "```\n\n";
}

std::string uses(const Subject& subject) {
    std::string limits =
        subject.simulated()
            ? "- A model that does well here has not been shown to do well on a board: physical "
              "optics knows no surface waves, edges of dielectrics stay dark, antennas nearer than "
              "3 cm are not modelled, and only what the experiment varies varies.\n"
              "- Nuisance laws are mounting tolerances and material spreads from tables, fitted to "
              "nobody's bench.\n"
            : "- One board, one place, one day may be all that it holds: see samples and sessions "
              "above before any claim beyond them.\n";
    for (const ClassSummary& each : subject.summary.classes)
        if (each.n_frames > 0 && each.samples.size() < 3)
            limits += format(
                "- Class `{}` has {} physical sample{}: what is learnt of it may be the piece, not "
                "the material.\n",
                each.name, each.samples.size(), each.samples.size() == 1 ? "" : "s");
    return "## Preprocessing and labels\n\n" + preprocessing(subject) +
           " Labels are the class of the sample that stood there.\n\n## Uses and limits\n\n"
           "- For training and testing material classifiers, range estimation, and signal "
           "processing of FMCW radar.\n" +
           limits + "\n";
}

std::string distribution(const Subject& subject) {
    return format(
        "## Distribution\n\nFile `{}`, {} bytes, HDF5 1.10 (read it with h5py, MATLAB, h5dump).\n\n"
        "- SHA-256 `{}`\n- fingerprint of codes, features and labels `{}`\n- licence: {}\n{}\n"
        "The licence of specula, Apache-2.0, is that of the program; data made with it are under "
        "whatever licence their maker chooses.\n\n",
        subject.file.filename().string(), std::filesystem::file_size(subject.file),
        sha256_of_file(subject.file), subject.summary.fingerprint,
        subject.options.license.empty() ? "not chosen by the maker yet" : subject.options.license,
        subject.options.url.empty() ? "" : "- found at " + subject.options.url + "\n");
}

std::string maintenance(const Subject& subject) {
    std::string text =
        "## Maintenance\n\nThe maker of the file keeps it. This sheet was written from the file "
        "itself by `specula export datasheet` and describes exactly the SHA-256 above; "
        "`specula diff` tells what differs in another.\n";
    if (subject.origin().experiment.empty()) return text;
    text += "\n## The experiment or manifest, as stored\n\n";
    std::string line;
    for (const char c : subject.origin().experiment + "\n") {
        if (c != '\n') {
            line += c;
            continue;
        }
        text += line.empty() ? "\n" : "    " + line + "\n";
        line.clear();
    }
    return text;
}

}  // namespace

std::string datasheet_title(const std::filesystem::path& dataset) {
    return format("# Datasheet of {}\n", dataset.filename().string());
}

std::string datasheet_of(const std::filesystem::path& dataset, const DocumentOptions& options,
                         int threads) {
    const DatasetSummary summary = summarise_dataset(dataset, threads);
    const Subject subject{dataset, summary, options};
    return datasheet_title(dataset) +
           "\nQuestions after T. Gebru et al., Datasheets for Datasets, CACM 64(12), 2021.\n\n" +
           motivation(subject) + composition(subject) + collection(subject) + uses(subject) +
           distribution(subject) + maintenance(subject);
}

}  // namespace specula
