#pragma once

#include <doctest/doctest.h>

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/folder.h"
#include "ui/files/autosave.h"

/// What a killed program with this workspace leaves behind, as the same app opens it again. The file that was being
/// edited is "lesson" in the folder. \pre the workspace's document has changes
template <class Workspace>
Workspace recovered(const Workspace& workspace, const Folder& folder, const std::string& extension)
{
    const ui::DraftFolder drafts{folder.path() / "state", extension};
    const std::vector<ui::UnsavedDocument> unsaved = workspace.unsaved();
    REQUIRE(unsaved.size() == 1);
    ui::Draft draft(drafts);
    REQUIRE(!draft.keep(unsaved[0].copy(), folder.path() / ("lesson" + extension)));
    Workspace next{decltype(workspace.session){}};
    const std::filesystem::path path = drafts.path / (std::to_string(getpid()) + "-0" + extension);
    CHECK(next.can_recover());
    REQUIRE(next.recover({path, folder.path() / ("lesson" + extension)}));
    CHECK(next.session.is_dirty());
    CHECK(!next.can_recover()); // another one would take its place
    CHECK(next.session.file_name() == "lesson" + extension);
    CHECK(next.unsaved()[0].original == next.session.path());
    REQUIRE(next.session.save(*next.session.path()));
    CHECK(next.unsaved().empty());
    return next;
}
