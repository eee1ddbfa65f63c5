#include <doctest/doctest.h>

#include "apps/mohr/session/commands.h"
#include "tests/apps/recovered.h"

using namespace mohr;

TEST_CASE("A state that a crash has cost opens as it was typed, as one that is not saved")
{
    const Folder folder;
    Workspace workspace{Session()};
    CHECK(workspace.unsaved().empty());
    workspace.session.set_number({Group::State, 2}, "33,3 MPa");
    CHECK(recovered(workspace, folder, ".mohr").session.document() == workspace.session.document());
}
