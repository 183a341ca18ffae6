#include "sim/core/document_table.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string scalar_text(const toml::node& node) {
    if (const auto* text = node.as_string()) return "\"" + text->get() + "\"";
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* real = node.as_floating_point()) return format("{}", real->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    return shown_value(node);
}

/// On one line, whatever breaks a text holds.
std::string on_one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return text;
}

void add_lines(const std::string& path, const toml::node& node, std::vector<std::string>& lines) {
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            add_lines((path.empty() ? "" : path + ".") + std::string(key.str()), value, lines);
    } else if (const toml::array* array = node.as_array()) {
        std::size_t i = 0;
        for (const toml::node& item : *array) add_lines(format("{}[{}]", path, i++), item, lines);
    } else {
        lines.push_back(path + " = " + on_one_line(scalar_text(node)));
    }
}

}  // namespace

std::vector<std::string> Section::value_lines() const {
    std::vector<std::string> lines;
    add_lines("", *table_->table, lines);
    return lines;
}

}  // namespace specula
