#pragma once

#include <span>
#include <string_view>

namespace specula {

/// A file of the page, compiled into the program: what is not in the table does not exist.
struct PageFile {
    std::string_view path;  ///< of the URL
    std::string_view type;  ///< media type
    std::string_view content;
};

/// All of them; made by tools/serve/page.cmake.
std::span<const PageFile> page_files();

}  // namespace specula
