#include "tools/study/stage_clock.hpp"

#include <ctime>

#include "sim/core/format.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {

namespace {

double processor_s() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace

StageClock::StageClock() : wall_(std::chrono::steady_clock::now()), cpu_s_(processor_s()) {}

void StageClock::ended(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const double cpu_s = processor_s();
    stages_.push_back({stage, std::chrono::duration<double>(now - wall_).count(), cpu_s - cpu_s_});
    wall_ = now;
    cpu_s_ = cpu_s;
}

std::string StageClock::csv() const {
    CsvTable table({"stage", "wall_s", "cpu_s"});
    for (const Stage& stage : stages_)
        table.add({stage.name, format("{:.2f}", stage.wall_s), format("{:.2f}", stage.cpu_s)});
    return table.text();
}

}  // namespace specula
