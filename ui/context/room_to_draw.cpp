#include "ui/context/room_to_draw.h"

#include "ui/context/gl.h"

#include <cstddef>
#include <string>

#if __has_include(<sys/resource.h>)
#include <sys/mman.h>
#include <sys/resource.h>
#endif

namespace ui {

namespace {

#if __has_include(<sys/resource.h>)

bool can_reserve(std::size_t bytes)
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return true;
    void* const place = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (place == MAP_FAILED) return false;
    munmap(place, bytes);
    return true;
}

#else

bool can_reserve(std::size_t) { return true; }

#endif

} // namespace

void require_room_to_draw()
{
    constexpr std::size_t megabytes = 800;
    if (can_reserve(megabytes << 20U)) return;
    throw ContextError("there is not enough memory to draw: " + std::to_string(megabytes) +
                       " MB of addresses are wanted; raise the limit (ulimit -v)");
}

} // namespace ui
