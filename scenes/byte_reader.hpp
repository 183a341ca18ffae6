#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace specula {

/// Numbers of a binary file, one after the other; beyond the end or not finite they are an
/// InputError `file: byte n: problem; remedy`.
class ByteReader {
  public:
    enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

    /// @in  content  must outlive the reader
    ByteReader(std::string file, std::string_view content, std::endian order)
        : file_(std::move(file)), content_(content), order_(order) {}

    void skip(std::uint64_t n_bytes);
    double number(Type type);
    double finite_number(Type type);
    std::size_t left() const { return content_.size() - at_; }

    static std::size_t size_of(Type type);
    [[noreturn]] void fail(std::string_view problem, std::string_view remedy) const;

  private:
    template <typename Value>
    double take();

    std::string file_;
    std::string_view content_;
    std::endian order_;
    std::size_t at_ = 0;
};

}  // namespace specula
