#include "tools/generate/interruption.hpp"

#include <csignal>

namespace specula {

namespace {

volatile std::sig_atomic_t signal_that_came = 0;

extern "C" void specula_note_signal(int signal_number) {
    signal_that_came = signal_number;
}

constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

InterruptionWatch::InterruptionWatch() {
    signal_that_came = 0;
    struct sigaction action = {};
    action.sa_handler = specula_note_signal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    for (const int signal_number : watched) sigaction(signal_number, &action, nullptr);
}

InterruptionWatch::~InterruptionWatch() {
    for (const int signal_number : watched) std::signal(signal_number, SIG_DFL);
}

void InterruptionWatch::check() {
    if (const int signal_number = signal_that_came)
        throw Interrupted(
            signal_number,
            "stopped; what is finished is kept: run the same command again to resume");
}

}  // namespace specula
