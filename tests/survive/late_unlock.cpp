// Preloaded into snell by tests/survive/fences.cpp: llvmpipe's threads are late to unlock the mutex of a fence that
// they signalled, and the main thread is late to wait for it. Whoever frees a fence by then is told of at the end.
#include <dlfcn.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "tests/std.h"

namespace {

std::atomic<int> signalled = 0, freed_locked = 0;

template <typename Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool rasterizes() {
    thread_local const bool result = [] {
        char name[17]{};
        prctl(PR_GET_NAME, name);
        return std::string_view(name).find("llvmpipe") != std::string_view::npos;
    }();
    return result;
}

// snell ends by quick_exit.
const int told = std::at_quick_exit(
    [] { dprintf(STDERR_FILENO, "signalled %d, freed while locked %d\n", signalled.load(), freed_locked.load()); });

}  // namespace

extern "C" {

int pthread_cond_broadcast(pthread_cond_t* condition) {
    static auto* const real = next<int(pthread_cond_t*)>("pthread_cond_broadcast");
    const int result = real(condition);
    if (rasterizes() && ++signalled % 16 == 0) usleep(3000);
    return result;
}

int pthread_cond_signal(pthread_cond_t* condition) {
    static auto* const real = next<int(pthread_cond_t*)>("pthread_cond_signal");
    const int result = real(condition);
    if (gettid() == getpid()) usleep(300);
    return result;
}

int pthread_mutex_destroy(pthread_mutex_t* mutex) {
    static auto* const real = next<int(pthread_mutex_t*)>("pthread_mutex_destroy");
    if (mutex->__data.__lock != 0) ++freed_locked;
    return real(mutex);
}
}
