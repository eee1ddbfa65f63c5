#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace femoop {

/// Threads that work through numbered items together. Which of them does an item is left to chance; whatever an item
/// computes must not depend on it. Where the library is built without threads (CREMONA_THREADS, lone_team.cpp) the
/// caller is the whole team.
class Team {
public:
    /// As many members as the machine has processors, at most 8.
    static int natural_size();

    /// Fewer members where the system gives no more threads; the caller is one of them.
    explicit Team(int n_members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int size() const;

    /// What is done to an item, by a member 0 .. size() - 1; the caller is member 0.
    using Work = std::function<void(std::int32_t item, int member)>;

    /// Does the items 0 .. n - 1, lower ones first, and returns when all are done. The first exception comes out here;
    /// then items are left.
    void for_each(std::int32_t n, const Work& work);

private:
    class Threads;
    std::unique_ptr<Threads> threads_;
};

} // namespace femoop
