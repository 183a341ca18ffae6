#include <cstdio>

#include "tools/dataset/dataset_path.hpp"
#include "tools/specula/dataset_commands.hpp"

namespace specula {

namespace {

void print_fields(const DatasetDiff& diff) {
    std::printf("%-28s %10s %12s %14s  %s\n", "table", "frames", "values", "largest", "unit");
    for (const FieldDifference& field : diff.fields)
        std::printf("%-28s %10zu %12zu %14.6g  %s\n", field.table.c_str(), field.n_frames,
                    field.n_values, field.largest, field.unit.c_str());
}

}  // namespace

int diff_command(const DiffArguments& arguments) {
    const DatasetDiff diff =
        diff_datasets(dataset_file(arguments.a), dataset_file(arguments.b), arguments.options);
    if (const FieldDifference* first = diff.first())
        std::printf("first difference: frame %zu, %s: %s against %s%s%s\n\n", first->first_frame,
                    first->first_place.c_str(), first->value_a.c_str(), first->value_b.c_str(),
                    first->unit.empty() ? "" : " ", first->unit.c_str());
    for (const std::string& head : diff.heads) std::printf("%s\n", head.c_str());
    if (!diff.heads.empty() && !diff.fields.empty()) std::printf("\n");
    if (!diff.fields.empty()) print_fields(diff);
    if (diff.n_tolerated > 0)
        std::printf("%s%zu values differ within the tolerance\n", diff.same() ? "" : "\n",
                    diff.n_tolerated);
    if (diff.same())
        std::printf("the same: %zu frames\n", diff.n_frames);
    else
        std::printf("\n%zu of %zu frames differ\n", diff.n_different_frames, diff.n_frames);
    return diff.same() ? 0 : 1;
}

}  // namespace specula
