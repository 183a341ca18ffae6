#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
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
    bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
    /// The elements of an array, the members of an object in their order.
    std::vector<JsonField> items() const;
    std::string key() const { return key_; }

    std::string text() const;
    std::int64_t integer() const;
    /// An integer that an Integer can hold.
    template <typename Integer>
    Integer integer_as() const {
        const std::int64_t value = integer();
        if (value < std::numeric_limits<Integer>::min() ||
            value > std::numeric_limits<Integer>::max())
            fail("is out of range", "train or export the model again");
        return static_cast<Integer>(value);
    }
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
