// A machine that gives no more threads.
#pragma once

#include <pthread.h>

#include <cstddef>

namespace snell {

// While it lives no thread can be started: none has room for its stack.
class NoMoreThreads {
public:
    NoMoreThreads() {
        pthread_attr_t wide;
        pthread_attr_init(&wide);
        pthread_getattr_default_np(&before_);
        pthread_attr_setstacksize(&wide, std::size_t{1} << 47);
        pthread_setattr_default_np(&wide);
        pthread_attr_destroy(&wide);
    }
    ~NoMoreThreads() {
        pthread_setattr_default_np(&before_);
        pthread_attr_destroy(&before_);
    }
    NoMoreThreads(const NoMoreThreads&) = delete;
    NoMoreThreads& operator=(const NoMoreThreads&) = delete;

private:
    pthread_attr_t before_{};
};

}  // namespace snell
