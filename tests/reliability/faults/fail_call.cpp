// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the program (LD_PRELOAD), it has one system call of the write phase fail, or kills the
// process there. The write phase begins when the folder of the new files is made, or with
// ASHIMPACT_FAULT_FROM=0 at once. ASHIMPACT_FAULT_CALL: which call, from 1 on; ASHIMPACT_FAULT_ERROR: the
// errno it fails with, or "kill". ASHIMPACT_FAULT_COUNT: a file that gets one letter for each call seen, so
// that a test knows how many there are and in which order: f for fsync of a file, F for
// fsync of a folder, R for rename; the letters of the others mean nothing.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE 1
#endif

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

bool in_write_phase = false;
long calls = 0;

template <class Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
    return std::getenv(name);
}

void count_call(char letter) {
    const char* file = setting("ASHIMPACT_FAULT_COUNT");
    if (file == nullptr) return;
    static auto* const open_file = real<int(const char*, int, ...)>("open");
    static auto* const write_file = real<ssize_t(int, const void*, size_t)>("write");
    const int stream = open_file(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (stream < 0) return;
    static_cast<void>(write_file(stream, &letter, 1));
    static auto* const close_file = real<int(int)>("close");
    close_file(stream);
}

/// Whether this call is the one that fails; errno is set then.
bool fails(char letter) {
    if (!in_write_phase) return false;
    const int before = errno;
    count_call(letter);
    errno = before;
    const char* which = setting("ASHIMPACT_FAULT_CALL");
    const char* error = setting("ASHIMPACT_FAULT_ERROR");
    if (which == nullptr || error == nullptr || ++calls != std::strtol(which, nullptr, 10)) return false;
    if (std::strcmp(error, "kill") == 0) {
        kill(getpid(), SIGKILL);
        for (;;) pause();
    }
    errno = static_cast<int>(std::strtol(error, nullptr, 10));
    return true;
}

}  // namespace

// The names of the C library's own functions, whose place these take; its headers' names of their parameters
// are reserved ones.
// NOLINTBEGIN(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
extern "C" {

int mkdir(const char* path, mode_t mode) {
    if (std::strstr(path, ".ashimpact-new") != nullptr) in_write_phase = true;
    if (fails('m')) return -1;
    return real<int(const char*, mode_t)>("mkdir")(path, mode);
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (fails('o')) return -1;
    return real<int(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (fails('o')) return -1;
    return real<int(const char*, int, ...)>("open64")(path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
    if (file > 2 && fails('w')) return -1;
    return real<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

int fsync(int file) {
    struct stat status {};
    const bool is_folder = fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
    if (fails(is_folder ? 'F' : 'f')) return -1;
    return real<int(int)>("fsync")(file);
}

int close(int file) {
    const bool failing = fails('c');
    const int error = errno;
    const int result = real<int(int)>("close")(file);
    if (!failing) return result;
    errno = error;
    return -1;
}

int rename(const char* from, const char* to) {
    if (fails('R')) return -1;
    return real<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) {
    if (fails('l')) return -1;
    return real<int(const char*, const char*)>("link")(from, to);
}

int unlink(const char* path) {
    if (fails('u')) return -1;
    return real<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) {
    if (fails('u')) return -1;
    return real<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int remove(const char* path) {
    if (fails('r')) return -1;
    return real<int(const char*)>("remove")(path);
}
}
// NOLINTEND(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
