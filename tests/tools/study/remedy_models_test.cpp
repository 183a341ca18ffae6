#include "tools/study/remedy_models.hpp"

#include "classifier/model_blob.hpp"
#include "classifier/model_file.hpp"
#include "scenes/catalogue.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/classifier/whole_model.hpp"

namespace specula {
namespace {

TEST_CASE("the recommended remedy is kept as models that the chip takes", "[study]") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "models");
    RungPlan plan;
    plan.title = "Complex profile";
    plan.descriptor = "peak_shape 6 12 blackman align 11.5 range 11.5 search 4 20";
    Model bare = shape_model();  // as training leaves it
    bare.provenance.clear();
    bare.measurement.reset();
    const Radar radar = Catalogue::open(SPECULA_SOURCE_DIR).radar_called("iwrl6432boost");
    write_remedy({.plan = &plan, .models = {bare, bare}}, radar, folder.path());

    const Model kept = read_model(folder.path() / "models/remedy_world_001.json");
    CHECK(kept.output.weight == bare.output.weight);
    const auto blob = model_blob(kept, FW_ARITHMETIC_FLOAT);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    CHECK(opened.kind == FW_FEATURES_PEAK_SHAPE);
    CHECK(opened.chirp.n_samples == radar.chirp.n_samples);
    CHECK(std::filesystem::exists(folder.path() / "models/remedy_world_000.json"));
}

}  // namespace
}  // namespace specula
