/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What Debian's libstdc++ and libfmt take of glibc and an older one lacks. Where glibc has them, its own come first. */
#define _GNU_SOURCE
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

char __libc_single_threaded = 0;

int older_stat(const char* path, struct stat* result) __asm__("stat");
int older_lstat(const char* path, struct stat* result) __asm__("lstat");
int older_fstat(int file, struct stat* result) __asm__("fstat");
int older_fstat64(int file, struct stat* result) __asm__("fstat64");
int older_stat(const char* path, struct stat* result) { return (int)syscall(SYS_stat, path, result); }
int older_lstat(const char* path, struct stat* result) { return (int)syscall(SYS_lstat, path, result); }
int older_fstat(int file, struct stat* result) { return (int)syscall(SYS_fstat, file, result); }
int older_fstat64(int file, struct stat* result) { return (int)syscall(SYS_fstat, file, result); }

int getentropy(void* bytes, size_t count) { return syscall(SYS_getrandom, bytes, count, 0) == (long)count ? 0 : -1; }

unsigned arc4random(void) {
    unsigned number = 0;
    getentropy(&number, sizeof number);
    return number;
}
