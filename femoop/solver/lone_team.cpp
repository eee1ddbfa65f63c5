// Team where there are no threads, as in a browser: the caller does everything.
#include "femoop/solver/team.h"

namespace femoop {

class Team::Threads {};

int Team::natural_size() { return 1; }
Team::Team(int /*n_members*/) {}
Team::~Team() = default;
int Team::size() const { return 1; }

void Team::for_each(std::int32_t n, const Work& work)
{
    for (std::int32_t item = 0; item < n; ++item) work(item, 0);
}

} // namespace femoop
