#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace specula {

/// JSON whose keys keep their order and whose numbers are float: the shortest text that reads back
/// as the same float.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                       std::int64_t, std::uint64_t, float>;

/// A value inside a JSON file that knows its place, so that what is wrong with it can be said.
///
/// All reading functions throw InputError `file: field = value: problem; remedy`.
class JsonField {
  public:
    /// The root; `file` and `root` must outlive all fields.
    JsonField(const std::string& file, const FloatJson& root) : file_(&file), value_(&root) {}

    JsonField at(const std::string& key) const;
    /// The elements of an array, the members of an object in their order.
    std::vector<JsonField> items() const;
    std::string key() const { return key_; }

    std::string text() const;
    std::int64_t integer() const;
    /// Array of n finite numbers, each at least `min`.
    std::vector<float> numbers(std::size_t n, float min) const;

    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

  private:
    const std::string* file_;
    const FloatJson* value_;
    std::string path_{};
    std::string key_{};
};

}  // namespace specula
