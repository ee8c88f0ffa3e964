// Work that takes a while, on a thread of its own: the thread that asked for it waits without
// holding up Python, tells progress, and looks for Ctrl-C.
// A thread of its own also means an OpenMP team of its own, which ends with it: when no work is
// under way there are no threads that a forked process would wait for in vain.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "host/engine/engine.hpp"

namespace pxm::python {

/// To be called once, when the module is loaded: a process that is forked while work is under way
/// must not work, for the locks that its threads held are never given back.
void mind_forks();

/// Counts what is under way for as long as it lives. Throws host::Error in a process that was
/// forked from one that was at work.
class AtWork {
  public:
    AtWork();
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
    ~AtWork();
};

using Work = std::function<void(const host::RunControl&)>;

/// Runs it and waits for its end. `progress` is None or is called, by the thread that waits, with
/// the share that is done. What the work, the progress or a signal's handler throws is thrown; then
/// the work was stopped first. Precondition: the caller holds the GIL.
void watch(const pybind11::object& progress, const Work& work);

}  // namespace pxm::python
