#pragma once

#include <array>
#include <mutex>

namespace specula {

/// Values of a whole number up to n, each made when it is first asked for, by whichever thread, and
/// kept.
template <typename T, std::size_t n>
class MadeOnce {
  public:
    template <typename Make>
    const T& operator()(int number, const Make& make) {
        Value& of = values_.at(static_cast<std::size_t>(number));
        std::call_once(of.once, [&] { of.value = make(number); });
        return of.value;
    }

  private:
    struct Value {
        std::once_flag once;
        T value;
    };
    std::array<Value, n + 1> values_;
};

}  // namespace specula
