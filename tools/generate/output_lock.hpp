#pragma once

#include <filesystem>
#include <string>

namespace specula {

/// One process among those that could write the same: an flock on a file that tells who holds it.
/// It ends with the process, whatever ends that, so that no lock is ever left over.
class OutputLock {
  public:
    enum class Kind { alone, beside_others };

    /// Throws InputError naming the holder where another process has the lock, and SystemError
    /// where the file cannot be made.
    OutputLock(const std::filesystem::path& file, Kind kind);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

  private:
    int descriptor_ = -1;
};

}  // namespace specula
