#include <regex>

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tools/serve/page_file.hpp"

namespace specula {
namespace {

bool is_served(const std::string& path) {
    for (const PageFile& file : page_files())
        if (file.path == path) return true;
    return false;
}

/// Our own files; the library is another's.
std::vector<PageFile> own_files() {
    std::vector<PageFile> own;
    for (const PageFile& file : page_files())
        if (file.path.rfind("/three/", 0) != 0) own.push_back(file);
    return own;
}

TEST_CASE("whatever a file of the page asks for is served with it", "[serve]") {
    const std::regex asked(R"((?:from |src=|href=|fetch\()["'](?:\./)?(\w[\w/]*\.\w[\w.]*)["'])");
    int n_found = 0;
    for (const PageFile& file : own_files()) {
        const std::string text(file.content);
        for (std::sregex_iterator it(text.begin(), text.end(), asked), end; it != end; ++it) {
            const std::string name = (*it)[1];
            INFO(file.path << " asks for " << name);
            CHECK(is_served("/" + name));
            ++n_found;
        }
    }
    CHECK(n_found > 15);
}

TEST_CASE("the page needs nothing from elsewhere and no exception from its policy", "[serve]") {
    for (const PageFile& file : own_files()) {
        std::string text(file.content);
        for (const char* name_space : {"http://www.w3.org/2000/svg"})
            for (std::size_t at; (at = text.find(name_space)) != std::string::npos;)
                text.erase(at, std::string(name_space).size());
        INFO(file.path);
        for (const char* word :
             {"http://", "https://", "innerHTML", "outerHTML", "insertAdjacentHTML",
              "document.write", "eval(", "new Function", " style=", " onclick="})
            CHECK(text.find(word) == std::string::npos);
    }
}

TEST_CASE("the page's files are compiled in as they lie in the source", "[serve]") {
    for (const PageFile& file : own_files())
        CHECK(file.content == project_file("tools/serve/page" + std::string(file.path)));
    CHECK(is_served("/three/build/three.module.js"));
    CHECK(is_served("/three/licence.txt"));
}

}  // namespace
}  // namespace specula
