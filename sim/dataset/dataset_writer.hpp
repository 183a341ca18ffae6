#pragma once

#include <memory>
#include <optional>

#include "sim/dataset/frame_block.hpp"
#include "sim/dataset/stored_tables.hpp"

namespace specula {

/// Which sessions of a whole run a file holds: [first, first + count) of n_in_all.
struct SessionSpan {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t n_in_all = 0;

    std::size_t end() const { return first + count; }
    bool operator==(const SessionSpan&) const = default;
};

/// What a dataset file says besides its frames.
struct DatasetHead {
    const Dataset& form;  ///< names, shapes and origin; its frames are not looked at
    StoredTables tables;
    std::size_t n_frames = 0;
    std::optional<SessionSpan> shard;  ///< of a part of a run; nothing: a whole one
};

/// Writes a dataset file of any length in little memory: frames go to the disk as they come.
///
/// The bytes of the file depend on head and frames, not on how the frames were parted into blocks.
/// One thread at a time. Throws SystemError naming the path and the reason.
class DatasetWriter {
  public:
    DatasetWriter(const std::filesystem::path& file, const DatasetHead& head);
    ~DatasetWriter();  ///< what is not published is removed
    DatasetWriter(const DatasetWriter&) = delete;
    DatasetWriter& operator=(const DatasetWriter&) = delete;

    void append(const FrameBlock& block);
    /// A column beside those of the format, one number per frame, in a group of its own, which is
    /// made; readers that do not know it pass it over.
    struct FurtherColumn {
        std::string name;  ///< path, e.g. "/augmentation/copy"
        std::string unit;
        std::string meaning;
    };
    void add_column(const FurtherColumn& column, const std::vector<double>& values);
    /// A text of such a group.
    void set_group_text(const std::string& group, const std::string& name, const std::string& text);

    /// After the last frame: puts the file in place, whole and on the disk. Returns the fingerprint
    /// of all frames.
    std::string publish();
    /// The same, but throws InputError where a file of that name appeared meanwhile, which stays.
    std::string publish_new();

  private:
    class Streams;
    std::unique_ptr<Streams> streams_;
};

}  // namespace specula
