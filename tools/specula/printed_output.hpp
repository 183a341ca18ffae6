#pragma once

namespace specula {

/// Brings what was printed to where it goes. Throws SystemError when that has no room; a reader who
/// closed the pipe has seen enough.
void flush_printed_output();

}  // namespace specula
