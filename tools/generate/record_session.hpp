#pragma once

#include "sim/dataset/dataset_writer.hpp"
#include "tools/generate/recipe.hpp"

namespace specula {

/// Names, shapes and origin of a recipe's dataset; no frames in it.
Dataset dataset_form(const Recipe& recipe);
StoredTables stored_tables(const Recipe& recipe);

/// The frames of one session, ready for the file; sessions are numbered by world, class and
/// session. Depends on nothing but its arguments.
FrameBlock record_session(const Recipe& recipe, const Library& materials, std::size_t number);

}  // namespace specula
