#pragma once

#include <stdexcept>
#include <string>

namespace specula {

/// Somebody asked the program to stop: Ctrl-C, kill, or a batch system.
class Interrupted : public std::runtime_error {
  public:
    Interrupted(int signal_number, const std::string& text)
        : std::runtime_error(text), signal_number_(signal_number) {}
    int exit_status() const { return 128 + signal_number_; }

  private:
    int signal_number_;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP only set a mark; a second one ends the process at
/// once, which the protocol of shards allows. One at a time.
class InterruptionWatch {
  public:
    /// @in  message  of the error: what is kept, and how to go on
    explicit InterruptionWatch(std::string message);
    ~InterruptionWatch();
    InterruptionWatch(const InterruptionWatch&) = delete;
    InterruptionWatch& operator=(const InterruptionWatch&) = delete;

    /// Throws Interrupted when a signal came to the one that lives.
    static void check();
};

}  // namespace specula
