#include "host/process/stack.hpp"

#include <pthread.h>
#include <sys/resource.h>

#include <cstddef>

namespace pxm::host {

namespace {

constexpr std::size_t enough_bytes = std::size_t{8} << 20;

/// Of threads that do not say how much they want, as OpenMP's. An unlimited stack of the shell is
/// one of 2 MB for them.
void give_to_later_threads() {
    pthread_attr_t attributes;
    std::size_t bytes = 0;
    if (pthread_getattr_default_np(&attributes) != 0) return;
    if (pthread_attr_getstacksize(&attributes, &bytes) == 0 && bytes < enough_bytes &&
        pthread_attr_setstacksize(&attributes, enough_bytes) == 0) {
        pthread_setattr_default_np(&attributes);
    }
    pthread_attr_destroy(&attributes);
}

/// The first thread's stack grows up to the limit of the moment.
bool is_enough_here() {
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= enough_bytes) return true;
    if (limit.rlim_max < enough_bytes) return false;
    limit.rlim_cur = enough_bytes;
    return setrlimit(RLIMIT_STACK, &limit) == 0;
}

struct Call {
    const std::function<int()>& work;
    int result;
};

void* run(void* data) {
    Call& call = *static_cast<Call*>(data);
    call.result = call.work();
    return nullptr;
}

}  // namespace

int with_enough_stack(const std::function<int()>& work) {
    give_to_later_threads();
    pthread_t thread;
    Call call{work, 0};
    if (is_enough_here() || pthread_create(&thread, nullptr, run, &call) != 0) return work();
    pthread_join(thread, nullptr);
    return call.result;
}

}  // namespace pxm::host
