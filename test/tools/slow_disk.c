// A disk that takes 100 ms for every write of more than a line to a file: preloaded into the recorder.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

ssize_t write(int fd, const void* bytes, size_t count) {
  static ssize_t (*real)(int, const void*, size_t);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "write");
  struct stat about;
  if (count > 256 && fstat(fd, &about) == 0 && S_ISREG(about.st_mode)) {
    const struct timespec pause = {0, 100000000};
    nanosleep(&pause, NULL);
  }
  return real(fd, bytes, count);
}
