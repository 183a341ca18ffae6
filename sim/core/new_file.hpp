#pragma once

#include <filesystem>

namespace specula {

/// publish_file for a name that nothing has yet: where a file of that name appeared meanwhile, that
/// one stays. Throws InputError then, and else as publish_file; `draft` is then still there.
void publish_new_file(const std::filesystem::path& draft, const std::filesystem::path& file);

}  // namespace specula
