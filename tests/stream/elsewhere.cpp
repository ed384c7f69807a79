// Compiles only where nothing of Linux is called without a guard: what Linux alone has is taken away first.

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stream/bytes/file.hpp>

#undef __linux__
#undef F_SETPIPE_SZ
#undef CPU_ZERO
#undef CPU_COUNT
#pragma GCC poison cpu_set_t sched_getaffinity pipe2 splice vmsplice tee

#include <stream/bytes/file.cpp> // NOLINT(bugprone-suspicious-include)
