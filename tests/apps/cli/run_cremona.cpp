#include "tests/apps/cli/run_cremona.h"
#include "tests/source_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <stdexcept>

namespace cli_test {

namespace {

std::string quoted(const std::string& argument)
{
    std::string text = "'";
    for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

} // namespace

Run shell(const std::string& line)
{
    const Folder folder;
    const std::string bin = std::filesystem::path(CREMONA_PROGRAM).parent_path().string();
    const std::string command = "cd " + quoted(source_folder()) + " && PATH=" + quoted(bin) + ":\"$PATH\" && { " +
                                line + "\n} >" + quoted(folder.path("out")) + " 2>" + quoted(folder.path("err"));
    const int status = std::system(command.c_str()); // NOLINT: the tests are about what a shell sees
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("out"), folder.read("err")};
}

Run cremona(const std::vector<std::string>& arguments, const std::string& input)
{
    const Folder folder;
    std::string line = quoted(CREMONA_PROGRAM);
    for (const std::string& argument : arguments) line += " " + quoted(argument);
    return shell(line + " <" + quoted(folder.write("in", input)));
}

std::string cantilever()
{
    return R"({"cremona": 1, "title": "Cantilever", "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
  "materials": [{"id": "s", "E": 2e8}],
  "sections": [{"id": "c", "A": 0.01, "Iz": 1e-4}],
  "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [4, 0]}],
  "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c"}],
  "load_cases": [{"id": "P", "nodes": [{"node": "B", "fy": -12}]}],
  "combinations": [{"id": "U", "factors": {"P": 1.5}}],
  "expected": [
    {"case": "P", "quantity": "displacement", "node": "B", "component": "uy", "value": -0.0128},
    {"case": "P", "quantity": "section_force", "member": "AB", "component": "M", "at": 0, "value": -48},
    {"case": "U", "quantity": "reaction", "node": "A", "component": "fy", "value": 18}]})";
}

std::string floating()
{
    std::string text = cantilever();
    const std::string support = R"(, "support": "fixed")";
    text.erase(text.find(support), support.size());
    const std::size_t expected = text.find(",\n  \"expected\"");
    return text.substr(0, expected) + "}";
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
    return n;
}

} // namespace cli_test
