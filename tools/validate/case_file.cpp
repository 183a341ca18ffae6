#include "tools/validate/case_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in || fs::is_directory(path))
        throw InputError(path.string() + ": cannot be read; name a folder of case files or one");
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The last `"name":` before a place in the text, for messages; empty where there is none.
std::string field_before(const std::string& text, std::size_t place) {
    for (std::size_t colon = std::min(place, text.size()); colon-- > 0;) {
        if (text[colon] != ':') continue;
        std::size_t end = colon;
        while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\n')) --end;
        if (end < 2 || text[end - 1] != '"') continue;
        const std::size_t begin = text.rfind('"', end - 2);
        if (begin == std::string::npos) return {};
        return text.substr(begin + 1, end - begin - 2);
    }
    return {};
}

std::ptrdiff_t line_of(const std::string& text, std::size_t place) {
    const std::size_t end = std::min(place, text.size());
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
}

[[noreturn]] void not_json(const fs::path& path, const std::string& text, std::size_t place) {
    const std::size_t at = std::min(place > 0 ? place - 1 : 0, text.size());
    const std::size_t around = at - std::min<std::size_t>(at, 10);
    const std::string near = text.substr(around, 20);
    const std::string field = field_before(text, at);
    const std::string where =
        format("{}:{}: {}", path.string(), line_of(text, at), field.empty() ? "" : field + ": ");
    if (near.find("NaN") != std::string::npos || near.find("Infinity") != std::string::npos)
        throw InputError(where + "NaN and Infinity are no numbers in JSON; give a finite number");
    throw InputError(where + "not JSON from here on; mend the file");
}

/// A number beyond double; the parser's words end in "parsing '1e999'".
[[noreturn]] void too_large(const fs::path& path, const std::string& text,
                            const std::string& words) {
    const std::size_t quote = words.find('\'');
    const std::string number = words.substr(quote + 1, words.rfind('\'') - quote - 1);
    const std::size_t place = text.find(number);
    throw InputError(format("{}:{}: {} = {}: beyond what a computer counts to; use less than 1e308",
                            path.string(), line_of(text, place), field_before(text, place),
                            number));
}

nlohmann::json parsed(const fs::path& path, const std::string& text) {
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        not_json(path, text, error.byte);
    } catch (const nlohmann::json::exception& error) {
        too_large(path, text, error.what());
    }
}

[[noreturn]] void fail(const fs::path& path, const std::string& field, const std::string& problem,
                       const std::string& remedy) {
    throw InputError(format("{}: {}: {}; {}", path.string(), field, problem, remedy));
}

std::string text_field(const fs::path& path, const nlohmann::json& document, const char* name) {
    if (!document.contains(name)) fail(path, name, "missing", "every case has one");
    if (!document[name].is_string()) fail(path, name, "not a text", "give one in quotes");
    return document[name];
}

void check_points(const fs::path& path, const nlohmann::json& document) {
    if (!document.contains("points")) fail(path, "points", "missing", "every case has a list");
    const nlohmann::json& points = document["points"];
    if (!points.is_array()) fail(path, "points", "not a list", "give a list of {inp, expect}");
    if (points.empty()) fail(path, "points", "empty", "give one point at least");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string point = format("points[{}]", i);
        if (!points[i].is_object()) fail(path, point, "not an object", "give {inp, expect}");
        for (const char* part : {"inp", "expect"}) {
            const std::string field = point + "." + part;
            if (!points[i].contains(part)) fail(path, field, "missing", "every point has one");
            if (!points[i][part].is_object())
                fail(path, field, "not an object", "give names and values in braces");
        }
        if (points[i]["expect"].empty())
            fail(path, point + ".expect", "empty", "give one quantity at least");
    }
}

CaseFile case_of(const fs::path& path, nlohmann::json document) {
    if (!document.is_object()) fail(path, "the file", "not an object", "give {id, points, ...}");
    CaseFile file{.path = path,
                  .id = text_field(path, document, "id"),
                  .title = text_field(path, document, "title"),
                  .level = document.contains("level") ? text_field(path, document, "level") : "",
                  .n_points = 0,
                  .document = nullptr};
    if (file.id.empty()) fail(path, "id", "empty", "begin it with the kind of case, as M03_slab");
    if (!document.contains("tolerance"))
        fail(path, "tolerance", "missing", "say how far off is near enough");
    if (!document["tolerance"].is_object())
        fail(path, "tolerance", "not an object", "give names and numbers in braces");
    check_points(path, document);
    file.n_points = document["points"].size();
    file.document = std::make_shared<const nlohmann::json>(std::move(document));
    return file;
}

bool is_case(const nlohmann::json& document) {
    return !document.is_object() || document.contains("id") || document.contains("points");
}

}  // namespace

Fields CaseFile::inp(std::size_t point) const {
    return {(*document)["points"][point]["inp"],
            format("{}: points[{}].inp", path.string(), point)};
}

Fields CaseFile::expect(std::size_t point) const {
    return {(*document)["points"][point]["expect"],
            format("{}: points[{}].expect", path.string(), point)};
}

Fields CaseFile::tolerance() const {
    return {(*document)["tolerance"], path.string() + ": tolerance"};
}

std::optional<double> CaseFile::agreed_number(const std::string& name) const {
    std::optional<double> agreed;
    for (std::size_t i = 0; i < n_points; ++i) {
        const Fields point = inp(i);
        if (!point.has(name)) continue;
        const double value = point.number(name);
        if (agreed && *agreed != value) return std::nullopt;
        agreed = value;
    }
    return agreed;
}

CaseFile read_case_file(const fs::path& path) {
    return case_of(path, parsed(path, content_of(path)));
}

CaseFolder read_case_folder(const fs::path& folder) {
    if (!fs::exists(folder))
        throw InputError(folder.string() + ": no such folder; name one that holds case files");
    CaseFolder result;
    if (!fs::is_directory(folder)) {
        result.cases.push_back(read_case_file(folder));
        return result;
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& path : files) {
        nlohmann::json document = parsed(path, content_of(path));
        if (is_case(document))
            result.cases.push_back(case_of(path, std::move(document)));
        else
            result.others.push_back(path.filename().string());
    }
    if (result.cases.empty())
        throw InputError(folder.string() + ": holds no case file; name a folder that does");
    return result;
}

}  // namespace specula
