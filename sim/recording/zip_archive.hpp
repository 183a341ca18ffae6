#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// The members of a ZIP archive, such as an .npz file; stored or deflated, below 4 GiB each.
/// @eq  PKWARE APPNOTE.TXT 6.3: 4.3.7 local headers, 4.3.12 central directory, 4.3.16 its end
///
/// The one door to zlib. Throws InputError with the byte where the archive is not what it says:
/// also for sizes that no compression reaches, before memory is taken.
class ZipArchive {
  public:
    /// @in  bytes  the whole file; must outlive the archive
    explicit ZipArchive(Bytes bytes);

    std::vector<std::string> names() const;
    bool has(const std::string& name) const { return members_.count(name) != 0; }
    /// A member's content, its checksum compared. Throws InputError for a name it does not have.
    std::vector<std::uint8_t> extract(const std::string& name) const;

  private:
    struct Member {
        std::size_t entry = 0;  ///< of the directory, for messages
        unsigned method = 0;
        std::uint32_t checksum = 0;
        std::size_t packed_bytes = 0;
        std::size_t bytes = 0;
        std::size_t offset = 0;  ///< of the local header
    };
    std::size_t read_entry(std::size_t at);
    Bytes packed(const Member& member) const;

    Bytes bytes_;
    std::map<std::string, Member> members_;
};

}  // namespace specula
