#include "ui/scenario/script.h"

#include <optional>
#include <utility>

#include "ui/text/number_format.h"

namespace ui {

namespace {

std::string_view trimmed(std::string_view text)
{
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// One line: its verb and the rest.
struct Line {
    std::size_t number;
    std::string_view verb;
    std::string_view rest;

    [[noreturn]] void fail(const std::string& what) const { throw ScenarioError(number, what); }

    std::string words(const char* wanted) const
    {
        if (rest.empty()) fail(std::string(verb) + " wants " + wanted);
        return std::string(rest);
    }

    double number_in(std::string_view text) const
    {
        const std::optional<double> value = number_typed(text);
        if (!value) fail("expected a number, found \"" + std::string(text) + "\"");
        return *value;
    }

    // The rest split at its last `separator`.
    std::pair<std::string, std::string> split_last(std::string_view separator, const char* wanted) const
    {
        const std::size_t at = rest.rfind(separator);
        if (at == std::string_view::npos || at == 0) fail(std::string(verb) + " wants " + wanted);
        return {std::string(trimmed(rest.substr(0, at))), std::string(trimmed(rest.substr(at + separator.size())))};
    }

    std::string quoted() const
    {
        if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"') fail("type wants a text in quotes");
        std::string text;
        for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
            if (rest[i] == '\\' && i + 2 < rest.size()) ++i;
            text += rest[i];
        }
        return text;
    }
};

step::Press press(const Line& line)
{
    const std::optional<Chord> chord = chord_typed(line.rest);
    if (!chord) line.fail("no key \"" + std::string(line.rest) + "\"");
    return {*chord};
}

step::RunCommand command(const Line& line)
{
    const std::string words = line.words("the id of a command");
    const std::size_t blank = words.find(' ');
    if (blank == std::string::npos) return {words, ""};
    return {words.substr(0, blank), std::string(trimmed(std::string_view(words).substr(blank)))};
}

decltype(ScenarioStep::what) read_step(const Line& line)
{
    if (line.verb == "click") return step::Click{line.words("a place")};
    if (line.verb == "hover") return step::Hover{line.words("a place")};
    if (line.verb == "drag") {
        auto [from, to] = line.split_last(" to ", "a place, \"to\" and a place");
        return step::Drag{std::move(from), std::move(to)};
    }
    if (line.verb == "wheel") {
        auto [at, turns] = line.split_last(" ", "a place and a number of turns");
        return step::Wheel{std::move(at), line.number_in(turns)};
    }
    if (line.verb == "key") return press(line);
    if (line.verb == "type") return step::Type{line.quoted()};
    if (line.verb == "command") return command(line);
    if (line.verb == "wait") {
        const double seconds = line.number_in(line.rest);
        if (seconds < 0.0 || seconds > 600.0) line.fail("wait wants between 0 and 600 seconds");
        return step::Wait{seconds};
    }
    if (line.verb == "picture") return step::TakePicture{line.words("a name")};
    if (line.verb == "expect") return step::Expect{line.words("what is expected")};
    line.fail("no step \"" + std::string(line.verb) +
              "\"; there are click, hover, drag, wheel, key, type, command, wait, "
              "picture and expect");
}

} // namespace

std::vector<ScenarioStep> read_scenario(std::string_view text)
{
    std::vector<ScenarioStep> steps;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string_view whole = trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (whole.empty() || whole.front() == '#') continue;
        const std::size_t blank = std::min(whole.find(' '), whole.size());
        steps.push_back({number, read_step({number, whole.substr(0, blank), trimmed(whole.substr(blank))})});
    }
    return steps;
}

} // namespace ui
