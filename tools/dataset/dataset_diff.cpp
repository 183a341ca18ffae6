#include "tools/dataset/dataset_diff.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_layout.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

constexpr std::size_t block_bytes = 4 << 20;
constexpr double long_bytes = 2e8;  ///< some seconds of reading

std::string shape_text(const std::vector<std::size_t>& shape) {
    std::string text;
    for (const std::size_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
    return text;
}

/// Throws InputError where a dataset lacks something or is of a version to come.
void check_readable(const std::filesystem::path& file) {
    const DatasetReader reader(file);
    (void)reader.n_frames();
}

/// Where value `at` of a row lies, e.g. "/adc[12, 0, 2, 17]".
std::string place_text(const std::string& table, const std::vector<std::size_t>& shape,
                       std::size_t row, std::size_t at) {
    std::string tail;
    for (std::size_t axis = shape.size(); axis-- > 1; at /= shape[axis])
        tail = format(", {}", at % shape[axis]) + tail;
    return format("{}[{}{}]", table, row, tail);
}

/// Both files, and what is known of them before their rows are read.
class Comparison {
  public:
    Comparison(const std::filesystem::path& a, const std::filesystem::path& b,
               const DiffOptions& options)
        : a_(Hdf5File::open(a)), b_(Hdf5File::open(b)), options_(options) {
        for (const auto& [file, in] : {std::pair{&a, &a_}, {&b, &b_}})
            if (in->text("/", "format") == dataset_layout::format_name) check_readable(*file);
    }

    DatasetDiff run() {
        const auto tables_a = a_.tables(), tables_b = b_.tables();
        const std::set<std::string> in_a(tables_a.begin(), tables_a.end());
        const std::set<std::string> in_b(tables_b.begin(), tables_b.end());
        compare_attributes("/", "");
        std::vector<std::string> both;
        for (const std::string& table : tables_a)
            if (!ignores(table) && in_b.count(table) == 0)
                diff_.heads.push_back(table + ": only in A");
        for (const std::string& table : tables_b)
            if (!ignores(table)) {
                if (in_a.count(table) == 0)
                    diff_.heads.push_back(table + ": only in B");
                else
                    both.push_back(table);
            }
        watch(both);
        for (const std::string& table : both) compare_table(table);
        for (const std::string& name : options_.ignored)
            if (used_.count(name) == 0)
                throw InputError(format(
                    "--ignore {}: no such table, group or attribute in either file; see specula "
                    "show FILE, or h5ls -r FILE",
                    name));
        diff_.n_different_frames =
            static_cast<std::size_t>(std::count(different_.begin(), different_.end(), true));
        return diff_;
    }

  private:
    /// Whether a table or attribute, or the group it lies in, is to be passed over.
    bool ignores(const std::string& name) {
        for (const std::string& each : options_.ignored)
            if (name == each || name.rfind(each + "/", 0) == 0) {
                used_.insert(each);
                return true;
            }
        return false;
    }

    void compare_attributes(const std::string& object, const std::string& shown) {
        auto names = a_.attributes(object);
        const auto more = b_.attributes(object);
        const std::set<std::string> in_a(names.begin(), names.end());
        const std::set<std::string> in_b(more.begin(), more.end());
        for (const std::string& name : more)
            if (in_a.count(name) == 0) names.push_back(name);
        for (const std::string& name : names) {
            if (ignores(shown + "@" + name)) continue;
            if (in_a.count(name) == 0 || in_b.count(name) == 0) {
                diff_.heads.push_back(
                    format("{}@{}: only in {}", shown, name, in_a.count(name) == 1 ? "A" : "B"));
                continue;
            }
            const std::string first = a_.attribute_text(object, name);
            const std::string second = b_.attribute_text(object, name);
            if (first != second)
                diff_.heads.push_back(format("{}@{}: {}", shown, name, in_words(first, second)));
        }
    }

    /// Two texts that differ; of long ones, from shortly before the first character that does.
    static std::string in_words(const std::string& a, const std::string& b) {
        constexpr std::size_t shown = 40, before = 10;
        std::size_t at = 0;
        while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
        const bool is_long = std::max(a.size(), b.size()) > shown;
        const std::size_t begin = is_long && at > before ? at - before : 0;
        const auto quoted = [&](const std::string& text) {
            std::string part = begin < text.size() ? text.substr(begin, shown) : "";
            for (char& c : part)
                if (static_cast<unsigned char>(c) < ' ') c = ' ';
            return '"' + part + '"';
        };
        return format("{} against {}{}", quoted(a), quoted(b),
                      begin > 0 ? format(", from character {}", begin) : "");
    }

    void compare_table(const std::string& table) {
        compare_attributes(table, table);
        const auto shape_a = a_.shape(table), shape_b = b_.shape(table);
        if (shape_a[0] != shape_b[0] && !tells_rows_) {
            diff_.heads.insert(diff_.heads.begin(),
                               format("rows of tables: {} against {}", shape_a[0], shape_b[0]));
            tells_rows_ = true;
        }
        if (shape_a.size() != shape_b.size() ||
            !std::equal(shape_a.begin() + 1, shape_a.end(), shape_b.begin() + 1))
            diff_.heads.push_back(
                format("{}: {} against {}", table, shape_text(shape_a), shape_text(shape_b)));
        const std::string type_a = a_.number_type(table), type_b = b_.number_type(table);
        if (type_a != type_b)
            diff_.heads.push_back(format("{}: {} against {}", table, type_a, type_b));
        const bool comparable = type_a == type_b && shape_a.size() == shape_b.size() &&
                                std::equal(shape_a.begin() + 1, shape_a.end(), shape_b.begin() + 1);
        if (!comparable) return;
        auto shape = shape_a;
        shape[0] = std::min(shape_a[0], shape_b[0]);
        diff_.n_frames = std::max(diff_.n_frames, shape[0]);
        different_.resize(std::max(different_.size(), shape[0]));
        if (type_a == "int16") compare_rows<std::int16_t>(table, shape);
        if (type_a == "int32") compare_rows<std::int32_t>(table, shape);
        if (type_a == "uint8") compare_rows<std::uint8_t>(table, shape);
        if (type_a == "uint64") compare_rows<std::uint64_t>(table, shape);
        if (type_a == "float32") compare_rows<float>(table, shape);
        if (type_a == "float64") compare_rows<double>(table, shape);
        if (type_a.empty())
            throw InputError(
                format("{}: holds a type of number that is not compared; leave it "
                       "out with --ignore {}",
                       table, table));
    }

    template <typename T>
    void compare_rows(const std::string& table, const std::vector<std::size_t>& shape) {
        std::size_t width = 1;
        for (std::size_t axis = 1; axis < shape.size(); ++axis) width *= shape[axis];
        const std::size_t step =
            std::max<std::size_t>(1, block_bytes / (sizeof(T) * std::max<std::size_t>(1, width)));
        const Hdf5Table in_a = a_.table(table), in_b = b_.table(table);
        FieldDifference found;
        found.table = table;
        for (std::size_t first = 0; first < shape[0]; first += step) {
            const std::size_t n = std::min(step, shape[0] - first);
            const auto a = in_a.read_rows<T>(first, n), b = in_b.read_rows<T>(first, n);
            for (std::size_t i = 0; i < n && width > 0; ++i)
                if (std::memcmp(&a[i * width], &b[i * width], width * sizeof(T)) != 0)
                    compare_row<T>(&a[i * width], &b[i * width], shape, first + i, width, found);
            if (progress_) progress_->done() += 2 * a.size() * sizeof(T);
        }
        if (found.n_values == 0) return;
        const auto attributes = a_.attributes(table);
        if (std::find(attributes.begin(), attributes.end(), "units") != attributes.end())
            found.unit = a_.attribute_text(table, "units");
        if (found.unit == "1") found.unit.clear();  // a plain number has none to tell
        diff_.fields.push_back(found);
    }

    template <typename T>
    void compare_row(const T* a, const T* b, const std::vector<std::size_t>& shape, std::size_t row,
                     std::size_t width, FieldDifference& found) {
        bool differs = false;
        for (std::size_t at = 0; at < width; ++at) {
            if (std::memcmp(&a[at], &b[at], sizeof(T)) == 0) continue;
            const double apart = a[at] > b[at] ? static_cast<double>(a[at] - b[at])
                                               : static_cast<double>(b[at] - a[at]);
            if (apart <= allowed(found.table, a[at], b[at])) {
                ++diff_.n_tolerated;
                continue;
            }
            if (found.n_values == 0) {
                found.first_frame = row;
                found.first_place = place_text(found.table, shape, row, at);
                found.value_a = format("{}", a[at]);
                found.value_b = format("{}", b[at]);
            }
            found.largest = std::max(found.largest, apart);
            ++found.n_values;
            differs = true;
        }
        if (!differs) return;
        ++found.n_frames;
        different_[row] = true;
    }

    template <typename T>
    double allowed(const std::string& table, T a, T b) const {
        if constexpr (std::is_floating_point_v<T>)
            return options_.relative > 0.0
                       ? options_.relative * static_cast<double>(std::max(std::abs(a), std::abs(b)))
                       : -1.0;
        const bool codes = table == "/adc" || table == "/adc_quadrature";
        return codes && options_.tolerance_lsb > 0.0 ? options_.tolerance_lsb : -1.0;
    }

    void watch(const std::vector<std::string>& tables) {
        double bytes = 0.0;
        for (const std::string& table : tables) {
            double size = a_.number_type(table) == "float64" ? 8.0 : 2.0;
            for (const std::size_t n : a_.shape(table)) size *= static_cast<double>(n);
            bytes += 2.0 * size;
        }
        if (bytes > long_bytes)
            progress_.emplace("comparing", "bytes", static_cast<std::size_t>(bytes));
    }

    Hdf5File a_, b_;
    DiffOptions options_;
    DatasetDiff diff_;
    std::set<std::string> used_;   ///< of the names to ignore
    bool tells_rows_ = false;      ///< that the files have not the same number
    std::vector<bool> different_;  ///< (frame)
    std::optional<Progress> progress_;
};

}  // namespace

const FieldDifference* DatasetDiff::first() const {
    const auto earliest = std::min_element(
        fields.begin(), fields.end(),
        [](const auto& a, const auto& b) { return a.first_frame < b.first_frame; });
    return earliest == fields.end() ? nullptr : &*earliest;
}

DatasetDiff diff_datasets(const std::filesystem::path& a, const std::filesystem::path& b,
                          const DiffOptions& options) {
    return Comparison(a, b, options).run();
}

}  // namespace specula
