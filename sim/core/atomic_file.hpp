#pragma once

#include <filesystem>
#include <string_view>

namespace specula {

/// Puts a file in place whole or not at all: whoever opens `file`, even after a power cut, finds
/// the old content or the new one, never a part.
///
/// The content goes to a new file beside it, to the disk, then under the name; mode 0666 less the
/// umask. A missing folder is made; a symbolic link is followed, so that what it names is replaced
/// or made. Throws InputError where something of that name is no file (a folder, a device, a pipe)
/// or the place takes no files (no permission, no folder), and SystemError `path: what failed:
/// reason` for all else, such as a full disk; nothing is left behind.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// Finds out, before hours of work, whether the above could put a file there: makes the folder, and
/// a draft that it removes. Throws as that does.
void check_output_place(const std::filesystem::path& file);

/// Makes a folder and those above it. Throws as above.
void make_output_folder(const std::filesystem::path& folder);

/// Gives a finished and closed file its final name, in the same folder, with the same promise; for
/// libraries that write files themselves. Throws as above; `draft` is then still there.
void publish_file(const std::filesystem::path& draft, const std::filesystem::path& file);

/// Where the content of a file of this name is to lie: a link leads on to what it names, whether
/// that is there or not. Throws as above.
std::filesystem::path place_of_file(const std::filesystem::path& name);

/// Removes drafts of `file` that killed processes left beside it, of this machine and of others;
/// those of living ones stay.
void remove_abandoned_drafts(const std::filesystem::path& file);

}  // namespace specula
