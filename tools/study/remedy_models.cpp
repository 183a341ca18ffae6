#include "tools/study/remedy_models.hpp"

#include "classifier/descriptor.hpp"
#include "classifier/model_blob.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// The blob for a device, or why there is none.
void write_blob(const Model& model, const std::filesystem::path& folder, DeviceFiles& files) {
    try {
        const auto blob = model_blob(model, FW_ARITHMETIC_FLOAT);
        const std::string name = "firmware/remedy.rfwm";
        write_file_atomically(folder / name, std::string(blob.begin(), blob.end()));
        files.blob = name;
    } catch (const InputError& error) {  // the firmware cannot hold it
        files.why_no_blob = error.what();
    }
}

}  // namespace

std::optional<Remedy> train_remedy(const Ladder& ladder, const std::vector<RungPlan>& plans,
                                   const std::vector<LadderRung>& rungs) {
    for (std::size_t i = 0; i < rungs.size(); ++i)
        if (rungs[i].recommended)
            return Remedy{.plan = &plans[i], .models = ladder.models_of(plans[i])};
    return std::nullopt;
}

DeviceFiles write_remedy(const Remedy& remedy, const Radar& radar,
                         const std::filesystem::path& folder) {
    const Descriptor descriptor = parse_descriptor(remedy.plan->descriptor);
    const Measurement measurement = measurement_of(radar, descriptor.bins);
    DeviceFiles files;
    for (std::size_t world = 0; world < remedy.models.size(); ++world) {
        Model model = remedy.models[world];
        model.measurement = measurement;
        model.provenance.emplace_back("descriptor", descriptor.text());
        model.provenance.emplace_back("remedy", remedy.plan->title);
        const std::string name = format("models/remedy_world_{:03}.json", world);
        write_model(model, folder / name);
        if (world > 0) continue;
        files.model = name;
        write_blob(model, folder, files);
    }
    return files;
}

}  // namespace specula
