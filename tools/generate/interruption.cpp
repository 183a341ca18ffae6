#include "tools/generate/interruption.hpp"

#include <csignal>
#include <utility>

namespace specula {

namespace {

volatile std::sig_atomic_t signal_that_came = 0;
std::string message_of_watch;

extern "C" void specula_note_signal(int signal_number) {
    signal_that_came = signal_number;
}

constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

InterruptionWatch::InterruptionWatch(std::string message) {
    signal_that_came = 0;
    message_of_watch = std::move(message);
    struct sigaction action = {};
    action.sa_handler = specula_note_signal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    for (const int signal_number : watched) sigaction(signal_number, &action, nullptr);
}

InterruptionWatch::~InterruptionWatch() {
    for (const int signal_number : watched) std::signal(signal_number, SIG_DFL);
    signal_that_came = 0;
}

void InterruptionWatch::check() {
    if (const int signal_number = signal_that_came)
        throw Interrupted(signal_number, message_of_watch);
}

}  // namespace specula
