#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/distribution.hpp"
#include "sim/core/units.hpp"

namespace specula {

/// The values a key may take, in SI. Not-a-number is in no range.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool min_excluded = false;
    bool max_excluded = false;

    static Range any() { return {}; }
    static Range at_least(double min) { return {.min = min}; }
    static Range above(double min) { return {.min = min, .min_excluded = true}; }
    static Range between(double min, double max) { return {.min = min, .max = max}; }
    static Range inside(double min, double max) {
        return {.min = min, .max = max, .min_excluded = true, .max_excluded = true};
    }
    bool holds(double value) const;
};

/// One table of a TOML file, read key by key.
///
/// Every reading function throws InputError `file:line: key = value: problem; remedy` when the key
/// is missing (and no fallback is given), has another type, or is out of range. `finish()` refuses
/// keys nobody asked for and names the nearest one that was. Copies refer to the same table.
///
/// A quantity is found under its name and any suffix of its unit (`height` as `height_mm` or
/// `height_m`); two of them at once are an error. Values come back in SI.
class Section {
  public:
    /// The root table of a file. Reads regular files of at most 1 MiB.
    static Section read(const std::filesystem::path& file);
    /// The root table of a text; `name` stands for the file in messages.
    static Section parse(const std::string& text, const std::string& name);

    /// One line: control characters are an error, in lists of texts and choices too.
    std::string text(const std::string& key);
    std::string text(const std::string& key, const std::string& fallback);
    std::string choice(const std::string& key, const std::vector<std::string>& options);
    std::string choice(const std::string& key, const std::vector<std::string>& options,
                       const std::string& fallback);
    double number(const std::string& key, Range range);
    double number(const std::string& key, Range range, double fallback);
    int count(const std::string& key, Range range);
    int count(const std::string& key, Range range, int fallback);
    bool flag(const std::string& key, bool fallback);
    double quantity(const std::string& name, Unit unit, Range range);
    double quantity(const std::string& name, Unit unit, Range range, double fallback);
    Distribution distribution(const std::string& name, Unit unit, Range range);
    Distribution distribution(const std::string& name, Unit unit, Range range,
                              const Distribution& fallback);
    /// A law for a number without unit.
    Distribution factor(const std::string& key, Range range, const Distribution& fallback);

    /// A law that may say how the draws of many items are spread over it.
    SampledLaw sampled_law(const std::string& name, Unit unit, Range range,
                           const Distribution& fallback);

    /// Arrays; `size` 0 accepts any length but zero.
    std::vector<double> numbers(const std::string& key, std::size_t size, Range range);
    std::vector<double> quantities(const std::string& name, Unit unit, std::size_t size,
                                   Range range);
    std::vector<std::string> texts(const std::string& key);

    bool has(const std::string& key) const;
    bool has_quantity(const std::string& name, Unit unit) const;

    /// Whether the value of `key` is a table.
    bool has_section(const std::string& key) const;
    Section section(const std::string& key);
    std::optional<Section> find_section(const std::string& key);
    /// An array of tables ([[key]]); empty where there is none.
    std::vector<Section> sections(const std::string& key);

    /// Call when all known keys have been read. Throws InputError at the first key left over.
    void finish() const;

    /// Throws InputError for a key that was read (or the section itself where there is none).
    [[noreturn]] void fail(const std::string& key, const std::string& problem,
                           const std::string& remedy) const;
    /// The same for a quantity, under the key that the file gives it.
    [[noreturn]] void fail_quantity(const std::string& name, Unit unit, const std::string& problem,
                                    const std::string& remedy) const;

    /// All values below this section in the order of their keys, one `a.b[0].c = value` per line:
    /// the same for files that differ in nothing but comments, order and spaces.
    std::vector<std::string> value_lines() const;

    const std::string& file() const;
    /// The whole text of the file, byte for byte.
    const std::string& source() const;

    struct Table;  ///< hides the TOML library

  private:
    explicit Section(std::shared_ptr<Table> table) : table_(std::move(table)) {}
    std::shared_ptr<Table> table_;
};

/// Whether a file in a folder of descriptions is one by its name: *.toml, but not hidden, as are the
/// marks that editors leave.
bool is_description(const std::filesystem::path& file);

/// Of `known`, the word with the fewest edits to `word`; empty where none is near: more than two
/// edits and a third of the letters, or, in a short word, more than half of them.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

/// `"a", "b" or "c"`.
std::string quoted_list(const std::vector<std::string>& words);

}  // namespace specula
