#include "scenes/byte_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

void ByteReader::skip(std::uint64_t n_bytes) {
    if (n_bytes > left()) {
        at_ = content_.size();
        fail("the file ends here, within what it announced", "is it cut off? export it again");
    }
    at_ += static_cast<std::size_t>(n_bytes);
}

template <typename Value>
double ByteReader::take() {
    const std::size_t begin = at_;
    skip(sizeof(Value));
    std::array<char, sizeof(Value)> bytes;
    std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(begin), sizeof(Value),
                bytes.begin());
    if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<Value>(bytes));
}

double ByteReader::number(Type type) {
    switch (type) {
        case Type::int8:
            return take<std::int8_t>();
        case Type::uint8:
            return take<std::uint8_t>();
        case Type::int16:
            return take<std::int16_t>();
        case Type::uint16:
            return take<std::uint16_t>();
        case Type::int32:
            return take<std::int32_t>();
        case Type::uint32:
            return take<std::uint32_t>();
        case Type::float32:
            return take<float>();
        case Type::float64:
            return take<double>();
    }
    return 0.0;
}

double ByteReader::finite_number(Type type) {
    const double value = number(type);
    if (!std::isfinite(value)) {
        at_ -= size_of(type);
        fail("a coordinate is not finite", "repair the mesh and export it again");
    }
    return value;
}

std::size_t ByteReader::size_of(Type type) {
    switch (type) {
        case Type::int8:
        case Type::uint8:
            return 1;
        case Type::int16:
        case Type::uint16:
            return 2;
        case Type::int32:
        case Type::uint32:
        case Type::float32:
            return 4;
        case Type::float64:
            return 8;
    }
    return 0;
}

void ByteReader::fail(std::string_view problem, std::string_view remedy) const {
    throw InputError(format("{}: byte {}: {}; {}", file_, at_, problem, remedy));
}

}  // namespace specula
