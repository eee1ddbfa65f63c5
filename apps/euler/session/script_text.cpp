// The script as it is written: line by line, or as a whole.
#include <algorithm>
#include <string>
#include <utility>

#include "apps/euler/session/session.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

using ui::translatable;

bool Session::write(std::string_view line)
{
    if (topology::words(line).empty()) {
        script_fault = translatable("a line begins with an operator; comments are written in the whole text");
        return false;
    }
    const std::string number = std::to_string(stepper_.next_line());
    const auto reason = apply(line);
    if (reason)
        script_fault = ui::Phrase(translatable("line {number}: {reason}"), {{"number", number}, {"reason", *reason}});
    return !reason;
}

std::optional<ui::Phrase> Session::why_not_edit_text() const
{
    constexpr std::size_t least = 8; // letters of a line: asked in every frame, so a long script is not written out
    bool is_short = stepper_.n_steps() <= most_letters_of_text / least;
    const std::string whole = is_short && !edited_text ? stepper_.script() : "";
    is_short = is_short && whole.size() <= most_letters_of_text;
    for (topology::Lines lines(whole); is_short && lines.next();)
        is_short = lines.line().size() <= most_letters_of_line;
    if (is_short || edited_text) return std::nullopt;
    return translatable("the script is too long to be edited here; open its file in a text editor");
}

void Session::edit_text()
{
    if (motion_) look_at_place();
    is_playing = false;
    give_up();
    script_fault.reset();
    edited_text = stepper_.script();
}

// Who was at the end is at the new end.
bool Session::accept_text()
{
    try {
        Stepper written(*edited_text);
        if (place() < n_steps()) written.go_to(std::min(place(), written.n_steps()));
        stepper_ = std::move(written);
    } catch (const topology::LineError& fault) {
        script_fault = ui::Phrase(fault.sentence([this](std::string_view pattern) { return tr()(pattern); }));
        return false;
    }
    edited_text.reset();
    note_change();
    return true;
}

void Session::give_up_text()
{
    edited_text.reset();
    script_fault.reset();
}

} // namespace euler
