#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/folder.h"
#include "tests/ui/files/drafts_in.h"
#include "ui/files/autosave.h"

namespace fs = std::filesystem;

namespace {

ui::UnsavedDocument text(const std::string& words) { return ui::unsaved_text(words, std::nullopt); }

/// A program that keeps drafts.
struct Program {
    explicit Program(const fs::path& folder) : autosave(drafts_in(folder)) {}
    /// \returns whether something was told
    bool keeps(const std::vector<ui::UnsavedDocument>& documents)
    {
        const auto unsaved = [&] { return documents; };
        const auto first = autosave.tick(unsaved, ui::Autosave::interval);
        autosave.wait();
        const auto second = autosave.tick(unsaved, 0.0);
        return first || second;
    }
    ui::Autosave autosave;
};

/// The texts of the drafts in a folder.
std::vector<std::string> drafts(const fs::path& folder)
{
    std::vector<std::string> texts;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".txt") continue;
        std::ifstream file(entry.path());
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

using Texts = std::vector<std::string>;

} // namespace

TEST_SUITE("ui files")
{
    TEST_CASE("A draft follows the document, and goes when that is saved")
    {
        const Folder folder;
        Program program(folder.path());
        CHECK(!program.keeps({}));
        CHECK(fs::is_empty(folder.path()));
        program.keeps({text("one")});
        CHECK(drafts(folder.path()) == Texts{"one"});
        program.keeps({text("two")});
        CHECK(drafts(folder.path()) == Texts{"two"});
        CHECK(program.autosave.new_recoverable_files().empty()); // it is in use
        program.keeps({});
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("What has not changed is not copied again")
    {
        const Folder folder;
        Program program(folder.path());
        int n_copies = 0;
        ui::UnsavedDocument document = text("one");
        document.copy = [&n_copies, copy = document.copy] {
            ++n_copies;
            return copy();
        };
        program.keeps({document});
        program.keeps({document});
        CHECK(n_copies == 1);
    }

    TEST_CASE("The program does not wait for a disk that is slow")
    {
        const Folder folder;
        Program program(folder.path());
        std::atomic<bool> has_disk = false;
        ui::UnsavedDocument slow = text("one");
        slow.copy = [&has_disk, copy = slow.copy] {
            return [&has_disk, write = copy()](const fs::path& draft) {
                while (!has_disk) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return write(draft);
            };
        };
        for (int i = 0; i < 3; ++i) program.autosave.tick([&] { return std::vector{slow}; }, ui::Autosave::interval);
        program.autosave.tick([] { return std::vector<ui::UnsavedDocument>{}; },
                              ui::Autosave::interval); // saved meanwhile
        CHECK(drafts(folder.path()).empty());
        has_disk = true;
        program.autosave.wait();
        program.keeps({});
        CHECK(drafts(folder.path()).empty());
    }

    TEST_CASE("Where no draft can be kept it is told once, and again when it could be in between")
    {
        const Folder folder;
        const fs::path state = folder.path() / "state";
        std::ofstream(state) << "a file where the folder should be";
        Program program(state);
        CHECK(!program.keeps({})); // nothing has changed
        REQUIRE(program.keeps({text("one")}));
        CHECK(!program.keeps({text("one")}));
        fs::remove(state);
        CHECK(!program.keeps({text("one")}));
        fs::remove_all(state);
        std::ofstream(state) << "again";
        CHECK(!program.keeps({})); // there is nothing to keep
        CHECK(program.keeps({text("one")}));
    }

    TEST_CASE("A draft that is still held when another program starts is told as soon as it is free, and once only")
    {
        const Folder folder;
        auto dying = std::make_optional<ui::Draft>(drafts_in(folder.path()));
        REQUIRE_FALSE(dying->keep(text("one").copy(), "/tmp/lesson.txt"));
        ui::Autosave next(drafts_in(folder.path()));
        CHECK(next.new_recoverable_files().empty());
        dying.reset(); // the lock goes with its program, the draft stays
        const std::vector<ui::RecoverableFile> found = next.new_recoverable_files();
        REQUIRE(found.size() == 1);
        CHECK(found.front().original == fs::path("/tmp/lesson.txt"));
        CHECK(next.new_recoverable_files().empty());
    }

    TEST_CASE("A leftover that is opened stays the draft of its document, whatever becomes of the program")
    {
        const Folder folder;
        Program(folder.path()).keeps({text("one")}); // killed
        Program next(folder.path());
        const auto found = next.autosave.new_recoverable_files();
        REQUIRE(found.size() == 1);
        next.autosave.adopt(0, ui::Draft::taken_over(drafts_in(folder.path()), found[0]));
        CHECK(drafts(folder.path()) == Texts{"one"});
        next.keeps({text("two")});
        CHECK(drafts(folder.path()) == Texts{"two"});
        next.keeps({}); // saved
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("A leftover says what it holds in every language, whichever the program spoke that was killed")
    {
        const Folder folder;
        ui::UnsavedDocument document = text("one");
        document.about = [](const ui::Catalogue& tr) { return std::string(code(tr.language())); };
        {
            Program killed(folder.path());
            killed.keeps({document});
        }
        const auto found = Program(folder.path()).autosave.new_recoverable_files();
        REQUIRE(found.size() == 1);
        CHECK(found[0].about == Texts{"en", "pt"});
    }

    TEST_CASE("A program that ends in good order leaves no draft")
    {
        const Folder folder;
        Program program(folder.path());
        program.autosave.tick([] { return std::vector{text("one")}; }, ui::Autosave::interval);
        program.autosave.forget_all();
        CHECK(fs::is_empty(folder.path()));
    }
}
