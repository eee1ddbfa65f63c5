#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "apps/frame/session/commands.h"
#include "apps/frame/session/recovery.h"

namespace frame {

/// Keeps drafts of all documents of a desk that are not saved, a few seconds after each change, and finds those that a
/// program left behind when it was killed.
class Autosave {
public:
    static constexpr double interval = 2.0; ///< [s]

    explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Call once a frame: keeps what has changed since it was kept last, forgets what is saved or closed.
    void tick(const Desk& desk, double seconds);
    /// Everything is saved or given up.
    void forget_all();

    /// What a program left behind and was not told before. A program that is being killed may hold its draft for a
    /// moment still, so one asks again.
    std::vector<Leftover> new_leftovers();

private:
    struct Draft {
        std::unique_ptr<Recovery> recovery;
        std::uint64_t generation = 0; ///< of the session when it was kept
    };
    void keep(const Session& session);

    std::filesystem::path folder_;
    std::map<std::uint64_t, Draft> drafts_; ///< by the session's number
    double waited_ = 0.0;                   ///< [s]
    std::set<std::filesystem::path> told_;  ///< leftovers
};

/// Opens a draft in a tab of its own, as a document that is not saved, and deletes the draft; false, with a notice, if
/// it cannot be read.
bool open_leftover(Desk& desk, const Leftover& leftover);

} // namespace frame
