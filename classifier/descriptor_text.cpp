#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "classifier/descriptor.hpp"
#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::array<const char*, 3> window_words{"rect", "hann", "blackman"};  // as fw_window
const std::vector<std::string> extractors{"range_bins", "relative_profile", "peak_shape",
                                          "range_windows", "columns"};
constexpr int most_bins = 65535;
constexpr int most_looks = 10000;

/// The words of a descriptor's line, one after the other.
class Words {
  public:
    explicit Words(const std::string& text) : text_(text), words_(text) {}

    bool next(std::string& word) { return static_cast<bool>(words_ >> word); }
    template <typename Number>
    Number number(const std::string& of, Number least, Number most) {
        Number value{};
        if (!(words_ >> value) || value < least || value > most)
            fail(format("{} needs a number from {} to {}", of, least, most));
        return value;
    }
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(
            format("descriptor = \"{}\": {}; write for example \"range_bins 6 12 blackman align 12 "
                   "search 5 20 range 12 log 1\"",
                   text_, problem));
    }

  private:
    const std::string& text_;
    std::istringstream words_;
};

fw_window read_window(Words& words) {
    std::string word;
    words.next(word);
    const auto found = std::ranges::find(window_words, word);
    if (found == window_words.end()) words.fail("the window is rect, hann or blackman");
    return static_cast<fw_window>(found - window_words.begin());
}

/// align and range share their bin: fw_normalise has one.
void read_target(const std::string& word, Words& words, Descriptor& descriptor) {
    fw_normalise_config& normalise = descriptor.normalise;
    const bool was_set = normalise.align || normalise.compensate_range;
    const auto bin = words.number<float>(word, 1e-3f, most_bins);
    if (was_set && bin != normalise.target_bin) words.fail("align and range name different bins");
    normalise.target_bin = bin;
    (word == "align" ? normalise.align : normalise.compensate_range) = true;
}

void read_step(const std::string& word, Words& words, Descriptor& descriptor) {
    if (word == "align" || word == "range") return read_target(word, words, descriptor);
    if (word == "log") {
        descriptor.normalise.logarithm = true;
        descriptor.normalise.floor_lsb = words.number<float>(word, 1e-6f, 1e6f);
    } else if (word == "search") {
        descriptor.search.first = words.number(word, 0, most_bins);
        descriptor.search.count = words.number(word, 1, most_bins);
    } else if (word == "single") {
        descriptor.bins.integration = FW_INTEGRATE_SINGLE;
    } else if (word == "exported") {
        descriptor.bins.integration = FW_INTEGRATE_EXPORTED;
    } else if (word == "hwa") {
        descriptor.bins.path = FW_RANGE_HWA_LIKE;
    } else if (word == "unit") {
        descriptor.unit_energy = true;
    } else if (word == "angle") {
        descriptor.angle_rx = words.number(word, 2, 64);
    } else if (word == "looks") {
        descriptor.looks = words.number(word, 2, most_looks);
    } else if (word == "spread") {
        descriptor.spread = true;
    } else {
        words.fail(
            format("\"{}\" is none of align, range, log, search, unit, angle, looks, spread, "
                   "single, exported, hwa",
                   word));
    }
}

void check_together(const Descriptor& descriptor, const Words& words) {
    const fw_normalise_config& normalise = descriptor.normalise;
    const bool is_bins = descriptor.extractor == "range_bins";
    const bool is_relative = descriptor.is_relative();
    if (!is_bins && !is_relative && descriptor.uses_peak())
        words.fail("only range bins have a peak to align or to compare phases at");
    if (!is_bins && (normalise.logarithm || descriptor.unit_energy))
        words.fail("log and unit go with range_bins");
    if (descriptor.unit_energy && normalise.logarithm)
        words.fail("unit and log exclude each other");
    if (is_relative && !(normalise.align && normalise.compensate_range))
        words.fail(format("a {} needs align and range", descriptor.extractor));
    if (descriptor.extractor == "peak_shape" && (descriptor.bins.integration != FW_INTEGRATE_MEAN ||
                                                 descriptor.bins.path != FW_RANGE_FLOAT))
        words.fail("a peak_shape is the mean over all rows, in float: no single, exported or hwa");
    if (descriptor.spread && descriptor.looks < 2) words.fail("spread needs looks");
    const BinChoice profile = descriptor.profile();
    if (profile.first > descriptor.bins.first_bin ||
        profile.first + profile.count < descriptor.bins.first_bin + descriptor.bins.n_bins)
        words.fail("search does not hold all of the bins");
}

}  // namespace

std::string Descriptor::text() const {
    std::string line = format("{} {} {} {}", extractor, bins.first_bin, bins.n_bins,
                              window_words[static_cast<std::size_t>(bins.window)]);
    if (bins.integration == FW_INTEGRATE_SINGLE) line += " single";
    if (bins.integration == FW_INTEGRATE_EXPORTED) line += " exported";
    if (bins.path == FW_RANGE_HWA_LIKE) line += " hwa";
    if (normalise.align) line += format(" align {}", normalise.target_bin);
    if (normalise.compensate_range) line += format(" range {}", normalise.target_bin);
    if (normalise.logarithm) line += format(" log {}", normalise.floor_lsb);
    if (search.count > 0) line += format(" search {} {}", search.first, search.count);
    if (unit_energy) line += " unit";
    if (angle_rx > 0) line += format(" angle {}", angle_rx);
    if (looks > 1) line += format(" looks {}", looks);
    if (spread) line += " spread";
    return line;
}

Descriptor parse_descriptor(const std::string& text) {
    Words words(text);
    Descriptor descriptor;
    if (!words.next(descriptor.extractor) ||
        std::ranges::find(extractors, descriptor.extractor) == extractors.end())
        words.fail("begins with none of " + quoted_list(extractors));
    descriptor.bins.first_bin =
        static_cast<std::uint16_t>(words.number("the first bin", 0, most_bins));
    descriptor.bins.n_bins =
        static_cast<std::uint16_t>(words.number("the count of bins", 1, most_bins));
    descriptor.bins.window = read_window(words);
    for (std::string word; words.next(word);) read_step(word, words, descriptor);
    check_together(descriptor, words);
    return descriptor;
}

}  // namespace specula
