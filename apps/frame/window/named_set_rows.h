#pragma once

#include <optional>
#include <span>
#include <string>

#include "apps/frame/session/commands.h"
#include "apps/frame/session/set_commands.h"

namespace frame {

/// For nodes and loads: the name that their support or load has, and the ways to give, keep and replace one; for nodes
/// and members also which named loads they can be given. \pre all parts are of one kind
void named_set_rows(Session& session, std::span<const Part> parts);

/// The lists of supports and loads under names: choosing one shows its name, which can be typed anew, and what can be
/// done with it.
class NamedSetLists {
public:
    void show(Workspace& workspace);

private:
    void show_list(Workspace& workspace, std::string_view heading, bool of_supports);
    void show_chosen(Workspace& workspace);

    std::optional<NamedSetPlace> chosen_;
    std::string name_; ///< as it is typed
    std::optional<ui::Message> reason_;
};

} // namespace frame
