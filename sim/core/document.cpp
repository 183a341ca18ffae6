#include "sim/core/document.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "sim/core/document_table.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// A dotted key nests as deep as it is long, and the TOML library recurses.
void refuse_long_lines(const std::string& text, const std::string& name) {
    constexpr std::size_t longest = 4096;
    std::size_t line = 1, begin = 0;
    for (std::size_t end = 0; begin < text.size(); begin = end + 1, ++line) {
        end = std::min(text.find('\n', begin), text.size());
        if (end - begin > longest)
            throw InputError(
                format("{}:{}: is longer than {} characters; break the line", name, line, longest));
    }
}

/// Texts of files are names, which go into tables, lists, messages and names of files.
bool is_one_line(const std::string& text) {
    constexpr unsigned char first_printed = ' ', rub_out = 0x7f;
    return std::ranges::none_of(text,
                                [](unsigned char c) { return c < first_printed || c == rub_out; });
}

constexpr const char* not_one_line = "holds a line break or another control character";
constexpr const char* make_one_line = "write one line of text";

}  // namespace

bool Range::holds(double value) const {
    return std::isfinite(value) && (min_excluded ? value > min : value >= min) &&
           (max_excluded ? value < max : value <= max);
}

Section Section::read(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto status = std::filesystem::status(file, ignored);
    const std::string name = file.string();
    if (!std::filesystem::exists(status)) throw InputError(name + ": no such file; check the path");
    if (!std::filesystem::is_regular_file(status))
        throw InputError(name + ": is not a regular file; name a TOML file");
    if (std::filesystem::file_size(file, ignored) > (1u << 20))
        throw InputError(name + ": is larger than 1 MiB; a description file is text of a few kB");
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw InputError(name + ": cannot be read; check its permissions");
    return parse(text.str(), name);
}

Section Section::parse(const std::string& text, const std::string& name) {
    refuse_long_lines(text, name);
    auto source = std::make_shared<DocumentSource>();
    source->name = name;
    source->text = text;
    try {
        source->root = toml::parse(std::string_view(source->text), std::string_view(name));
    } catch (const toml::parse_error& error) {
        throw InputError(format("{}:{}: not valid TOML: {}; see https://toml.io for the syntax",
                                name, error.source().begin.line, error.description()));
    }
    const toml::table* root = &source->root;
    return Section(std::make_shared<Table>(Table{std::move(source), root, ""}));
}

bool is_description(const std::filesystem::path& file) {
    return file.extension() == ".toml" && file.filename().string().front() != '.';
}

std::string Section::text(const std::string& key) {
    const toml::node& node = table_->need(key);
    const auto* value = node.as_string();
    if (!value) table_->fail(key, &node, "is not text", "put it in quotes");
    if (value->get().empty()) table_->fail(key, &node, "is empty", "give a word");
    if (!is_one_line(value->get())) table_->fail(key, &node, not_one_line, make_one_line);
    return value->get();
}

std::string Section::text(const std::string& key, const std::string& fallback) {
    return table_->find(key) ? text(key) : fallback;
}

std::string Section::choice(const std::string& key, const std::vector<std::string>& options) {
    const std::string value = text(key);
    if (std::find(options.begin(), options.end(), value) == options.end()) {
        const std::string near = nearest_word(value, options);
        const std::string guess = near.empty() ? "" : "did you mean \"" + near + "\"?";
        // Of a long list, the nearest is enough.
        const std::string all =
            options.size() > 12 && !near.empty() ? "" : "use " + quoted_list(options);
        fail(key, "is not known", guess + (guess.empty() || all.empty() ? "" : " ") + all);
    }
    return value;
}

std::string Section::choice(const std::string& key, const std::vector<std::string>& options,
                            const std::string& fallback) {
    return table_->find(key) ? choice(key, options) : fallback;
}

double Section::number(const std::string& key, Range range) {
    const toml::node& node = table_->need(key);
    return table_->checked_number({key, &node, 1.0, ""}, node, range);
}

double Section::number(const std::string& key, Range range, double fallback) {
    return table_->find(key) ? number(key, range) : fallback;
}

int Section::count(const std::string& key, Range range) {
    const toml::node& node = table_->need(key);
    if (!node.is_integer())
        table_->fail(key, &node, "is not a whole number",
                     "give a whole number " + described(range, 1.0, ""));
    range.min = std::max(range.min, static_cast<double>(std::numeric_limits<int>::min()));
    range.max = std::min(range.max, static_cast<double>(std::numeric_limits<int>::max()));
    return static_cast<int>(table_->checked_number({key, &node, 1.0, ""}, node, range));
}

int Section::count(const std::string& key, Range range, int fallback) {
    return table_->find(key) ? count(key, range) : fallback;
}

bool Section::flag(const std::string& key, bool fallback) {
    const toml::node* node = table_->find(key);
    if (!node) return fallback;
    const auto* value = node->as_boolean();
    if (!value) table_->fail(key, node, "is not true or false", "write true or false, no quotes");
    return value->get();
}

double Section::quantity(const std::string& name, Unit unit, Range range) {
    const auto named = table_->need_quantity(name, unit);
    return table_->checked_number(named, *named.node, range);
}

double Section::quantity(const std::string& name, Unit unit, Range range, double fallback) {
    return table_->find_quantity(name, unit) ? quantity(name, unit, range) : fallback;
}

Distribution Section::distribution(const std::string& name, Unit unit, Range range) {
    return table_->checked_law(table_->need_quantity(name, unit), range);
}

Distribution Section::distribution(const std::string& name, Unit unit, Range range,
                                   const Distribution& fallback) {
    return table_->find_quantity(name, unit) ? distribution(name, unit, range) : fallback;
}

Distribution Section::factor(const std::string& key, Range range, const Distribution& fallback) {
    const toml::node* node = table_->find(key);
    return node ? table_->checked_law({key, node, 1.0, ""}, range) : fallback;
}

std::vector<double> Section::numbers(const std::string& key, std::size_t size, Range range) {
    const toml::node& node = table_->need(key);
    return table_->checked_numbers({key, &node, 1.0, ""}, size, range);
}

std::vector<double> Section::quantities(const std::string& name, Unit unit, std::size_t size,
                                        Range range) {
    return table_->checked_numbers(table_->need_quantity(name, unit), size, range);
}

std::vector<std::string> Section::texts(const std::string& key) {
    const toml::node& node = table_->need(key);
    const toml::array* array = node.as_array();
    if (!array) table_->fail(key, &node, "is not a list", "write [\"a\", \"b\"]");
    if (array->empty()) table_->fail(key, &node, "is empty", "write [\"a\", \"b\"]");
    std::vector<std::string> values;
    for (const toml::node& item : *array) {
        if (!item.is_string())
            table_->fail(key, &node, "holds something that is not text", "put it in quotes");
        values.push_back(item.as_string()->get());
        if (!is_one_line(values.back())) table_->fail(key, &node, not_one_line, make_one_line);
    }
    return values;
}

bool Section::has(const std::string& key) const {
    return table_->find(key) != nullptr;
}

bool Section::has_quantity(const std::string& name, Unit unit) const {
    return table_->find_quantity(name, unit).has_value();
}

bool Section::has_section(const std::string& key) const {
    const toml::node* node = table_->find(key);
    return node != nullptr && node->is_table();
}

Section Section::section(const std::string& key) {
    const toml::node& node = table_->need(key);
    const toml::table* inner = node.as_table();
    if (!inner) table_->fail(key, &node, "is not a table", "write [" + table_->path + key + "]");
    return Section(std::make_shared<Table>(Table{table_->source, inner, table_->path + key + "."}));
}

std::optional<Section> Section::find_section(const std::string& key) {
    return table_->find(key) ? std::optional(section(key)) : std::nullopt;
}

std::vector<Section> Section::sections(const std::string& key) {
    std::vector<Section> found;
    const toml::node* node = table_->find(key);
    if (!node) return found;
    const toml::array* array = node->as_array();
    if (!array || !array->is_homogeneous(toml::node_type::table))
        table_->fail(key, node, "is not a list of tables", "write [[" + table_->path + key + "]]");
    for (const toml::node& item : *array)
        found.push_back(Section(std::make_shared<Table>(
            Table{table_->source, item.as_table(), table_->path + key + "."})));
    return found;
}

void Section::finish() const {
    const toml::key* first = nullptr;  // by line
    for (const auto& [key, node] : *table_->table)
        if (!table_->known.count(std::string(key.str())) &&
            (!first || key.source().begin < first->source().begin))
            first = &key;
    if (first) table_->fail_unknown(std::string(first->str()));
}

void Section::fail(const std::string& key, const std::string& problem,
                   const std::string& remedy) const {
    table_->fail(key, table_->table->get(key), problem, remedy);
}

void Section::fail_quantity(const std::string& name, Unit unit, const std::string& problem,
                            const std::string& remedy) const {
    const std::string key = name + "_";
    for (const UnitSuffix& suffix : suffixes_of(unit))
        if (table_->table->contains(key + std::string(suffix.suffix)))
            fail(key + std::string(suffix.suffix), problem, remedy);
    fail(key + std::string(suffixes_of(unit).front().suffix), problem, remedy);
}

const std::string& Section::file() const {
    return table_->source->name;
}
const std::string& Section::source() const {
    return table_->source->text;
}

}  // namespace specula
