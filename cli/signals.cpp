// A thread waits for signals, so that no handler runs in the middle of anything.
#include "cli/signals.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <thread>

namespace quartic::cli {
namespace {

constexpr time_t grace_s = 2;

std::atomic<int> signal_seen{0};

ExitCode code_of(int signal) {
    return signal == SIGALRM ? exit_time_limit : exit_signal + signal;
}

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGALRM);
    return set;
}

void wait_for_signals() {
    const sigset_t set = watched_signals();
    int signal = 0;
    if (::sigwait(&set, &signal) != 0) {
        return;
    }
    signal_seen = signal;
    const timespec grace{grace_s, 0};
    ::sigtimedwait(&set, nullptr, &grace);
    ::_exit(code_of(signal));
}

}  // namespace

void watch_signals() {
    ::signal(SIGPIPE, SIG_IGN);
    const sigset_t set = watched_signals();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    std::thread(wait_for_signals).detach();
}

void set_time_limit(int seconds) {
    if (seconds > 0) {
        ::alarm(static_cast<unsigned>(seconds));
    }
}

bool is_interrupted() {
    return signal_seen != 0;
}

ExitCode final_code(ExitCode code) {
    const int signal = signal_seen;
    return signal == 0 ? code : code_of(signal);
}

}  // namespace quartic::cli
