#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/folder.h"
#include "ui/context/image_clipboard.h"

TEST_SUITE_BEGIN("off screen");

namespace {

/// Programs are looked for here first, as long as it lives.
class ProgramsIn {
public:
    explicit ProgramsIn(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
    ~ProgramsIn() { setenv("PATH", before_.c_str(), 1); }
    ProgramsIn(const ProgramsIn&) = delete;
    ProgramsIn& operator=(const ProgramsIn&) = delete;

private:
    std::string before_;
};

} // namespace

TEST_CASE("A picture is handed to xclip as PNG, byte for byte; without xclip the reason names it")
{
    const Folder folder;
    folder.write("picture.png", "bytes of a picture");
    {
        const ProgramsIn nowhere(folder.path("."));
        const auto reason = ui::copy_png(folder.path("picture.png"));
        REQUIRE(reason);
        CHECK(reason->sentence.find("xclip") != std::string_view::npos);
    }
    folder.write("xclip",
                 "#!/bin/sh\necho \"$*\" >'" + folder.path("order") + "'\ncat >'" + folder.path("got") + "'\n");
    std::filesystem::permissions(folder.path("xclip"), std::filesystem::perms::owner_all);
    const ProgramsIn ours(folder.path(".") + ":" + std::getenv("PATH"));
    CHECK(!ui::copy_png(folder.path("picture.png")));
    CHECK(folder.read("got") == "bytes of a picture");
    CHECK(folder.read("order") == "-selection clipboard -t image/png -i\n");
}

TEST_SUITE_END();
