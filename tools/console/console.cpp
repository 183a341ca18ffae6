#include "tools/console/console.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace specula {

namespace {

spdlog::logger& console() {
    static const auto logger = [] {
        auto made = spdlog::stderr_color_mt("specula");
        made->set_pattern("specula: %^%l%$: %v");
        return made;
    }();
    return *logger;
}

}  // namespace

void say_warning(const std::string& text) { console().warn(text); }
void say_error(const std::string& text) { console().error(text); }

}  // namespace specula
