#include "tests/scenarios/script_files.h"
#include "tests/browser_build.h"
#include "tests/text_of.h"

#include <algorithm>
#include <string_view>

namespace fs = std::filesystem;

fs::path repository() { return CREMONA_SOURCE_DIR; }

namespace {

/// By rounding: which of six equal motions comes first, and which of many equal extremes is marked.
constexpr std::string_view decided_by_rounding[] = {"scenarios/loose_in_space.scenario", "plane/compared.scenario"};

bool can_be_played(const fs::path& scenario)
{
    if (!is_for_browser) return true;
    const std::string name = scenario.generic_string();
    return text_of(scenario).find(".pdf") == std::string::npos &&
           std::ranges::none_of(decided_by_rounding, [&](std::string_view end) { return name.ends_with(end); });
}

} // namespace

std::vector<fs::path> scenarios_in(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(repository() / folder))
        if (entry.path().extension() == ".scenario" && can_be_played(entry.path())) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string scenario_on(const std::string& page)
{
    constexpr std::string_view begin = "```scenario\n", end = "```\n";
    std::string script;
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
        at += begin.size();
        script += page.substr(at, page.find(end, at) - at);
    }
    return script;
}

Workplace::Workplace()
{
    const fs::path desk = go_to_desk();
    for (const char* name : {"examples", "tests"}) fs::create_directory_symlink(repository() / name, desk / name);
}

Workplace::Workplace(const fs::path& file) { fs::copy_file(repository() / file, go_to_desk() / file.filename()); }

/// What is written beside the desk is gone too.
fs::path Workplace::go_to_desk() const
{
    fs::path desk = folder_.path() / "desk";
    fs::create_directory(desk);
    fs::current_path(desk);
    return desk;
}
