#pragma once

#include <stdexcept>
#include <string>

namespace specula {

/// A mistake of ours, never of the user's: the program ends with the condition and its place.
class BrokenPromise : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

[[noreturn]] inline void broken_promise(const char* condition, const char* file, int line) {
    throw BrokenPromise(std::string("internal error: expected ") + condition + " at " + file + ":" +
                        std::to_string(line));
}

}  // namespace specula

#define SPECULA_EXPECT(condition) \
    ((condition) ? (void)0 : ::specula::broken_promise(#condition, __FILE__, __LINE__))
