#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace femoop {

/// Threads that work through numbered items together. Which of them does an item is left to chance; whatever an item
/// computes must not depend on it.
class Team {
public:
    /// As many members as the machine has processors, at most 8.
    static int natural_size();

    /// Fewer members where the system gives no more threads; the caller is one of them.
    explicit Team(int n_members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int size() const { return static_cast<int>(threads_.size()) + 1; }

    /// What is done to an item, by a member 0 .. size() - 1.
    using Work = std::function<void(std::int32_t item, int member)>;

    /// Does the items 0 .. n - 1, lower ones first, and returns when all are done. The first exception comes out here;
    /// then items are left.
    void for_each(std::int32_t n, const Work& work);

private:
    void stay(int member, const std::stop_token& stop);
    void take_items(int member);

    const Work* work_ = nullptr;
    std::int32_t n_items_ = 0;
    std::atomic<std::int32_t> next_item_ = 0;
    std::atomic<bool> is_open_ = false;   ///< items may be taken
    std::atomic<std::uint32_t> call_ = 0; ///< counts the calls to come
    std::atomic<std::int32_t> n_busy_ = 0;
    std::mutex mutex_;
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_;
};

} // namespace femoop
