#include "femoop/solver/available_memory.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#elif defined(__EMSCRIPTEN__)
#include <emscripten/heap.h>
#endif

namespace femoop {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

std::string in_gigabytes(double bytes)
{
    std::ostringstream text;
    text.precision(3);
    text << 1e-9 * bytes << " GB";
    return text.str();
}

#ifdef __linux__

/// The number in a file that holds nothing else; "max" and no file are no limit.
double number_in(const char* path)
{
    double value = unlimited;
    std::ifstream file(path);
    return file >> value ? value : unlimited;
}

/// What the system says that it can give without swapping.
double free_of_system()
{
    std::ifstream file("/proc/meminfo");
    std::string name;
    for (double kilobytes = 0.0; file >> name >> kilobytes; file.ignore(100, '\n'))
        if (name == "MemAvailable:") return 1024.0 * kilobytes;
    return unlimited;
}

double free_of_group()
{
    const double limit = number_in("/sys/fs/cgroup/memory.max");
    return limit < unlimited ? limit - number_in("/sys/fs/cgroup/memory.current") : unlimited;
}

double free_of_process()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    const double taken = number_in("/proc/self/statm") * static_cast<double>(sysconf(_SC_PAGESIZE));
    return static_cast<double>(limit.rlim_cur) - taken;
}

#endif

} // namespace

double available_memory()
{
#ifdef __linux__
    return std::max(0.0, std::min({free_of_system(), free_of_group(), free_of_process()}));
#elif defined(__EMSCRIPTEN__)
    return static_cast<double>(emscripten_get_heap_max() - emscripten_get_heap_size());
#else
    return unlimited;
#endif
}

InsufficientMemory::InsufficientMemory(double needed_bytes, double available_bytes)
    : std::runtime_error("the factorization takes " + in_gigabytes(needed_bytes) + " of memory, of which " +
                         in_gigabytes(available_bytes) + " are free"),
      needed_(needed_bytes),
      available_(available_bytes)
{}

} // namespace femoop
