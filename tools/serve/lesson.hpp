#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/serve/scene_request.hpp"

namespace specula {

/// A scene file whose leading comment teaches: its title, paragraphs, "Look for: ..." and
/// "Try: tilt_deg = 10, tilted = sample: what happens then".
struct Lesson {
    /// Something to change, and what then comes of it. Keys are those of requests, and `model`.
    struct Try {
        FloatJson set;
        std::string text;
    };

    std::string name;  ///< the file's stem
    std::string title;
    std::vector<std::string> text;  ///< (paragraph)
    std::string look_for;
    std::vector<Try> tries;
    SceneRequest scene;
};

/// Throws InputError `file: ...` where the comment or a try says what the page cannot do.
Lesson read_lesson(const std::filesystem::path& file, const Catalogue& catalogue,
                   const KnownNames& known);

/// All of scenes/lessons, by name; none where there is no such folder.
std::vector<Lesson> read_lessons(const Catalogue& catalogue, const KnownNames& known);

FloatJson lesson_json(const Lesson& lesson);

}  // namespace specula
