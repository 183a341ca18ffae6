#include "tools/serve/lesson.hpp"

#include <algorithm>
#include <sstream>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/serve/requested_scene.hpp"
#include "tools/serve/rung.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

std::string stripped(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The comment's paragraphs, each on one line; a line of "Try:" or "Look for:" begins one too.
std::vector<std::string> paragraphs(const std::string& source) {
    std::vector<std::string> found{""};
    std::istringstream lines(source);
    for (std::string line; std::getline(lines, line) && line.rfind("#", 0) == 0;) {
        const std::string words = stripped(line.substr(1));
        const bool begins = words.rfind("Try:", 0) == 0 || words.rfind("Look for:", 0) == 0;
        if ((words.empty() || begins) && !found.back().empty()) found.emplace_back();
        found.back() += (found.back().empty() || words.empty() ? "" : " ") + words;
    }
    if (found.back().empty()) found.pop_back();
    return found;
}

/// "tilt_deg = 10" as a member of `set`: a number where it reads as one, else text.
void add_setting(const std::string& setting, const std::string& place, FloatJson& set) {
    const std::size_t sign = setting.find('=');
    if (sign == std::string::npos)
        throw InputError(format("{}: \"{}\": sets nothing; write key = value", place, setting));
    const std::string key = stripped(setting.substr(0, sign));
    const std::string value = stripped(setting.substr(sign + 1));
    set[key] = FloatJson::accept(value) ? FloatJson::parse(value) : FloatJson(value);
}

void check_model(const FloatJson& value, const std::string& place) {
    for (const RungRecipe& recipe : rung_recipes)
        if (value == recipe.name) return;
    throw InputError(format("{}: model = {}: is no model of the page", place, value.dump()));
}

Lesson::Try read_try(const std::string& text, const std::string& place, const KnownNames& known) {
    const std::size_t colon = text.find(": ");
    if (colon == std::string::npos)
        throw InputError(
            format("{}: \"{}\": write Try: key = value: what happens then", place, text));
    Lesson::Try found{.set = FloatJson::object(), .text = stripped(text.substr(colon + 1))};
    std::istringstream settings(text.substr(0, colon));
    for (std::string each; std::getline(settings, each, ',');) add_setting(each, place, found.set);
    FloatJson request = found.set;
    if (request.contains("model")) check_model(request["model"], place);
    request.erase("model");
    try {
        read_request(request, known);
    } catch (const FieldError& error) {
        throw InputError(
            format("{}: {}: {}; {}", place, error.field(), error.what(), error.remedy()));
    }
    return found;
}

}  // namespace

Lesson read_lesson(const fs::path& file, const Catalogue& catalogue, const KnownNames& known) {
    Lesson lesson;
    lesson.name = file.stem().string();
    lesson.scene = request_of_file(file, catalogue);
    const std::string try_mark = "Try:", look_mark = "Look for:";
    const auto parts = paragraphs(Section::read(file).source());
    for (const std::string& part : parts) {
        if (part.rfind(try_mark, 0) == 0)
            lesson.tries.push_back(read_try(part.substr(try_mark.size()), file.string(), known));
        else if (part.rfind(look_mark, 0) == 0)
            lesson.look_for = stripped(part.substr(look_mark.size()));
        else if (lesson.title.empty())
            lesson.title = part;
        else
            lesson.text.push_back(part);
    }
    if (lesson.title.empty() || lesson.text.empty() || lesson.look_for.empty())
        throw InputError(file.string() +
                         ": teaches nothing; begin it with a comment of a title, a paragraph, and "
                         "one that begins with \"Look for:\"");
    return lesson;
}

std::vector<Lesson> read_lessons(const Catalogue& catalogue, const KnownNames& known) {
    const fs::path folder = catalogue.root / "scenes/lessons";
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (is_description(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Lesson> lessons;
    for (const fs::path& file : files) lessons.push_back(read_lesson(file, catalogue, known));
    return lessons;
}

FloatJson lesson_json(const Lesson& lesson) {
    FloatJson tries = FloatJson::array();
    for (const Lesson::Try& each : lesson.tries)
        tries.push_back({{"set", each.set}, {"text", each.text}});
    return {{"name", lesson.name}, {"title", lesson.title},
            {"text", lesson.text}, {"look_for", lesson.look_for},
            {"tries", tries},      {"scene", request_json(lesson.scene)}};
}

}  // namespace specula
