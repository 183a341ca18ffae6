#pragma once

#include <string>

#include "tools/firmware/verification.hpp"

namespace specula {

/// The whole result as text for a terminal; the tables of firmware/README.md are copied from it.
std::string verify_report(const VerifyInput& input, const Verification& verification);

}  // namespace specula
