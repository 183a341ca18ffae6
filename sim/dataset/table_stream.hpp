#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "sim/dataset/hdf5_table.hpp"

namespace specula {

/// Rows that come in any number and go to a table chunk by chunk, so that memory holds one chunk.
template <typename T>
class TableStream {
  public:
    explicit TableStream(Hdf5Table table)
        : table_(std::move(table)),
          per_chunk_(table_.rows_per_chunk() * TableShape{table_.size()}.values_per_row()) {}

    void add(std::span<const T> values) {
        while (!values.empty()) {
            const std::size_t n = std::min(values.size(), per_chunk_ - waiting_.size());
            waiting_.insert(waiting_.end(), values.begin(),
                            values.begin() + static_cast<std::ptrdiff_t>(n));
            values = values.subspan(n);
            if (waiting_.size() == per_chunk_) flush();
        }
    }
    /// Writes what waits; after the last row.
    void flush() {
        table_.write_rows<T>(next_row_, waiting_);
        next_row_ += waiting_.size() / TableShape{table_.size()}.values_per_row();
        waiting_.clear();
    }

  private:
    Hdf5Table table_;
    std::size_t per_chunk_;
    std::size_t next_row_ = 0;
    std::vector<T> waiting_;
};

}  // namespace specula
