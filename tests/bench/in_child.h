#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <type_traits>

namespace bench {

/// Runs `work` in a process of its own, so that its peak memory is its own, and hands back what it returns.
template <class Result, class Work> Result in_child(Work&& work)
{
    static_assert(std::is_trivially_copyable_v<Result>);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("in_child: no pipe");
    const pid_t child = fork();
    if (child == 0) {
        const Result result = work();
        const bool is_sent = write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
        _exit(is_sent ? 0 : 1);
    }
    close(ends[1]);
    Result result{};
    const bool has_come = read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (!has_come) throw std::runtime_error("in_child: the child process failed");
    return result;
}

} // namespace bench
