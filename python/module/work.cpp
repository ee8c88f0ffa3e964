#include "python/module/work.hpp"

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "host/error.hpp"

namespace pxm::python {

namespace py = pybind11;

namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);  // for signals and progress

std::atomic<int> under_way = 0;
std::atomic<bool> lost_threads = false;  // in a forked process

void after_fork_in_child() {
    if (under_way.exchange(0) != 0) lost_threads = true;
}

/// A thread at work, and how it ended.
class Watched {
  public:
    explicit Watched(const Work& work) : work_(work) {
        control_.stop = &stop_;
        control_.progress = [this](double share) { share_ = share; };
        thread_ = std::thread([this] { run(); });
    }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    ~Watched() {
        if (!thread_.joinable()) return;
        stop_ = true;
        join();
    }

    /// Waits a moment; true once it is done.
    [[nodiscard]] bool wait() {
        const py::gil_scoped_release others;
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, between_looks, [&] { return done_; });
    }
    void join() {
        const py::gil_scoped_release others;
        thread_.join();
    }
    [[nodiscard]] double share() const { return share_; }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    void run() noexcept {
        try {
            work_(control_);
        } catch (...) {
            failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        done_ = true;
        changed_.notify_all();
    }

    const Work& work_;
    host::RunControl control_;
    std::atomic<bool> stop_ = false;
    std::atomic<double> share_ = 0;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool done_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace

void mind_forks() { pthread_atfork(nullptr, nullptr, after_fork_in_child); }

AtWork::AtWork() {
    if (lost_threads) {
        throw host::Error(host::ErrorKind::failed,
                          "this process was forked while pxm was at work in another thread of the "
                          "first one, so that it cannot work here: fork before or after, or use "
                          "multiprocessing's \"spawn\"");
    }
    ++under_way;
}

AtWork::~AtWork() { --under_way; }

void watch(const py::object& progress, const Work& work) {
    const AtWork at_work;
    Watched watched(work);
    double told = -1;
    const auto tell = [&](double share) {
        if (progress.is_none() || share <= told) return;
        told = share;
        progress(share);
    };
    while (!watched.wait()) {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        tell(watched.share());
    }
    watched.join();
    watched.rethrow();
    tell(1);
}

}  // namespace pxm::python
