#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "femoop/files/whole_file.h"
#include "tests/folder.h"

namespace fs = std::filesystem;

TEST_SUITE("files")
{
    TEST_CASE("A file is replaced whole, keeps its permissions, and nothing is left beside it")
    {
        const Folder folder;
        const fs::path path = folder.path("beam.json");
        REQUIRE_FALSE(files::write_whole_file(path, "the old text, which is longer"));
        fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
        REQUIRE_FALSE(files::write_whole_file(path, "new"));
        CHECK(folder.read("beam.json") == "new");
        CHECK(fs::status(path).permissions() ==
              (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
        CHECK(folder.n_entries() == 1);
    }

    TEST_CASE("A link stays a link, and its target is replaced")
    {
        const Folder folder;
        REQUIRE_FALSE(files::write_whole_file(folder.path("target.json"), "old"));
        fs::create_symlink("target.json", folder.path("link.json"));
        REQUIRE_FALSE(files::write_whole_file(folder.path("link.json"), "new"));
        CHECK(fs::is_symlink(folder.path("link.json")));
        CHECK(folder.read("target.json") == "new");
    }

    TEST_CASE("A link that leads to nothing stays a link, and what it leads to is made")
    {
        const Folder folder;
        fs::create_symlink("target.json", folder.path("link.json"));
        REQUIRE_FALSE(files::write_whole_file(folder.path("link.json"), "new"));
        CHECK(fs::is_symlink(folder.path("link.json")));
        CHECK(folder.read("target.json") == "new");
        fs::create_symlink("round.json", folder.path("round.json"));
        CHECK(files::write_whole_file(folder.path("round.json"), "x") == std::errc::too_many_symbolic_link_levels);
        CHECK(fs::is_symlink(folder.path("round.json")));
    }

    TEST_CASE("A write-protected file is left alone, whoever asks")
    {
        const Folder folder;
        REQUIRE_FALSE(files::write_whole_file(folder.path("kept.json"), "old"));
        fs::permissions(folder.path("kept.json"), fs::perms::owner_read);
        CHECK(files::write_whole_file(folder.path("kept.json"), "new") == std::errc::permission_denied);
        CHECK(folder.read("kept.json") == "old");
        CHECK(folder.n_entries() == 1);
    }

#if __has_include(<sys/resource.h>) && !defined(__EMSCRIPTEN__) // node keeps no such limit
    TEST_CASE("A file that must not grow so far is not written, and nothing is left behind")
    {
        const Folder folder;
        rlimit before{};
        REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
        const rlimit small{.rlim_cur = 1000, .rlim_max = before.rlim_max};
        REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
        const std::error_code error = files::write_whole_file(folder.path("large.json"), std::string(5000, 'x'));
        REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
        CHECK(error == std::errc::file_too_large);
        CHECK(folder.n_entries() == 0);
    }
#endif

    TEST_CASE("What cannot be written is said, and nothing is left behind")
    {
        const Folder folder;
        fs::create_directory(folder.path("sub"));
        CHECK(files::write_whole_file(folder.path("sub"), "text") == std::errc::is_a_directory);
        CHECK(files::write_whole_file(folder.path("none/beam.json"), "text") == std::errc::no_such_file_or_directory);
        CHECK(folder.n_entries() == 1);
    }

    TEST_CASE("A full disk is said")
    {
        if (!fs::exists("/dev/full")) return;
        CHECK(files::write_whole_file("/dev/full", "text") == std::errc::no_space_on_device);
    }

    TEST_CASE("A file is read to its end, zeros and strange bytes too; a longer one than is allowed is not")
    {
        const Folder folder;
        const std::string text("a\0b\xFF\r\n", 6);
        const fs::path path = folder.write("strange", text);
        CHECK(files::read_whole_file(path).text == text);
        CHECK(files::read_whole_file(path, 6).text == text);
        const files::WholeFile longer = files::read_whole_file(path, 5);
        CHECK(longer.hindrance == std::errc::file_too_large);
        CHECK(longer.text.empty());
    }

    TEST_CASE("What cannot be read is said")
    {
        const Folder folder;
        CHECK(files::read_whole_file(folder.path("none")).hindrance == std::errc::no_such_file_or_directory);
        CHECK(files::read_whole_file(folder.path()).hindrance == std::errc::is_a_directory);
        if (fs::exists("/dev/zero"))
            CHECK(files::read_whole_file("/dev/zero").hindrance == std::errc::operation_not_supported);
    }

#if __has_include(<unistd.h>) && !defined(__EMSCRIPTEN__) // nor has it pipes
    TEST_CASE("What is piped into the program is read; a pipe of another name, which may never end, is not waited for")
    {
        const Folder folder;
        const fs::path pipe_of_a_name = folder.path("pipe");
        REQUIRE(mkfifo(pipe_of_a_name.c_str(), 0600) == 0);
        CHECK(files::read_whole_file(pipe_of_a_name).hindrance == std::errc::operation_not_supported);

        std::array<int, 2> ends{};
        REQUIRE(pipe(ends.data()) == 0);
        REQUIRE(write(ends[1], "piped", 5) == 5);
        close(ends[1]);
        const int before = dup(0);
        REQUIRE(dup2(ends[0], 0) == 0);
        close(ends[0]);
        const files::WholeFile piped = files::read_whole_file("/dev/stdin");
        dup2(before, 0);
        close(before);
        CHECK(piped.text == "piped");
    }
#endif
}
