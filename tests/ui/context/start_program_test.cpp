#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/folder.h"
#include "ui/context/start_program.h"
#include "ui/text/catalogue.h"

TEST_SUITE_BEGIN("off screen");

namespace {

/// What a program that runs beside this one has written, once it is there.
std::string awaited(const Folder& folder, const std::string& name)
{
    for (int i = 0; i < 500 && !folder.has(name); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return folder.read(name);
}

} // namespace

TEST_CASE("A started program reads the document as a file from its standard input and gets its options")
{
    const Folder folder;
    folder.write("cremona-cross", "#!/bin/sh\ncat /dev/stdin >'" + folder.path("got") + "'\necho \"$*\" >'" +
                                      folder.path("part") + "'\nmv '" + folder.path("part") + "' '" +
                                      folder.path("order") + "'\n");
    std::filesystem::permissions(folder.path("cremona-cross"), std::filesystem::perms::owner_all);
    const ui::ExportToApp exported{.program = "cross", .document = "{\"cremona\": 1}\n", .options = {"--lang", "pt"}};
    CHECK(!ui::start_program(exported, folder.path()));
    CHECK(awaited(folder, "order") == "- --lang pt\n");
    CHECK(folder.read("got") == "{\"cremona\": 1}\n");
}

TEST_CASE("A program that is not beside this one is told by its name and the folder")
{
    const Folder folder;
    const auto reason = ui::start_program({.program = "cross", .document = "{}"}, folder.path());
    REQUIRE(reason);
    const std::string told = ui::Catalogue()(*reason);
    CHECK(told.find("cross") != std::string::npos);
    CHECK(told.find(folder.path().string()) != std::string::npos);
}

TEST_CASE("The programs of the suite are looked for where the running one is")
{
    CHECK(std::filesystem::is_directory(ui::folder_of_programs()));
}

TEST_SUITE_END();
