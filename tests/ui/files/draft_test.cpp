#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <optional>
#include <string>

#include "femoop/files/whole_file.h"
#include "tests/folder.h"
#include "tests/text_of.h"
#include "tests/ui/files/drafts_in.h"
#include "ui/files/draft.h"
#include "ui/files/recent_files.h"

namespace fs = std::filesystem;

namespace {

ui::WriteDocument document(const std::string& text)
{
    return [text](const fs::path& draft) { return files::write_whole_file(draft, text); };
}

/// Keeps a draft in another process, which is then killed.
void keep_and_be_killed(const fs::path& folder, const std::string& text)
{
    const pid_t child = fork();
    if (child == 0) {
        ui::Draft draft(drafts_in(folder));
        const bool is_kept = !draft.keep(document(text), "/tmp/lesson.txt");
        std::raise(is_kept ? SIGKILL : SIGTERM);
    }
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));
    REQUIRE(WTERMSIG(status) == SIGKILL);
}

} // namespace

TEST_SUITE("ui files")
{
    TEST_CASE("Work that was kept survives a kill")
    {
        const Folder folder;
        keep_and_be_killed(folder.path(), "seven steps");
        const auto found = ui::recoverable_files(drafts_in(folder.path()));
        REQUIRE(found.size() == 1);
        CHECK(found[0].original == fs::path("/tmp/lesson.txt"));
        CHECK(text_of(found[0].draft) == "seven steps");
        ui::Draft::taken_over(drafts_in(folder.path()), found[0])->forget();
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("Drafts without a name are told apart by when they were kept and what they hold")
    {
        const Folder folder;
        {
            ui::Draft draft(drafts_in(folder.path()));
            REQUIRE_FALSE(draft.keep(document("a bridge"), std::nullopt, {"7 nodes", "7 nós"}));
        }
        const auto found = ui::recoverable_files(drafts_in(folder.path()));
        REQUIRE(found.size() == 1);
        CHECK(found[0].about == std::vector<std::string>{"7 nodes", "7 nós"});
        const std::string time = ui::time_of(found[0]);
        REQUIRE(time.size() == std::string("2026-11-23 14:05").size());
        CHECK(time[4] == '-');
        CHECK(time[13] == ':');
    }

    TEST_CASE("What was half written when the program was killed goes with its draft")
    {
        const Folder folder;
        keep_and_be_killed(folder.path(), "seven steps");
        const auto found = ui::recoverable_files(drafts_in(folder.path()));
        REQUIRE(found.size() == 1);
        std::ofstream(folder.path() / ("." + found[0].draft.filename().string() + ".aBcDeF")) << "seven st";
        CHECK(ui::recoverable_files(drafts_in(folder.path())).size() == 1);
        ui::Draft::taken_over(drafts_in(folder.path()), found[0])->forget();
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("The draft of a program that runs is nobody else's leftover")
    {
        const Folder folder;
        const ui::DraftFolder in = drafts_in(folder.path());
        ui::Draft mine(in), other(in);
        REQUIRE_FALSE(mine.keep(document("mine"), std::nullopt));
        CHECK(ui::recoverable_files(in).empty());
        REQUIRE_FALSE(other.keep(document("other"), std::nullopt));
        mine.forget();
        other.forget();
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("Of two programs that are offered a leftover one can take it over and the other cannot")
    {
        const Folder folder;
        const ui::DraftFolder in = drafts_in(folder.path());
        keep_and_be_killed(folder.path(), "seven steps");
        const auto found = ui::recoverable_files(in);
        REQUIRE(found.size() == 1);
        auto mine = ui::Draft::taken_over(in, found[0]);
        REQUIRE(mine);
        CHECK(!ui::Draft::taken_over(in, found[0]));
        REQUIRE_FALSE(mine->keep(document("eight steps"), std::nullopt));
        CHECK(text_of(found[0].draft) == "eight steps");
        mine.reset(); // killed again
        REQUIRE(ui::recoverable_files(in).size() == 1);
        CHECK(!ui::recoverable_files(in)[0].original);
        ui::Draft::taken_over(in, found[0])->forget();
        CHECK(!ui::Draft::taken_over(in, found[0])); // there is nothing any more
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("A folder that cannot be made is said")
    {
        ui::Draft draft(drafts_in("/dev/null/cremona"));
        CHECK(draft.keep(document("mine"), std::nullopt));
        CHECK(ui::recoverable_files(drafts_in("/dev/null/cremona")).empty());
    }

    TEST_CASE("The file opened last is the first of the recent ones, each once, ten at most")
    {
        const Folder folder;
        const fs::path list = folder.path() / "state" / "recent";
        ui::RecentFiles recent(list);
        CHECK(recent.paths().empty());
        for (int i = 0; i < 14; ++i) recent.add("/tmp/" + std::to_string(i) + ".json");
        recent.add("/tmp/9.json");
        const ui::RecentFiles again(list);
        REQUIRE(again.paths().size() == 10);
        CHECK(again.paths()[0] == "/tmp/9.json");
        CHECK(again.paths()[1] == "/tmp/13.json");
        CHECK(again.paths() == recent.paths());
    }

    TEST_CASE("Two programs share one list of recent files")
    {
        const Folder folder;
        const fs::path list = folder.path() / "recent";
        ui::RecentFiles one(list), other(list);
        one.add("/tmp/1.json");
        other.add("/tmp/2.json");
        one.add("/tmp/3.json");
        CHECK(one.paths() == std::vector<fs::path>{"/tmp/3.json", "/tmp/2.json", "/tmp/1.json"});
    }
}
