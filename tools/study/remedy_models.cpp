#include "tools/study/remedy_models.hpp"

#include "classifier/descriptor.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::optional<Remedy> train_remedy(const Ladder& ladder, const std::vector<RungPlan>& plans,
                                   const std::vector<LadderRung>& rungs) {
    for (std::size_t i = 1; i < rungs.size(); ++i)
        if (rungs[i].recommended)
            return Remedy{.plan = &plans[i], .models = ladder.models_of(plans[i])};
    return std::nullopt;
}

void write_remedy(const Remedy& remedy, const Radar& radar, const std::filesystem::path& folder) {
    const Descriptor descriptor = parse_descriptor(remedy.plan->descriptor);
    const Measurement measurement = measurement_of(radar, descriptor.bins);
    for (std::size_t world = 0; world < remedy.models.size(); ++world) {
        Model model = remedy.models[world];
        model.measurement = measurement;
        model.provenance.emplace_back("descriptor", descriptor.text());
        model.provenance.emplace_back("remedy", remedy.plan->title);
        write_model(model, folder / "models" / format("remedy_world_{:03}.json", world));
    }
}

}  // namespace specula
