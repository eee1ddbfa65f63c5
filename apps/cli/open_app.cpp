#include "apps/cli/open_app.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <variant>

#include "apps/cli/subcommands.h"
#include "femoop/io/any_model.h"
#include "femoop/io/cross/cross_block.h"

namespace cli {

namespace {

constexpr std::array<std::string_view, 2> apps_alone = {"frame", "plane"};
constexpr std::array<std::string_view, 3> apps_and_commands = {"cross", "mohr", "euler"};

bool is_among(std::string_view word, const auto& words) { return std::ranges::find(words, word) != words.end(); }

bool names_a_command(std::string_view word)
{
    return std::ranges::any_of(all_subcommands(), [&](const auto& command) { return command->name() == word; });
}

bool is_file(const std::string& word)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(word, ignored);
}

bool has_sheet(const femoop::ModelReading& reading)
try {
    return reading.is_sound() && femoop::cross::block_of(reading.model).has_value();
} catch (const femoop::ModelError&) {
    return true; // a faulty one: the app says what is wrong
}

} // namespace

std::string app_of_file(const std::string& path)
{
    if (path.ends_with(".eul")) return "euler";
    if (path.ends_with(".mohr")) return "mohr";
    const femoop::AnyReading read = femoop::examine_any_file(path);
    if (std::holds_alternative<femoop::plane::PlaneReading>(read)) return "plane";
    return has_sheet(std::get<femoop::ModelReading>(read)) ? "cross" : "frame";
}

std::optional<AskedApp> asked_app(const std::vector<std::string>& arguments)
{
    if (arguments.empty()) return std::nullopt;
    const std::string& word = arguments.front();
    if (is_among(word, apps_alone) || (is_among(word, apps_and_commands) && arguments.size() == 1))
        return AskedApp{word, {arguments.begin() + 1, arguments.end()}};
    if (word.starts_with('-') || !is_file(word) || names_a_command(word)) return std::nullopt;
    return AskedApp{app_of_file(word), arguments};
}

} // namespace cli
