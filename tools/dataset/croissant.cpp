#include <sys/stat.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/sha256.hpp"
#include "tools/dataset/dataset_check.hpp"
#include "tools/dataset/dataset_documents.hpp"
#include "tools/generate/manifest.hpp"

namespace specula {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* conforms_to = "http://mlcommons.org/croissant/1.0";

/// The context of the standard's appendix 1, for the terms that are used here.
Json context() {
    Json terms = {{"@language", "en"},
                  {"@vocab", "https://schema.org/"},
                  {"cr", "http://mlcommons.org/croissant/"},
                  {"sc", "https://schema.org/"},
                  {"dct", "http://purl.org/dc/terms/"},
                  {"conformsTo", "dct:conformsTo"},
                  {"data", {{"@id", "cr:data"}, {"@type", "@json"}}},
                  {"dataType", {{"@id", "cr:dataType"}, {"@type", "@vocab"}}}};
    for (const char* term : {"citeAs", "column", "extract", "field", "fileObject", "key",
                             "recordSet", "references", "repeated", "source"})
        terms[term] = std::string("cr:") + term;
    return terms;
}

/// Day of a file in UTC, as 2026-01-31.
std::string day_of(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) throw InputError(file.string() + ": no such file");
    std::time_t time = status.st_mtime;
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
        const std::string_view text(epoch);
        std::from_chars(text.data(), text.data() + text.size(), time);
    }
    std::tm day{};
    ::gmtime_r(&time, &day);
    return format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

struct Described {
    const std::filesystem::path& file;
    const Hdf5File& in;
    std::string id() const { return file.filename().string(); }
};

std::string attribute_or(const Described& from, const std::string& object, const char* name,
                         const std::string& otherwise) {
    for (const std::string& each : from.in.attributes(object))
        if (each == name) return from.in.attribute_text(object, name);
    return otherwise;
}

/// A table as a field: what it means, its type, and where in the file it lies.
Json field_of(const Described& from, const std::string& table) {
    const std::string type = from.in.number_type(table);
    const bool is_float = type.rfind("float", 0) == 0;
    const auto shape = from.in.shape(table);
    std::string meaning = attribute_or(from, table, "long_name", table.substr(1));
    if (const std::string unit = attribute_or(from, table, "units", ""); !unit.empty())
        meaning += ", in " + unit;
    for (std::size_t axis = 1; axis < shape.size(); ++axis)
        meaning += (axis == 1 ? "; shape of a frame's: " : " x ") + std::to_string(shape[axis]);
    Json field = {{"@type", "cr:Field"},
                  {"@id", "frames" + table},
                  {"name", table.substr(1)},
                  {"description", meaning + " (" + type + ")"},
                  {"dataType", is_float ? "sc:Float" : "sc:Integer"}};
    if (shape.size() > 1) field["repeated"] = true;
    field["source"] = {{"fileObject", {{"@id", from.id()}}}, {"extract", {{"column", table}}}};
    if (table == "/label") field["references"] = {{"field", {{"@id", "classes/index"}}}};
    return field;
}

Json frames_of(const Described& from) {
    Json fields = Json::array();
    for (const std::string& table : from.in.tables())
        if (from.in.is_house_table(table) && !from.in.number_type(table).empty())
            fields.push_back(field_of(from, table));
    return {{"@type", "cr:RecordSet"},
            {"@id", "frames"},
            {"name", "frames"},
            {"description",
             "One record per frame: row i of every table of the HDF5 file. The column of a source "
             "is the path of a table in it; Croissant 1.0 has no other word for that."},
            {"field", fields}};
}

Json classes_of(const std::vector<std::string>& names) {
    Json data = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i)
        data.push_back({{"classes/index", i}, {"classes/name", names[i]}});
    const auto field = [](const char* id, const char* name, const char* type) {
        return Json{{"@type", "cr:Field"}, {"@id", id}, {"name", name}, {"dataType", type}};
    };
    return {
        {"@type", "cr:RecordSet"},
        {"@id", "classes"},
        {"name", "classes"},
        {"description", "What the numbers of frames/label stand for."},
        {"key", {{"@id", "classes/index"}}},
        {"field",
         {field("classes/index", "index", "sc:Integer"), field("classes/name", "name", "sc:Text")}},
        {"data", data}};
}

struct DescribedFile {
    std::string description;
    std::string kind;  ///< a MIME type
    std::string hash;
};

Json file_object(const std::filesystem::path& file, const DescribedFile& described) {
    const std::string name = file.filename().string();
    return {{"@type", "cr:FileObject"},
            {"@id", name},
            {"name", name},
            {"description", described.description},
            {"contentUrl", name},
            {"contentSize", format("{} B", std::filesystem::file_size(file))},
            {"encodingFormat", described.kind},
            {"sha256", described.hash}};
}

/// The file; of an index also the shards that it shows, which are hashed anew, and their manifest.
Json files_of(const Described& from) {
    const std::string version = "HDF5 1.10, format " + from.in.text("/", "format") + " version " +
                                from.in.attribute_text("/", "format_version");
    const bool is_index = is_shard_index(from.file);
    Json files = Json::array();
    files.push_back(file_object(
        from.file, {.description = version + (is_index ? "; shows the shards as one dataset" : ""),
                    .kind = "application/x-hdf5",
                    .hash = sha256_of_file(from.file)}));
    if (!is_index) return files;
    const std::filesystem::path folder = from.file.parent_path();
    const std::filesystem::path manifest = folder / "manifest.sha256";
    files.push_back(
        file_object(manifest, {.description = "SHA-256 of the shards, as sha256sum -c takes it",
                               .kind = "text/plain",
                               .hash = sha256_of_file(manifest)}));
    for (const auto& [shard, hash] : read_manifests(folder)) {
        if (sha256_of_file(folder / shard) != hash)
            throw InputError((folder / shard).string() +
                             ": is damaged, its SHA-256 is not the manifest's; remove it, and run "
                             "its generate command again");
        files.push_back(file_object(folder / shard, {.description = version + "; some sessions",
                                                     .kind = "application/x-hdf5",
                                                     .hash = hash}));
    }
    return files;
}

bool is_url(const std::string& text) {
    return text.rfind("http://", 0) == 0 || text.rfind("https://", 0) == 0;
}

Json license_of(const DocumentOptions& options) {
    if (is_url(options.license)) return options.license;
    return {{"@type", "sc:CreativeWork"},
            {"name", options.license.empty() ? "not chosen by the maker yet" : options.license}};
}

}  // namespace

std::string croissant_of(const std::filesystem::path& dataset, const DocumentOptions& options) {
    check_dataset(DatasetReader(dataset));
    return croissant_of_whole(dataset, options);
}

std::string documented_hash(const std::filesystem::path& dataset) {
    std::ifstream in(document_files(dataset, dataset.parent_path()).croissant);
    const Json document = Json::parse(in, nullptr, false);
    if (!document.is_object() || !document.contains("distribution")) return "";
    for (const Json& file : document["distribution"])
        if (file.is_object() && file.value("contentUrl", Json()) == dataset.filename().string() &&
            file.value("sha256", Json()).is_string())
            return file["sha256"];
    return "";
}

std::string croissant_mark(const std::filesystem::path& dataset) {
    return format("\"contentUrl\": {}", Json(dataset.filename().string()).dump());
}

std::string croissant_of_whole(const std::filesystem::path& dataset,
                               const DocumentOptions& options) {
    const DatasetReader reader(dataset);
    const Hdf5File in = Hdf5File::open(dataset);
    const Described from{dataset, in};
    const Origin& origin = reader.form().origin;
    const bool simulated = origin.source == "simulation";
    const Json description = {
        {"@context", context()},
        {"@type", "sc:Dataset"},
        {"name", dataset.stem().string()},
        {"description",
         format("{} frames of FMCW radar over material samples, condition \"{}\", radar {}, {} "
                "classes; {} with specula {}. {} says more.",
                reader.n_frames(), origin.condition, origin.radar, reader.form().class_names.size(),
                simulated ? "simulated" : origin.source, origin.version,
                document_files(dataset, "").datasheet.string())},
        {"conformsTo", conforms_to},
        {"license", license_of(options)},
        {"url", options.url.empty() ? "./" : options.url},
        {"creator",
         {{"@type", "sc:Organization"},
          {"name", options.creator.empty() ? "not told; written by specula " + origin.version
                                           : options.creator}}},
        {"datePublished", day_of(dataset)},
        {"version", "1.0.0"},
        {"keywords",
         {"FMCW radar", "millimetre wave", "material classification",
          simulated ? "simulation" : "recording"}},
        {"distribution", files_of(from)},
        {"recordSet", {frames_of(from), classes_of(reader.form().class_names)}}};
    return description.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace specula
