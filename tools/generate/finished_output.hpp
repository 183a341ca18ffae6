#pragma once

#include "tools/generate/shard_plan.hpp"

namespace specula {

/// Where a run's dataset ends up, and where its shards wait until then.
class FinishedOutput {
  public:
    explicit FinishedOutput(const std::filesystem::path& out);

    /// FILE.h5, or the index of a folder.
    const std::filesystem::path& file() const { return file_; }
    /// FILE.h5.parts, or the folder itself.
    const std::filesystem::path& shards() const { return shards_; }

    /// Whether the dataset is there, whole: all its frames are read and held against their hashes, the
    /// shards of a folder against the manifest, the file against the document beside it. Throws InputError where something else is there
    /// (another recipe's dataset, no dataset, no file), or a damaged one, and says what to do.
    bool is_there(const std::string& recipe) const;
    /// Whether Croissant metadata beside it tell its SHA-256, to which is_there holds it; without,
    /// truth and groups are checked by nothing but HDF5's checksums.
    bool has_document() const;
    std::string fingerprint() const;
    double bytes() const;

    /// Drafts of the finished file that a killed process left; a share never makes them.
    void remove_drafts(const Share& share) const;
    /// Once the file is in place: the shards that it was made of, or the locks among those that
    /// stay.
    void remove_leftovers() const;

  private:
    /// Throws InputError where the document beside the file tells another SHA-256 than it has.
    void check_document() const;
    /// Whether the manifest names shards and all of them are there. Throws InputError for one whose
    /// content is not what the manifest tells.
    bool shards_are_whole() const;

    std::filesystem::path file_;
    std::filesystem::path shards_;
    bool keeps_shards_;
};

}  // namespace specula
