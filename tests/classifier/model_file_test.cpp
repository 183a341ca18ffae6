#include "classifier/model_file.hpp"

#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

Model example() {
    Model model = random_model({3, 4, 2});
    model.class_names = {"iron \"raw\"", "Gl\xc3\xa4ser"};
    model.provenance = {{"dataset", "run/1"}, {"a key", "\\ and\nnewline"}};
    model.output.bias = {-0.0f, std::numeric_limits<float>::denorm_min()};
    model.hidden[0].beta = {std::numeric_limits<float>::max(), 0.1f, 1.0f / 3.0f, 1e-38f};
    return model;
}

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// What reading says about the example's file after one replacement in its text.
std::string problem_with(const std::string& from, const std::string& to) {
    const TemporaryFolder folder;
    write_model(example(), folder / "m.json");
    std::string text = text_of(folder / "m.json");
    const auto place = text.find(from);
    REQUIRE(place != std::string::npos);
    text.replace(place, from.size(), to);
    std::ofstream(folder / "m.json") << text;
    try {
        read_model(folder / "m.json");
    } catch (const InputError& error) {
        const std::string message = error.what();
        const std::string prefix = (folder / "m.json").string() + ": ";
        REQUIRE(message.rfind(prefix, 0) == 0);
        return message.substr(prefix.size());
    }
    return "accepted";
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST_CASE("a model comes back from its file bit for bit", "[model file]") {
    const TemporaryFolder folder;
    const Model model = example();
    write_model(model, folder / "m.json");
    const Model read = read_model(folder / "m.json");
    CHECK(read.extractor == model.extractor);
    CHECK(read.class_names == model.class_names);
    CHECK(read.provenance == model.provenance);
    CHECK(same_bits(read.input_mean, model.input_mean));
    CHECK(same_bits(read.input_scale, model.input_scale));
    REQUIRE(read.hidden.size() == 1);
    CHECK((read.hidden[0].n_in == 3 && read.hidden[0].n_out == 4));
    CHECK(same_bits(read.hidden[0].weight, model.hidden[0].weight));
    CHECK(same_bits(read.hidden[0].gamma, model.hidden[0].gamma));
    CHECK(same_bits(read.hidden[0].beta, model.hidden[0].beta));
    CHECK(same_bits(read.hidden[0].mean, model.hidden[0].mean));
    CHECK(same_bits(read.hidden[0].variance, model.hidden[0].variance));
    CHECK((read.output.n_in == 4 && read.output.n_out == 2));
    CHECK(same_bits(read.output.weight, model.output.weight));
    CHECK(same_bits(read.output.bias, model.output.bias));
}

TEST_CASE("names of features and prototypes come back, and are refused where they do not fit",
          "[model file]") {
    const TemporaryFolder folder;
    Model model = example();
    model.feature_names = {"x", "y", "level \"a\""};
    model.prototypes = InputPrototypes{.mean = {1.0f, -2.0f, 0.1f},
                                       .scale = {0.0f, 3.0f, 1.0f / 3.0f},
                                       .centre = {1, 2, 3, 4, 5, 6}};
    write_model(model, folder / "m.json");
    const Model read = read_model(folder / "m.json");
    CHECK(read.feature_names == model.feature_names);
    REQUIRE(read.prototypes);
    CHECK(same_bits(read.prototypes->mean, model.prototypes->mean));
    CHECK(same_bits(read.prototypes->scale, model.prototypes->scale));
    CHECK(same_bits(read.prototypes->centre, model.prototypes->centre));
    model.feature_names.pop_back();
    write_model(model, folder / "m.json");
    CHECK(message_of([&] { read_model(folder / "m.json"); })
              .ends_with("has the wrong length; one per feature: 3"));
}

TEST_CASE("a dataset in the place of a model is called one", "[model file]") {
    const TemporaryFolder folder;
    std::ofstream(folder / "m.json", std::ios::binary) << "\x89HDF\r\n\x1a\nand so on";
    CHECK(message_of([&] { read_model(folder / "m.json"); })
              .ends_with("is a dataset (HDF5), not a model; a model (.json) belongs here"));
    std::ofstream(folder / "m.json", std::ios::binary) << "{\n\"format\": \n]";
    CHECK(message_of([&] { read_model(folder / "m.json"); })
              .ends_with("is not valid JSON in line 3; name a model that train or study wrote"));
}

TEST_CASE("a model without hidden layers comes back too", "[model file]") {
    const TemporaryFolder folder;
    write_model(random_model({3, 2}), folder / "m.json");
    const Model read = read_model(folder / "m.json");
    CHECK(read.hidden.empty());
    CHECK(read.output.n_in == 3);
}

TEST_CASE("a model file has one row of weights per line and short numbers", "[model file]") {
    const TemporaryFolder folder;
    Model model = example();
    model.hidden[0].weight = {0.1f, 0.2f, 0.3f, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    write_model(model, folder / "m.json");
    CHECK(text_of(folder / "m.json").find("\n        [0.1,0.2,0.3],\n") != std::string::npos);
}

TEST_CASE("what is wrong in a model file is named by field", "[model file]") {
    CHECK(problem_with("specula model", "other") ==
          "format = \"other\": is another kind of file; name a model file");
    CHECK(problem_with("\"version\": 1", "\"version\": 3") ==
          "version = 3: is not a version this program reads; use a model of version 2 or before");
    CHECK(problem_with("\"extractor\": \"random\"", "\"extractor\": 3") ==
          "extractor = 3: is not text; put it in quotes");
    CHECK(problem_with("\"extractor\"", "\"extractr\"") ==
          "whole file = {...}: has no \"extractor\"; train or export the model again");
    CHECK(problem_with("Gl\xc3\xa4ser", "iron \\\"raw\\\"") ==
          "class_names = [2 values]: names a class twice; give each its own name");
    CHECK(problem_with("3.4028235e+38", "\"x\"") ==
          "hidden[0].beta[0] = \"x\": is not a number; write a finite number");
    CHECK(problem_with("3.4028235e+38,", "") ==
          "hidden[0].beta = [3 values]: has the wrong length; 4 numbers belong here");
    CHECK(problem_with("\"variance\": [", "\"variance\": [-1, ") ==
          "hidden[0].variance = [5 values]: has the wrong length; 4 numbers belong here");
    CHECK(problem_with("\"input_mean\": [", "\"input_mean\": [1, ") ==
          "input_scale = [3 values]: has the wrong length; 4 numbers belong here");
    CHECK(problem_with("\"hidden\": [", "\"hidden\": [1, 2, 3, ") ==
          "hidden = [4 values]: has too many layers; the firmware runs at most 3");
    CHECK(problem_with("\"hidden\": [", "\"hidden\": [1, ") ==
          "hidden[0] = 1: is not an object; write { ... }");
    CHECK(problem_with("\"input_scale\": [", "\"input_scale\": [-1, 1, 1], \"other\": [") ==
          "input_scale[0] = -1: is out of range; use 0 or more");
}

TEST_CASE("text that is not JSON, or numbers beyond float, are refused", "[model file]") {
    CHECK(problem_with("{", "(").rfind("is not valid JSON", 0) == 0);
    CHECK(problem_with("3.4028235e+38", "1e39").rfind("is not valid JSON", 0) == 0);
    CHECK(problem_with("3.4028235e+38", "NaN").rfind("is not valid JSON", 0) == 0);
}

TEST_CASE("only a regular file of modest size is read", "[model file]") {
    const TemporaryFolder folder;
    const auto problem = [&](const std::filesystem::path& file) {
        try {
            read_model(file);
        } catch (const InputError& error) {
            return std::string(error.what()).substr(file.string().size());
        }
        return std::string("accepted");
    };
    CHECK(problem(folder / "none.json") == ": no such file; check the path");
    CHECK(problem(folder.path()) == ": is not a regular file; name a model file");
    CHECK(problem("/dev/zero") == ": is not a regular file; name a model file");
    std::ofstream(folder / "large.json") << "{}";
    std::filesystem::resize_file(folder / "large.json", (16u << 20) + 1);
    CHECK(problem(folder / "large.json") == ": is larger than 16 MiB; name a model file");
}

}  // namespace
}  // namespace specula
