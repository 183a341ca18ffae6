#pragma once

#include <optional>

#include "sim/dataset/dataset_writer.hpp"
#include "sim/dataset/hdf5_file.hpp"

namespace specula {

/// An open dataset file, read as many frames at a time as one likes. Every failure is an InputError
/// that names the file and the object.
class DatasetReader {
  public:
    explicit DatasetReader(const std::filesystem::path& file);

    /// Origin, names and shapes; no frames in it.
    const Dataset& form() const { return form_; }
    const StoredTables& tables() const { return tables_; }
    std::size_t n_frames() const { return n_frames_; }
    /// Which sessions of a whole run are here; nothing where the file is not a part of one.
    const std::optional<SessionSpan>& shard() const { return shard_; }

    /// These frames, checked against their hashes (from version 3 on).
    Dataset read(const FrameRange& range) const;
    /// The same without unpacking their codes, and without checking them; versions from 3 on.
    FrameBlock read_packed(const FrameRange& range) const;
    /// /frame_hash of these frames; computed where the file is older than that table.
    std::vector<std::uint64_t> frame_hashes(const FrameRange& range) const;

  private:
    void read_origin();
    void read_forms();
    void read_codes_form();
    template <typename T>
    std::vector<T> rows(const std::string& table, const FrameRange& range) const;
    template <typename T>
    std::vector<T> finite_rows(const std::string& table, std::size_t per_frame,
                               const FrameRange& range) const;
    std::vector<Truth> truth(const FrameRange& range) const;
    double bin_m(const std::string& object, const std::string& name) const;
    void check_names(const std::string& attribute, const std::vector<std::string>& names) const;
    void check_label_names() const;
    void check_truth(const Truth& frame, std::size_t row) const;
    void check_hashes(const Dataset& frames, const FrameRange& range) const;
    [[noreturn]] void fail(const std::string& problem) const;

    std::filesystem::path file_;
    Hdf5File in_;
    double version_ = 0.0;
    Dataset form_;
    StoredTables tables_;
    std::size_t n_frames_ = 0;
    std::optional<SessionSpan> shard_;
};

}  // namespace specula
