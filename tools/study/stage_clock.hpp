#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace specula {

/// How long the stages of a study took. Times stand in a file of their own, since results must not
/// depend on them.
class StageClock {
  public:
    StageClock();

    /// The stage that began when the one before ended.
    void ended(const std::string& stage);
    /// Header and one row per stage: stage, wall and processor seconds (of all threads).
    std::string csv() const;

  private:
    struct Stage {
        std::string name;
        double wall_s, cpu_s;
    };
    std::chrono::steady_clock::time_point wall_;
    double cpu_s_;
    std::vector<Stage> stages_;
};

}  // namespace specula
