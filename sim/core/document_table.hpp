#pragma once

#include <toml++/toml.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/core/document.hpp"

namespace specula {

/// A file while it is read: the text and its tree live as long as any Section of it.
struct DocumentSource {
    std::string name;
    std::string text;
    toml::table root;
};

/// What a Section refers to: one TOML table, its path in the file, and the keys asked for so far.
struct Section::Table {
    std::shared_ptr<DocumentSource> source;
    const toml::table* table;
    std::string path;  ///< "" or "sample."
    std::set<std::string> known{};
    std::map<std::string, Unit> quantities{};  ///< names asked for, without their suffix

    /// A key with the unit of its values.
    struct Named {
        std::string key;
        const toml::node* node;
        double to_si;
        std::string unit;
    };

    [[noreturn]] void fail(const std::string& key, const toml::node* node,
                           const std::string& problem, const std::string& remedy) const;
    [[noreturn]] void fail_missing(const std::string& key,
                                   const std::vector<std::string>& spellings) const;
    [[noreturn]] void fail_unknown(const std::string& key) const;
    const toml::node* find(const std::string& key);
    const toml::node& need(const std::string& key);
    std::optional<Named> find_quantity(const std::string& name, Unit unit);
    Named need_quantity(const std::string& name, Unit unit);
    double checked_number(const Named& named, const toml::node& node, const Range& range) const;
    std::vector<double> checked_numbers(const Named& named, std::size_t size,
                                        const Range& range) const;
    Distribution checked_law(const Named& named, const Range& range) const;
    /// A law of this name in the table of `named`.
    Distribution checked_entry(const Named& named, const std::string& name,
                               const Range& range) const;
    SampledLaw checked_sampled_law(const Named& named, const Range& range) const;
};

/// A value as the user wrote it, for messages: one line of at most 80 bytes.
std::string shown_value(const toml::node& node);

/// The bounds of a range in words, in the unit of a key; values at stated bounds are in the range.
std::string described(const Range& range, double to_si, std::string_view unit);

}  // namespace specula
