#pragma once

namespace specula {

/// Waits for Ctrl-C or SIGTERM in place of dying of them, from its making on.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    void wait() const;
};

}  // namespace specula
