#include "femoop/solver/team.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace femoop {

class Team::Threads {
public:
    explicit Threads(int n_members)
    {
        try {
            for (int member = 1; member < n_members; ++member)
                threads_.emplace_back([this, member](const std::stop_token& stop) { stay(member, stop); });
        } catch (const std::system_error&) { // no more threads to be had
        }
    }
    ~Threads()
    {
        for (std::jthread& thread : threads_) thread.request_stop();
        ++call_;
        call_.notify_all();
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    int size() const { return static_cast<int>(threads_.size()) + 1; }

    void for_each(std::int32_t n, const Work& work)
    {
        work_ = &work;
        n_items_ = n;
        next_item_ = 0;
        if (n > 1 && !threads_.empty()) {
            is_open_ = true;
            ++call_;
            call_.notify_all();
        }
        take_items(0);
        is_open_ = false; // whoever comes now finds nothing to do; those who are at work are waited for
        for (std::int32_t busy = n_busy_; busy != 0; busy = n_busy_) n_busy_.wait(busy);
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

private:
    void stay(int member, const std::stop_token& stop)
    {
        constexpr int patience = 2000; // looks before it sleeps: the next call comes soon as a rule
        std::uint32_t heard = 0;
        while (!stop.stop_requested()) {
            for (int i = 0; i < patience && call_.load() == heard; ++i) std::this_thread::yield();
            call_.wait(heard);
            heard = call_.load();
            ++n_busy_;
            if (is_open_) take_items(member);
            if (--n_busy_ == 0) n_busy_.notify_all();
        }
    }

    void take_items(int member)
    {
        try {
            for (std::int32_t item = next_item_++; item < n_items_; item = next_item_++) (*work_)(item, member);
        } catch (...) {
            next_item_ = n_items_;
            const std::scoped_lock lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
        }
    }

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

int Team::natural_size() { return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U)); }
Team::Team(int n_members) : threads_(std::make_unique<Threads>(n_members)) {}
Team::~Team() = default;
int Team::size() const { return threads_->size(); }
void Team::for_each(std::int32_t n, const Work& work) { threads_->for_each(n, work); }

} // namespace femoop
