#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "apps/frame/session/recent_files.h"
#include "apps/frame/session/recovery.h"
#include "femoop/io/model_file.h"
#include "tests/folder.h"

namespace fs = std::filesystem;

namespace {

/// Keeps a draft in another process, which is then killed.
void keep_and_be_killed(const fs::path& folder, const frame::Document& document)
{
    const pid_t child = fork();
    if (child == 0) {
        frame::Recovery recovery(folder);
        const bool is_kept = !recovery.keep(document, "/tmp/lesson.json");
        std::raise(is_kept ? SIGKILL : SIGTERM);
    }
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));
    REQUIRE(WTERMSIG(status) == SIGKILL);
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("Work that was kept survives a kill, and is the same bit for bit")
    {
        const Folder folder;
        frame::Document document = frame::starting_document();
        document.model.nodes[1].at[0] = 0.1 + 0.2;
        keep_and_be_killed(folder.path(), document);
        const frame::Recovery recovery(folder.path());
        const auto leftovers = recovery.leftovers();
        REQUIRE(leftovers.size() == 1);
        CHECK(leftovers[0].original == fs::path("/tmp/lesson.json"));
        CHECK(femoop::read_model_file(leftovers[0].draft) == document.model);
        frame::Recovery::discard(leftovers[0]);
        CHECK(recovery.leftovers().empty());
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("The draft of a program that runs is nobody else's leftover")
    {
        const Folder folder;
        frame::Recovery mine(folder.path()), other(folder.path());
        REQUIRE_FALSE(mine.keep(frame::starting_document(), std::nullopt));
        CHECK(other.leftovers().empty());
        REQUIRE_FALSE(other.keep(frame::starting_document(), std::nullopt));
        mine.forget();
        other.forget();
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("A folder that cannot be made is said")
    {
        frame::Recovery recovery("/dev/null/cremona");
        CHECK(recovery.keep(frame::starting_document(), std::nullopt));
        CHECK(recovery.leftovers().empty());
    }

    TEST_CASE("The file opened last is the first of the recent ones, each once, ten at most")
    {
        const Folder folder;
        const fs::path list = folder.path() / "state" / "recent";
        frame::RecentFiles recent(list);
        CHECK(recent.paths().empty());
        for (int i = 0; i < 14; ++i) recent.add("/tmp/" + std::to_string(i) + ".json");
        recent.add("/tmp/9.json");
        const frame::RecentFiles again(list);
        REQUIRE(again.paths().size() == 10);
        CHECK(again.paths()[0] == "/tmp/9.json");
        CHECK(again.paths()[1] == "/tmp/13.json");
        CHECK(again.paths() == recent.paths());
    }
}
