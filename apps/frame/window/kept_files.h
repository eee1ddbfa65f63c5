#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/frame/session/autosave.h"
#include "apps/frame/session/recent_files.h"

namespace frame {

/// What the app remembers from one time to the next: the files that were opened last, and drafts of what is not saved.
class KeptFiles {
public:
    /// \param folder where it is kept; without one nothing is
    explicit KeptFiles(const std::optional<std::filesystem::path>& folder);

    /// Call once a frame.
    void tick(const Desk& desk, double seconds);
    /// The program ends in good order, so no draft is needed.
    void end();

    void ask_for_recent() { asks_for_recent_ = true; }
    bool is_open() const { return asks_for_recent_ || !leftovers_.empty(); }
    /// Shows the list of the last files, or what a program left behind when it was killed.
    void show(Desk& desk);

private:
    void look_for_leftovers(double seconds);
    void show_recent(Desk& desk);
    void show_leftovers(Desk& desk);

    std::optional<Autosave> autosave_;
    std::optional<RecentFiles> recent_;
    std::vector<Leftover> leftovers_;
    double age_ = 0.0;            ///< of the program [s]
    double looked_at_ = 0.0;      ///< when leftovers were looked for last
    std::filesystem::path noted_; ///< the last file that was put on the list
    bool asks_for_recent_ = false;
};

} // namespace frame
