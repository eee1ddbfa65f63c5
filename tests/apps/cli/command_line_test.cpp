#include <doctest/doctest.h>

#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

const std::string commands[] = {"solve", "verify", "check", "render", "convert", "bench"};

std::size_t characters(const std::string& line)
{
    std::size_t n = 0;
    for (const char c : line) n += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    return n;
}

} // namespace

TEST_CASE("Without a command the status is 2, and the message says where the help is")
{
    const Run run = cremona({});
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err == "no command is given; see cremona --help\n");
}

TEST_CASE("A mistyped command is answered with the nearest one")
{
    const Run run = cremona({"slove", "x.json"});
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err == "cremona: there is no command slove; did you mean solve? see cremona --help\n");
}

TEST_CASE("A mistyped option is answered with the nearest one")
{
    const Run run = cremona({"solve", "x.json", "--staions", "5"});
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err ==
          "cremona solve: there is no option --staions; did you mean --stations? see cremona solve --help\n");
}

TEST_CASE("An option without its value is named")
{
    const Run run = cremona({"solve", "x.json", "--case"});
    CHECK(run.status == 2);
    CHECK(run.err == "cremona solve: --case needs a value, and takes one only; see cremona solve --help\n");
}

TEST_CASE("A second file is one argument too many for solve")
{
    const Run run = cremona({"solve", "a.json", "b.json"});
    CHECK(run.status == 2);
    CHECK(run.err == "cremona solve: b.json is one argument too many; see cremona solve --help\n");
}

TEST_CASE("The help of every command goes to stdout and names its options, examples and exit statuses")
{
    for (const std::string& command : commands) {
        CAPTURE(command);
        const Run run = cremona({command, "--help"});
        CHECK(run.status == 0);
        CHECK(run.err.empty());
        CHECK(has(run.out, "Usage: cremona " + command));
        for (const char* part : {"--lang LANG", "--help", "Examples:\n  cremona ", "Exit status:", "\n  3  "})
            CHECK(has(run.out, part));
        CHECK(has(cremona({"--help"}).out, "\n  " + command + " "));
    }
}

TEST_CASE("No line of help is wider than 100 characters, in either language")
{
    for (const std::string& command : commands)
        for (const char* language : {"en", "pt"}) {
            CAPTURE(command);
            std::istringstream help(cremona({command, "--help", "--lang", language}).out);
            for (std::string line; std::getline(help, line);) {
                CAPTURE(line);
                CHECK(characters(line) <= 100);
            }
        }
}

TEST_CASE("Help and messages speak Portuguese with --lang pt, before or after the command")
{
    CHECK(has(cremona({"solve", "--help", "--lang", "pt"}).out, "Código de saída:"));
    CHECK(has(cremona({"--lang=pt", "solve", "--help"}).out, "Código de saída:"));
    CHECK(cremona({"--lang", "pt"}).err == "nenhum comando foi dado; veja cremona --help\n");
}

TEST_CASE("A place beyond the end of a member is told in the user's language, by whatever option asks for it")
{
    for (const char* option : {"--why", "--virtual-work", "--force-method"}) {
        CAPTURE(option);
        const std::vector<std::string> words{"solve", "-", option, "member=AB,at=150%,component=M", "--lang", "pt"};
        const Run run = cremona(words, cli_test::cantilever());
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(run.err.starts_with("cremona solve: " + std::string(option) +
                                  " member: \"at\" é 150%, além do fim da barra"));
    }
}

TEST_CASE("A language that is not there is refused")
{
    const Run run = cremona({"solve", "x.json", "--lang", "xx"});
    CHECK(run.status == 2);
    CHECK(run.err == "cremona: --lang: there is no language \"xx\"; use en or pt\n");
}

TEST_CASE("--version prints one line")
{
    const Run run = cremona({"--version"});
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("cremona "));
    CHECK(run.out.find('\n') == run.out.size() - 1);
}

TEST_CASE("A reader that goes away is no error")
{
    const Folder folder;
    const std::string file = folder.write("c.json", cli_test::cantilever());
    const Run run = cli_test::shell("{ cremona solve --stations 50000 --json " + file +
                                    "; echo status $? >&2; } | head -c 1");
    CHECK(run.out == "{");
    CHECK(run.err == "status 0\n");
}

TEST_CASE("A full disk behind stdout is told, with status 2")
{
    if (!std::filesystem::exists("/dev/full")) return;
    const Folder folder;
    const Run run = cli_test::shell("cremona solve " + folder.write("c.json", cli_test::cantilever()) + " >/dev/full");
    CHECK(run.status == 2);
    CHECK(has(run.err, "cannot write to standard output"));
}

TEST_SUITE_END();
