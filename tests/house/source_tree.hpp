#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace specula {

/// One file of the project, its path relative to the root and with '/'.
struct SourceFile {
    std::string path;
    std::vector<std::string> lines;  // only of files that are read as source, see is_source
};

/// One `#include`, with the file of ours that it names.
struct Include {
    std::size_t line;    // from 1
    std::string header;  // as written, without quotes or brackets
    std::string path;    // relative to the root; empty if it is no file of ours
};

inline bool is_source(const std::filesystem::path& path) {
    static const std::set<std::string> extensions{".c",  ".h",  ".cpp", ".hpp",   ".S",
                                                  ".py", ".sh", ".js",  ".cmake", ".ld"};
    return extensions.count(path.extension().string()) != 0 ||
           path.filename() == "CMakeLists.txt" || path == "specula";
}

/// The header that a line includes, after the quote or bracket that opens it; empty if it does not.
inline std::string_view included(std::string_view line) {
    const auto skip = [&line](std::string_view what) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.substr(0, what.size()) != what) return false;
        line.remove_prefix(what.size());
        return true;
    };
    if (!skip("#") || !skip("include") || !skip("") || line.empty()) return {};
    if (line.front() != '"' && line.front() != '<') return {};
    const auto end = line.find(line.front() == '<' ? '>' : '"', 1);
    return end == line.npos ? std::string_view{} : line.substr(0, end);
}

/// The project's files, as the house laws see them, sorted by path.
///
/// Left out: hidden folders, outputs (`build*`, `out`) and any other folder CMake builds in.
class SourceTree {
  public:
    explicit SourceTree(const std::filesystem::path& root) {
        namespace fs = std::filesystem;
        for (auto entry = fs::recursive_directory_iterator(root); entry != end(entry); ++entry) {
            const auto path = fs::relative(entry->path(), root);
            if (entry->is_directory()) {
                if (is_left_out(path) || fs::exists(entry->path() / "CMakeCache.txt")) {
                    entry.disable_recursion_pending();
                }
            } else if (entry->is_regular_file()) {
                files_.push_back({path.generic_string(), is_source(path)
                                                             ? read_lines(entry->path())
                                                             : std::vector<std::string>{}});
                paths_.insert(path.generic_string());
            }
        }
        std::sort(files_.begin(), files_.end(),
                  [](const auto& left, const auto& right) { return left.path < right.path; });
    }

    const std::vector<SourceFile>& files() const { return files_; }

    /// What a file includes. As the compiler does, a header is looked for beside the file (only if
    /// in quotes), then from the root. Conditions are ignored: both sides of an #if count.
    std::vector<Include> includes(const SourceFile& file) const {
        const auto folder = std::filesystem::path(file.path).parent_path();
        std::vector<Include> found;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const auto opened = included(file.lines[i]);
            if (opened.empty()) continue;
            const std::string header(opened.substr(1));
            const auto beside = (folder / header).lexically_normal().generic_string();
            const auto below_root = std::filesystem::path(header).lexically_normal();
            std::string path;
            if (opened.front() == '"' && paths_.count(beside) != 0) {
                path = beside;
            } else if (paths_.count(below_root.generic_string()) != 0) {
                path = below_root.generic_string();
            }
            found.push_back({i + 1, header, path});
        }
        return found;
    }

  private:
    static bool is_left_out(const std::filesystem::path& folder) {
        const auto name = folder.filename().string();
        const bool at_the_top = folder == folder.filename();
        return name.front() == '.' || name == "__pycache__" ||
               (at_the_top && (name == "out" || name.rfind("build", 0) == 0));
    }

    static std::vector<std::string> read_lines(const std::filesystem::path& path) {
        std::vector<std::string> lines;
        std::ifstream stream(path);
        for (std::string line; std::getline(stream, line);) lines.push_back(line);
        return lines;
    }

    std::vector<SourceFile> files_;
    std::set<std::string> paths_;
};

/// A tree that exists only during one test, to show that a law notices what it forbids.
class MadeUpTree {
  public:
    MadeUpTree() {
        auto name = (std::filesystem::temp_directory_path() / "specula_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed: " + name);
        root_ = name;
    }
    ~MadeUpTree() {
        std::error_code ignored;
        std::filesystem::remove_all(root_, ignored);
    }
    MadeUpTree(const MadeUpTree&) = delete;
    MadeUpTree& operator=(const MadeUpTree&) = delete;

    MadeUpTree& with(std::string_view path, std::string_view text) {
        std::filesystem::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
        return *this;
    }
    SourceTree read() const { return SourceTree(root_); }

  private:
    std::filesystem::path root_;
};

/// What a law found, one line each: `file:line: what is wrong`.
using Breaches = std::vector<std::string>;

inline std::string breach(const std::string& path, std::size_t line, const std::string& what) {
    return path + ":" + std::to_string(line) + ": " + what;
}

inline std::string one_per_line(const Breaches& breaches) {
    std::string text;
    for (const auto& line : breaches) text += "\n  " + line;
    return text;
}

}  // namespace specula
