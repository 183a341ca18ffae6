#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "materials/electrics.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// A case asks for something that there is no way to compute here: it counts as failed.
class NotComputable : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The values of a JSON object by name; those of an object inside it as "outer.inner". A null is as
/// good as no value.
///
/// Reading throws InputError `file: points[2].inp.name = value: problem; remedy`. Whoever reads is
/// remembered, so that `unread` tells what nobody understood.
class Fields {
  public:
    /// `object` must outlive this; `where` stands for it in messages.
    Fields(const nlohmann::json& object, std::string where);

    bool has(const std::string& name) const { return values_.count(name) != 0; }
    std::vector<std::string> names() const;

    double number(const std::string& name, Range range = Range::any()) const;
    double number_or(const std::string& name, double fallback, Range range = Range::any()) const;
    /// The first of several names for the same thing.
    double number_of(std::initializer_list<const char*> names, Range range = Range::any()) const;
    int count(const std::string& name, Range range) const;
    int count_or(const std::string& name, int fallback, Range range) const;
    std::string text(const std::string& name) const;
    bool flag(const std::string& name) const;
    /// A number, or [re, im].
    Complex complex(const std::string& name) const;
    /// A relative permittivity; a gain medium is refused.
    Complex permittivity(const std::string& name) const;
    std::vector<double> numbers(const std::string& name, Range range = Range::any()) const;
    std::vector<Complex> complexes(const std::string& name) const;
    /// A list of lists of numbers.
    std::vector<std::vector<double>> rows(const std::string& name) const;

    std::vector<std::string> texts() const;  ///< all values that are texts
    bool is_text(const std::string& name) const;
    bool is_number(const std::string& name) const;
    bool is_list(const std::string& name) const;

    /// Names that only describe: they count as read.
    void describe(std::initializer_list<const char*> names) const;
    std::vector<std::string> unread() const;

    [[noreturn]] void fail(const std::string& name, const std::string& problem,
                           const std::string& remedy) const;
    const std::string& where() const { return where_; }

  private:
    void flatten(const nlohmann::json& object, const std::string& prefix);
    const nlohmann::json& at(const std::string& name) const;
    double checked(const std::string& name, const nlohmann::json& value, Range range) const;
    Complex complex_of(const std::string& name, const nlohmann::json& value) const;
    const nlohmann::json& list_at(const std::string& name) const;

    std::map<std::string, const nlohmann::json*> values_;
    std::string where_;
    mutable std::set<std::string> read_;
};

}  // namespace specula
