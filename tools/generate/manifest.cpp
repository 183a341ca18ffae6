#include "tools/generate/manifest.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t digits = 64;

bool is_manifest(const fs::path& file) {
    return file.filename().string().rfind("manifest", 0) == 0 && file.extension() == ".sha256";
}

std::string line_of(const std::string& shard, const std::string& hash) {
    return hash + "  " + shard + "\n";
}

bool is_line(const std::string& line) {
    return line.size() > digits + 2 && line[digits] == ' ' && line[digits + 1] == ' ' &&
           line.find_first_not_of("0123456789abcdef") == digits &&
           line.find('/') == std::string::npos;
}

void add_lines(const fs::path& file, ShardHashes& hashes) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    std::size_t number = 0;
    for (std::string line; std::getline(text, line); ++number) {
        if (text.eof()) return;  // without its end: cut short, or on its way
        if (!is_line(line))
            throw InputError(
                format("{}:{}: is not a hash and a name; remove the line, and the "
                       "shard it stood for is hashed anew",
                       file.string(), number + 1));
        const std::string shard = line.substr(digits + 2), hash = line.substr(0, digits);
        const auto [known, is_new] = hashes.emplace(shard, hash);
        if (!is_new && known->second != hash)
            throw InputError(
                format("{}: gives {} another hash than an earlier line; the same "
                       "sessions came out differently, so look for a broken machine",
                       file.string(), shard));
    }
}

}  // namespace

ShardHashes read_manifests(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_manifest(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ShardHashes hashes;
    for (const fs::path& file : files) add_lines(file, hashes);
    return hashes;
}

void append_to_manifest(const fs::path& manifest, const std::string& shard,
                        const std::string& hash) {
    const auto fail = [&](const char* what) {
        throw SystemError(manifest.string() + ": cannot " + what + ": " + std::strerror(errno));
    };
    const int descriptor = ::open(manifest.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor == -1) fail("create");
    std::string line = line_of(shard, hash);
    char last = '\n';
    const off_t size = ::lseek(descriptor, 0, SEEK_END);
    if (size > 0 && ::pread(descriptor, &last, 1, size - 1) == 1 && last != '\n') {
        // A line that a kill cut short goes: nothing after it could be read.
        off_t end = size;
        while (end > 0 && ::pread(descriptor, &last, 1, end - 1) == 1 && last != '\n') --end;
        if (::ftruncate(descriptor, end) == -1) {
            ::close(descriptor);
            fail("shorten");
        }
    }
    const ssize_t n = ::write(descriptor, line.data(), line.size());
    const bool written = n == static_cast<ssize_t>(line.size());
    if (n >= 0 && !written) errno = ENOSPC;  // part of a line: the disk took no more
    const bool on_disk = written && ::fsync(descriptor) == 0;
    const int error = errno;
    ::close(descriptor);
    errno = error;
    if (!on_disk) fail("write");
}

std::string manifest_text(const ShardHashes& hashes) {
    std::string text;
    for (const auto& [shard, hash] : hashes) text += line_of(shard, hash);
    return text;
}

}  // namespace specula
