#pragma once

#include "tools/firmware/verification.hpp"

namespace specula {

/// A folder for files in between, which goes with this object; and where the rest is. The target's
/// program is built in cortex-m4/ beside this program and kept; where that cannot be written, in
/// the folder too.
class TemporaryWorkplace {
  public:
    TemporaryWorkplace();
    TemporaryWorkplace(const TemporaryWorkplace&) = delete;
    TemporaryWorkplace& operator=(const TemporaryWorkplace&) = delete;
    ~TemporaryWorkplace();

    const Workplace& get() const { return place_; }

  private:
    Workplace place_;
};

}  // namespace specula
