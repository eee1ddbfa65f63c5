#pragma once

#include <string>
#include <vector>

#include "apps/frame/session/commands.h"

namespace frame {

/// The window with the kept views: shows one, renames, orders and deletes them.
class ViewList {
public:
    void toggle() { is_open_ = !is_open_; }
    /// \returns whether it was open
    bool close();
    void show(Workspace& workspace);

private:
    void show_row(Workspace& workspace, std::size_t place);

    bool is_open_ = false;
    std::vector<std::string> names_; ///< as they are typed
    std::optional<ui::Message> reason_;
};

} // namespace frame
