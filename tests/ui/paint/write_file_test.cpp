#include <doctest/doctest.h>

#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>

#include "tests/folder.h"
#include "tests/text_of.h"
#include "ui/paint/surface/write_file.h"

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>

namespace {

/// No file may grow beyond so many bytes, for a while.
class SizeLimit {
public:
    explicit SizeLimit(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit less{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &less);
    }
    ~SizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;

private:
    rlimit before_{};
};

} // namespace

TEST_CASE("A picture for which there is no room is told of, and no part of it is left behind")
{
    const Folder folder;
    const std::filesystem::path path = folder.path() / "a.svg";
    const std::string bytes(5000, 'x');
    {
        const SizeLimit limit(1000);
        CHECK_THROWS_AS(ui::write_file(path, bytes), std::runtime_error);
    }
    CHECK_FALSE(std::filesystem::exists(path));
    ui::write_file(path, bytes);
    CHECK(std::filesystem::file_size(path) == bytes.size());
}

TEST_CASE("A picture for which there is no room leaves the older one of its name as it was, and nothing beside it")
{
    const Folder folder;
    const std::filesystem::path path = folder.path() / "a.svg", link = folder.path() / "link.svg";
    ui::write_file(path, "older");
    std::filesystem::create_symlink(path, link);
    const auto n_files = [&] { return std::distance(std::filesystem::directory_iterator(folder.path()), {}); };
    for (const std::filesystem::path& target : {path, link}) {
        const SizeLimit limit(1000);
        CHECK_THROWS_AS(ui::write_file(target, std::string(5000, 'x')), std::runtime_error);
        CHECK(text_of(path) == "older");
        CHECK(n_files() == 2);
    }
    std::filesystem::permissions(path, std::filesystem::perms(0640));
    ui::write_file(link, "newer");
    CHECK(text_of(path) == "newer");
    CHECK(std::filesystem::is_symlink(link));
    CHECK(std::filesystem::status(path).permissions() == std::filesystem::perms(0640));
    CHECK(n_files() == 2);
}

#endif
