#include <cmath>
#include <numbers>
#include <utility>

#include "apps/frame/session/commands.h"
#include "apps/frame/session/table_commands.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/tools/kept_settings.h"

namespace frame {

namespace {

constexpr double seconds_per_swing = 2.4;
constexpr double full_swing = 0.25 * seconds_per_swing; // a still picture shows the full displacement

// The deformed shape or a mechanism.
bool is_swinging(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const bool moves_released = workspace.refused_release && workspace.refused_release->moves(session);
    const bool can_move = !session.shown_mechanisms().empty() || moves_released;
    return session.is_animated || (can_move && !session.is_still);
}

} // namespace

Workspace::Workspace(Session first) : session(std::move(first)), swing_(full_swing) {}

void Workspace::tick(double seconds)
{
    swing_ = is_swinging(*this) ? swing_ + seconds : full_swing;
    session.draw_state.phase = std::sin(2.0 * std::numbers::pi * swing_ / seconds_per_swing);
    if (bottom.shows(BottomContent::Solver)) solver.advance(seconds);
    session.train_envelope.give_time();
    ui::tick(session.notice, seconds);
}

bool Workspace::is_moving() const
{
    const bool has_passing_notice = session.notice && session.notice->seconds_left;
    const bool is_walking = bottom.shows(BottomContent::Solver) && solver.is_playing();
    const bool is_looking = session.shows_train_envelope() && session.train_envelope.is_looking();
    return is_swinging(*this) || is_walking || has_passing_notice || is_looking;
}

std::string Workspace::kept_tools() const
{
    const std::string tools = kept_words(tool_controller.settings()), table = kept_words(bottom);
    return table.empty() ? tools : tools + " " + table;
}

void Workspace::take_up_tools(std::string_view words)
{
    take_up(tool_controller.settings(), words);
    take_up(bottom, words);
}

bool Workspace::has_open_draft() const
{
    return typical.is_open() || section.is_open() || design.is_open() || trains.is_open();
}

void Workspace::open_dropped(const std::vector<std::string>& files)
{
    const bool is_choosing = has_open_draft() || after_question;
    if (is_choosing && !files.empty()) return notify(ui::translatable("finish what is being made in the window first"));
    for (const std::string& file : files) open(file);
}

std::vector<ui::UnsavedDocument> Workspace::unsaved() const
{
    std::vector<ui::UnsavedDocument> documents;
    for (std::size_t i = 0; i < n_tabs(*this); ++i)
        if (const Session& in = frame::tab(*this, i); in.is_dirty()) documents.push_back(in.unsaved());
    return documents;
}

std::optional<std::uint64_t> Workspace::recover(const ui::RecoverableFile& recoverable)
{
    Session recovered{Document{}};
    if (!recovered.recover(recoverable.draft, recoverable.original)) {
        session.refuse(recoverable.draft, *recovered.notice);
        return std::nullopt;
    }
    add_tab(*this, std::move(recovered));
    return session.number();
}

} // namespace frame
