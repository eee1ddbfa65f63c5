#include <doctest/doctest.h>

#include <filesystem>

#include "femoop/io/whole_file.h"
#include "tests/folder.h"

namespace fs = std::filesystem;

TEST_SUITE("io")
{
    TEST_CASE("A file is replaced whole, keeps its permissions, and nothing is left beside it")
    {
        const Folder folder;
        const fs::path path = folder.path("beam.json");
        REQUIRE_FALSE(femoop::write_whole_file(path, "the old text, which is longer"));
        fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
        REQUIRE_FALSE(femoop::write_whole_file(path, "new"));
        CHECK(folder.read("beam.json") == "new");
        CHECK(fs::status(path).permissions() ==
              (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
        CHECK(folder.n_entries() == 1);
    }

    TEST_CASE("A link stays a link, and its target is replaced")
    {
        const Folder folder;
        REQUIRE_FALSE(femoop::write_whole_file(folder.path("target.json"), "old"));
        fs::create_symlink("target.json", folder.path("link.json"));
        REQUIRE_FALSE(femoop::write_whole_file(folder.path("link.json"), "new"));
        CHECK(fs::is_symlink(folder.path("link.json")));
        CHECK(folder.read("target.json") == "new");
    }

    TEST_CASE("What cannot be written is said, and nothing is left behind")
    {
        const Folder folder;
        fs::create_directory(folder.path("sub"));
        CHECK(femoop::write_whole_file(folder.path("sub"), "text") == std::errc::is_a_directory);
        CHECK(femoop::write_whole_file(folder.path("none/beam.json"), "text") == std::errc::no_such_file_or_directory);
        CHECK(folder.n_entries() == 1);
    }

    TEST_CASE("A full disk is said")
    {
        if (!fs::exists("/dev/full")) return;
        CHECK(femoop::write_whole_file("/dev/full", "text") == std::errc::no_space_on_device);
    }
}
