#include "classifier/json_field.hpp"

#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string shortened(const FloatJson& value) {
    constexpr std::size_t longest = 40;
    if (value.is_array()) return format("[{} values]", value.size());
    if (value.is_object()) return "{...}";
    const std::string text = value.dump(-1, ' ', true, FloatJson::error_handler_t::replace);
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace

void JsonField::fail(const std::string& problem, const std::string& remedy) const {
    throw InputError(format("{}: {} = {}: {}; {}", *file_, path_.empty() ? "whole file" : path_,
                            shortened(*value_), problem, remedy));
}

JsonField JsonField::at(const std::string& key) const {
    if (!value_->is_object()) fail("is not an object", "write { ... }");
    const auto found = value_->find(key);
    if (found == value_->end())
        fail(format("has no \"{}\"", key), "train or export the model again");
    JsonField field(*file_, *found);
    field.path_ = path_.empty() ? key : path_ + "." + key;
    field.key_ = key;
    return field;
}

std::vector<JsonField> JsonField::items() const {
    if (!value_->is_structured()) fail("is not a list", "write [ ... ]");
    std::vector<JsonField> fields;
    for (const auto& [key, value] : value_->items()) {
        JsonField field(*file_, value);
        field.path_ = value_->is_array() ? format("{}[{}]", path_, key) : path_ + "." + key;
        field.key_ = key;
        fields.push_back(field);
    }
    return fields;
}

std::string JsonField::text() const {
    if (!value_->is_string()) fail("is not text", "put it in quotes");
    return value_->get<std::string>();
}

std::int64_t JsonField::integer() const {
    if (!value_->is_number_integer()) fail("is not an integer", "write digits only");
    return value_->get<std::int64_t>();
}

std::vector<float> JsonField::numbers(std::size_t n, float min) const {
    if (!value_->is_array()) fail("is not a list", "write [ ... ]");
    if (value_->size() != n) fail("has the wrong length", format("{} numbers belong here", n));
    std::vector<float> numbers;
    for (const JsonField& item : items()) {
        if (!item.value_->is_number()) item.fail("is not a number", "write a finite number");
        const float number = item.value_->get<float>();
        if (!std::isfinite(number)) item.fail("is not finite", "write a finite number");
        if (number < min) item.fail("is out of range", format("use {} or more", min));
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace specula
