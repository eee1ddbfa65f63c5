#include "apps/euler/session/script_text.h"

#include <algorithm>
#include <string>
#include <utility>

#include "apps/euler/session/session.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

using ui::translatable;

bool can_be_edited(std::string_view text)
{
    bool is_short = text.size() <= Session::most_letters_of_text;
    for (topology::Lines lines(text); is_short && lines.next();)
        is_short = lines.line().size() <= Session::most_letters_of_line;
    return is_short && topology::is_utf8(text) && text.find('\0') == std::string_view::npos;
}

ui::Message sentence(const topology::LineError& fault, const ui::Catalogue& tr)
{
    return ui::Message(fault.sentence([&](std::string_view pattern) { return tr(pattern); }));
}

bool Session::write(std::string_view line)
{
    if (topology::words(line).empty()) {
        script_fault = translatable("a line begins with an operator; comments are written in the whole text");
        return false;
    }
    const std::string number = std::to_string(stepper_.next_line());
    const auto reason = apply(line);
    if (reason)
        script_fault = ui::Message(translatable("line {number}: {reason}"), {{"number", number}, {"reason", *reason}});
    return !reason;
}

std::optional<ui::Message> Session::why_not_edit_text() const
{
    constexpr std::size_t least = 8; // letters of a line: asked in every frame, so a long script is not written out
    if (edited_text) return std::nullopt;
    if (stepper_.n_steps() <= most_letters_of_text / least && can_be_edited(stepper_.script())) return std::nullopt;
    return translatable("the script is too long to be edited here; open its file in a text editor");
}

void Session::edit_text()
{
    if (motion_) look_at_place();
    is_playing = false;
    cancel_operator();
    script_fault.reset();
    faulty_line.reset();
    edited_text = text_before_ = stepper_.script();
    if (given_up_ && given_up_->script == text_before_) edited_text = given_up_->text;
    given_up_.reset();
}

// What is saved is the script with what was written into its text.
void Session::settle()
{
    if (is_text_changed()) accept_text();
}

Session::Written Session::write_file(const std::filesystem::path& path)
{
    if (!is_text_changed()) return OpenDocument::write_file(path);
    const ui::Message refusal(translatable("{file} was not saved, since its text has a fault: {reason}"),
                              {{"file", path.filename().string()}, {"reason", *script_fault}});
    return {false, ui::lasting(refusal)};
}

// Who was at the end is at the new end.
bool Session::accept_text()
{
    try {
        Stepper written(*edited_text);
        if (place() < n_steps()) written.go_to(std::min(place(), written.n_steps()));
        stepper_ = std::move(written);
    } catch (const topology::LineError& fault) {
        notify_fault(fault);
        return false;
    }
    edited_text.reset();
    faulty_line.reset();
    set_partial(false);
    note_change();
    return true;
}

// The steps before the fault are open, and the text to mend it in, where that has room.
void Session::show_fault(const std::filesystem::path& path, const std::string& text, const topology::LineError& fault)
{
    set_partial(true);
    if (can_be_edited(text)) edited_text = text_before_ = text;
    notify_fault(fault);
    notify({translatable("{file} is open up to its fault: {reason}"),
            {{"file", path.filename().string()}, {"reason", *script_fault}}});
}

void Session::notify_fault(const topology::LineError& fault)
{
    script_fault = sentence(fault, tr());
    faulty_line = fault.number();
    is_fault_new = true;
}

void Session::cancel_text()
{
    if (is_text_changed()) {
        given_up_ = GivenUpText{stepper_.script(), *std::move(edited_text)};
        notify(translatable("The text was given up. It comes back when the script is edited as text (Shift+S)."));
    }
    edited_text.reset();
    faulty_line.reset();
    script_fault.reset();
}

} // namespace euler
