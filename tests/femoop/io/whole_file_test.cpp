#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "femoop/io/whole_file.h"

namespace fs = std::filesystem;

namespace {

/// A folder that goes with the test.
class Folder {
public:
    Folder()
    {
        std::string name = (fs::temp_directory_path() / "cremona.XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    fs::path operator/(const char* name) const { return path_ / name; }
    long n_files() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }

private:
    fs::path path_;
};

std::string contents(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_SUITE("io")
{
    TEST_CASE("A file is replaced whole, keeps its permissions, and nothing is left beside it")
    {
        const Folder folder;
        const fs::path path = folder / "beam.json";
        REQUIRE_FALSE(femoop::write_whole_file(path, "the old text, which is longer"));
        fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
        REQUIRE_FALSE(femoop::write_whole_file(path, "new"));
        CHECK(contents(path) == "new");
        CHECK(fs::status(path).permissions() ==
              (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
        CHECK(folder.n_files() == 1);
    }

    TEST_CASE("A link stays a link, and its target is replaced")
    {
        const Folder folder;
        REQUIRE_FALSE(femoop::write_whole_file(folder / "target.json", "old"));
        fs::create_symlink("target.json", folder / "link.json");
        REQUIRE_FALSE(femoop::write_whole_file(folder / "link.json", "new"));
        CHECK(fs::is_symlink(folder / "link.json"));
        CHECK(contents(folder / "target.json") == "new");
    }

    TEST_CASE("What cannot be written is said, and nothing is left behind")
    {
        const Folder folder;
        fs::create_directory(folder / "sub");
        CHECK(femoop::write_whole_file(folder / "sub", "text") == std::errc::is_a_directory);
        CHECK(femoop::write_whole_file(folder / "none/beam.json", "text") == std::errc::no_such_file_or_directory);
        CHECK(folder.n_files() == 1);
    }

    TEST_CASE("A full disk is said")
    {
        if (!fs::exists("/dev/full")) return;
        CHECK(femoop::write_whole_file("/dev/full", "text") == std::errc::no_space_on_device);
    }
}
