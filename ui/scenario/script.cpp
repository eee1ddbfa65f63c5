#include "ui/scenario/script.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "ui/text/number_format.h"
#include "ui/text/trimmed.h"

namespace ui {

namespace {

std::string quoted(std::string_view text) { return text.empty() ? "nothing" : '"' + std::string(text) + '"'; }

/// One line: the keys that are held, its verb and the rest.
struct Line {
    std::size_t number;
    Modifiers held;
    std::string_view verb;
    std::string_view rest;

    [[noreturn]] void fail(std::string_view found, const std::string& wanted) const
    {
        throw ScenarioError(number, std::string(verb) + ": found " + quoted(found) + ", wanted " + wanted);
    }

    std::string words(const char* wanted) const
    {
        if (rest.empty()) fail(rest, wanted);
        return std::string(rest);
    }

    double number_in(std::string_view text, const char* wanted) const
    {
        const std::optional<double> value = number_typed(text);
        if (!value) fail(text, wanted);
        return *value;
    }

    // The rest split at its last `separator`.
    std::pair<std::string, std::string> split_last(std::string_view separator, const char* wanted) const
    {
        const std::size_t at = rest.rfind(separator);
        if (at == std::string_view::npos || at == 0) fail(rest, wanted);
        return {std::string(trimmed(rest.substr(0, at))), std::string(trimmed(rest.substr(at + separator.size())))};
    }
};

constexpr const char* a_place = "a place, such as node B, member AB 50%, (2, 0) or pixel 400 300";

step::Drag drag(const Line& line)
{
    auto [from, to] = line.split_last(" to ", "a place, \"to\" and a place: node B to (2, 1)");
    return {std::move(from), std::move(to), line.held};
}

step::Wheel wheel(const Line& line)
{
    auto [at, turns] = line.split_last(" ", "a place and a number of turns: node B 2");
    return {std::move(at), line.number_in(turns, "a number of turns"), line.held};
}

step::ReleaseButton release(const Line& line)
{
    if (!line.rest.empty()) line.fail(line.rest, "no place; hover moves the pointer");
    return {line.held};
}

step::Press press_key(const Line& line)
{
    const std::optional<Chord> chord = chord_typed(line.rest);
    if (!chord) line.fail(line.rest, "a key, such as M, Ctrl+Shift+Z, F5 or Esc");
    return {*chord};
}

step::Type type(const Line& line)
{
    const std::string_view rest = line.rest;
    if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"') line.fail(rest, "a text in quotes: \"4<30\"");
    std::string text;
    for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
        if (rest[i] == '\\' && i + 2 < rest.size()) ++i;
        text += rest[i];
    }
    return {text};
}

step::RunCommand command(const Line& line)
{
    const std::string words = line.words("the id of a command, such as edit.mirror");
    const std::size_t blank = words.find(' ');
    if (blank == std::string::npos) return {words, ""};
    return {words.substr(0, blank), std::string(trimmed(std::string_view(words).substr(blank)))};
}

step::Wait wait(const Line& line)
{
    constexpr const char* a_time = "between 0 and 600 seconds";
    const double seconds = line.number_in(line.rest, a_time);
    if (!(seconds >= 0.0 && seconds <= 600.0)) line.fail(line.rest, a_time);
    return {seconds};
}

using Step = decltype(ScenarioStep::what);

struct Verb {
    std::string_view name;
    bool is_of_mouse;
    Step (*read)(const Line&);
};
constexpr std::array verbs{
    Verb{"click", true,
         [](const Line& l) -> Step {
             return step::Click{l.words(a_place), l.held};
         }},
    Verb{"rightclick", true,
         [](const Line& l) -> Step {
             return step::RightClick{l.words(a_place), l.held};
         }},
    Verb{"hover", true,
         [](const Line& l) -> Step {
             return step::Hover{l.words(a_place), l.held};
         }},
    Verb{"drag", true, [](const Line& l) -> Step { return drag(l); }},
    Verb{"press", true,
         [](const Line& l) -> Step {
             return step::PressButton{l.words(a_place), l.held};
         }},
    Verb{"release", true, [](const Line& l) -> Step { return release(l); }},
    Verb{"wheel", true, [](const Line& l) -> Step { return wheel(l); }},
    Verb{"key", false, [](const Line& l) -> Step { return press_key(l); }},
    Verb{"type", false, [](const Line& l) -> Step { return type(l); }},
    Verb{"command", false, [](const Line& l) -> Step { return command(l); }},
    Verb{"wait", false, [](const Line& l) -> Step { return wait(l); }},
    Verb{"picture", false, [](const Line& l) -> Step { return step::TakePicture{l.words("a name")}; }},
    Verb{"expect", false, [](const Line& l) -> Step { return step::Expect{l.words("what is expected")}; }},
};

std::string names_of_verbs()
{
    std::string names;
    for (const Verb& verb : verbs) {
        const bool is_last = &verb == &verbs.back();
        names += (names.empty() ? "" : is_last ? " or " : ", ") + std::string(verb.name);
    }
    return names;
}

// "Shift+click" is the verb with a key held.
Step read_step(Line line)
{
    const std::string_view whole = line.verb;
    if (const std::size_t plus = whole.rfind('+'); plus != std::string_view::npos) {
        const auto chord = chord_typed(std::string(whole.substr(0, plus + 1)) + "A");
        line.verb = whole.substr(plus + 1);
        if (!chord) line.fail(whole.substr(0, plus), "Ctrl, Shift or Alt before a step of the mouse");
        line.held = chord->modifiers;
    }
    const auto verb = std::ranges::find(verbs, line.verb, &Verb::name);
    if (verb == verbs.end())
        throw ScenarioError(line.number, "found " + quoted(whole) + ", wanted a step: " + names_of_verbs());
    if (line.held != no_modifiers && !verb->is_of_mouse)
        line.fail(whole, "a step of the mouse after a key that is held");
    return verb->read(line);
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
        steps.push_back({number, read_step({number, {}, whole.substr(0, blank), trimmed(whole.substr(blank))})});
    }
    return steps;
}

} // namespace ui
