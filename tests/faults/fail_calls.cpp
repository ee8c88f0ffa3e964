// Preloaded into the program (LD_PRELOAD), makes its n-th call of a kind fail, once:
//   FAIL_KIND   malloc, open, read, write, rename, fsync, close, mmap or thread
//   FAIL_NTH    which one, from 1; counted from the program's first timer on, with which main
//   begins FAIL_HOW    error (default), short (half of the bytes are read or written) or interrupt
//   (EINTR) FAIL_MARK   a file that is made when the call has failed
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

std::atomic<bool> started = false;
std::atomic<long> calls = 0;
long nth = 0;  // 0: nothing fails
char kind[16], how[16], mark[4096];

void copy(char* to, std::size_t room, const char* variable) {
    const char* text = std::getenv(variable);
    if (text != nullptr) std::strncpy(to, text, room - 1);
}

/// Whether this call is the one.
bool fails(const char* name) {
    if (!started || nth == 0 || std::strcmp(kind, name) != 0 || ++calls != nth) return false;
    const long file = syscall(SYS_openat, AT_FDCWD, mark, O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    if (file >= 0) syscall(SYS_close, file);
    return true;
}

bool is_how(const char* name) { return std::strcmp(how, name) == 0; }

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// A call that moves bytes: fails, or moves fewer. Of one byte there is no half.
template <class Call>
ssize_t moved(const char* name, std::size_t bytes, int error, const Call& call) {
    if (!fails(name)) return call(bytes);
    if (is_how("short")) return call((bytes + 1) / 2);
    errno = is_how("interrupt") ? EINTR : error;
    return -1;
}

mode_t mode_of(int flags, va_list rest) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
}

int opened(int folder, const char* path, int flags, mode_t mode) {
    if (fails("open")) {
        errno = is_how("interrupt") ? EINTR : EMFILE;
        return -1;
    }
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

int timer_create(clockid_t clock, sigevent* event, timer_t* timer) {
    copy(kind, sizeof kind, "FAIL_KIND");
    copy(how, sizeof how, "FAIL_HOW");
    copy(mark, sizeof mark, "FAIL_MARK");
    const char* number = std::getenv("FAIL_NTH");
    nth = number != nullptr ? std::atol(number) : 0;
    const int result =
        next<int(clockid_t, sigevent*, timer_t*)>("timer_create")(clock, event, timer);
    started = true;
    return result;
}

void* malloc(std::size_t bytes) {
    if (!fails("malloc")) return __libc_malloc(bytes);
    errno = ENOMEM;
    return nullptr;
}
void* calloc(std::size_t count, std::size_t bytes) {
    if (!fails("malloc")) return __libc_calloc(count, bytes);
    errno = ENOMEM;
    return nullptr;
}
void* realloc(void* old, std::size_t bytes) {
    if (!fails("malloc")) return __libc_realloc(old, bytes);
    errno = ENOMEM;
    return nullptr;
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    if (!fails("malloc")) return __libc_memalign(alignment, bytes);
    errno = ENOMEM;
    return nullptr;
}
int posix_memalign(void** result, std::size_t alignment, std::size_t bytes) {
    if (fails("malloc")) return ENOMEM;
    *result = __libc_memalign(alignment, bytes);
    return *result == nullptr ? ENOMEM : 0;
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return opened(folder, path, flags, mode);
}

ssize_t read(int file, void* bytes, std::size_t count) {
    return moved("read", count, EIO,
                 [&](std::size_t n) { return syscall(SYS_read, file, bytes, n); });
}
ssize_t pread(int file, void* bytes, std::size_t count, off_t at) {
    return moved("read", count, EIO,
                 [&](std::size_t n) { return syscall(SYS_pread64, file, bytes, n, at); });
}
ssize_t pread64(int file, void* bytes, std::size_t count, off_t at) {
    return pread(file, bytes, count, at);
}
ssize_t write(int file, const void* bytes, std::size_t count) {
    return moved("write", count, ENOSPC,
                 [&](std::size_t n) { return syscall(SYS_write, file, bytes, n); });
}
ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t at) {
    return moved("write", count, ENOSPC,
                 [&](std::size_t n) { return syscall(SYS_pwrite64, file, bytes, n, at); });
}
ssize_t pwrite64(int file, const void* bytes, std::size_t count, off_t at) {
    return pwrite(file, bytes, count, at);
}

int rename(const char* from, const char* to) {
    if (!fails("rename")) return static_cast<int>(syscall(SYS_rename, from, to));
    errno = EIO;
    return -1;
}
int fsync(int file) {
    if (!fails("fsync")) return static_cast<int>(syscall(SYS_fsync, file));
    errno = EIO;
    return -1;
}
/// The file is closed all the same, as Linux does.
int close(int file) {
    const bool failed = fails("close");
    const auto result = static_cast<int>(syscall(SYS_close, file));
    if (!failed) return result;
    errno = EIO;
    return -1;
}
void* mmap(void* place, std::size_t bytes, int protection, int flags, int file, off_t at) {
    if (fails("mmap")) {
        errno = ENOMEM;
        return MAP_FAILED;
    }
    return reinterpret_cast<void*>(syscall(SYS_mmap, place, bytes, protection, flags, file, at));
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* argument) {
    if (fails("thread")) return EAGAIN;
    return next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create")(
        thread, attributes, run, argument);
}

}  // extern "C"
