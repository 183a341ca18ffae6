#pragma once

#include <filesystem>
#include <string>

namespace specula {

/// One process among those that could write the same: an flock on a file that tells who holds it.
/// It ends with the process, whatever ends that, so that no lock is ever left over.
class OutputLock {
  public:
    enum class Kind {
        alone,          ///< refused where anyone has the lock
        beside_others,  ///< refused where one is alone
        in_turn,        ///< waits until nobody has it
    };

    /// Throws InputError naming the holder where it is refused, and SystemError where the file
    /// cannot be made.
    OutputLock(const std::filesystem::path& file, Kind kind);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

  private:
    int descriptor_ = -1;
};

}  // namespace specula
