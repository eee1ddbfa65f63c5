#include "apps/frame/window/blank_picture.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "apps/frame/window/no_results.h"
#include "ui/paint/label/oriented_box.h"
#include "ui/paint/theme.h"
#include "ui/paint/wrapped_lines.h"

namespace frame {

namespace {

/// Whether a member passes there, or its names would.
bool is_drawn_in(const ui::Box& box, const Projection& projection, const StructureShape& shape, double names)
{
    const ui::OrientedBox wide(0.5 * (box.min + box.max), {box.width() + 2.0 * names, box.height() + 2.0 * names});
    const auto passes = [&](const MemberShape& member) {
        return wide.meets_segment(projection(member.start), projection(member.end));
    };
    return std::ranges::any_of(shape.members, passes);
}

// At the foot of the sheet, unless the structure is there: the status bar says it too.
void write_at_foot(ui::Painter& painter, const std::string& sentence, const ui::Theme& theme,
                   const Projection& projection, const StructureShape& shape)
{
    constexpr double beside = 16.0, below = 10.0, line_height = 1.4, names = 1.8; // [px], then ems
    ui::TextStyle style = theme.text(ui::Role::Error, ui::Anchor::BottomLeft);
    style.plate = theme.background();
    const auto lines = ui::wrapped_lines(painter.fonts(), sentence, style, painter.size().width - 2.0 * beside);
    double width = 0.0;
    for (const std::string& line : lines) width = std::max(width, painter.measure(line, style).width);
    const double step = line_height * style.size, foot = painter.sheet().max.y - below;
    const double height = step * static_cast<double>(lines.size());
    if (is_drawn_in({{beside, foot - height}, {beside + width, foot}}, projection, shape, names * style.size)) return;
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    double y = foot - height + step;
    for (const std::string& line : lines) {
        painter.text({beside, y}, line, style);
        y += step;
    }
}

bool moves(const femoop::Mechanism& mechanism, std::size_t member)
{
    constexpr double still = 1e-6; // of the largest motion
    const auto& [start, end] = mechanism.member_ends[member];
    return start.norm() + end.norm() > still;
}

} // namespace

std::vector<std::string> why_blank(const Session& session)
{
    constexpr std::size_t most = 4;
    const BlankCase* const blank = session.shown_blank();
    if (blank == nullptr || !blank->mechanisms.empty() || session.hidden) return {};
    const ui::Catalogue& tr = session.view.tr;
    std::vector<std::string> all{tr("Case {case} has no results.", {{"case", session.model().case_name(blank->id)}})};
    for (const femoop::Fault& fault : std::span(blank->faults).first(std::min(blank->faults.size(), most)))
        all.push_back("• " + sentence(fault, tr));
    if (blank->faults.size() > most)
        all.push_back(tr("… and {count} more", {{"count", std::to_string(blank->faults.size() - most)}}));
    return all;
}

std::vector<std::string> why_no_train_values(const Session& session)
{
    const bool is_shown = session.shows_train_envelope() && session.solution().results;
    if (!is_shown || session.train_envelope.picture(session.model(), session.generation(), session.results_view()))
        return {};
    return session.train_envelope.why_none(session.view.tr);
}

std::vector<std::string> why_no_truss_shown(const Session& session)
{
    if (!session.truss.is_on() || shown_truss(session) != nullptr || session.truss.why_none().empty()) return {};
    return {why_no_truss_picture(session)};
}

std::vector<std::string> why_no_funicular_shown(const Session& session)
{
    if (!session.funicular.is_on(session.model()) || session.hidden || session.view.is_envelope) return {};
    if (shown_funicular(session) != nullptr || session.funicular.why_none().empty()) return {};
    return {session.view.tr("No funicular: {reason}.", {{"reason", session.funicular.why_none()}})};
}

std::vector<std::string> why_no_work_shown(const Session& session)
{
    if (!session.virtual_work.is_on(session.model()) || session.shown_results() == nullptr) return {};
    if (shown_work(session) != nullptr || session.virtual_work.why_none().empty()) return {};
    return {session.view.tr("No virtual work: {reason}.", {{"reason", session.virtual_work.why_none()}})};
}

void draw_loose_part(ui::Painter& painter, const Session& session, const DrawOptions& options,
                     const Projection& projection, const StructureShape& shape)
{
    std::vector<MemberShape> loose;
    for (std::size_t i = 0; i < shape.members.size(); ++i)
        if (std::ranges::any_of(session.shown_mechanisms(), [i](const auto& motion) { return moves(motion, i); }))
            loose.push_back(shape.members[i]);
    if (loose.empty() || loose.size() == shape.members.size()) return;
    const ui::Theme theme(options.theme);
    const ui::LayerScope layer(painter, ui::Layer::Lines);
    for (const MemberShape& member : loose)
        painter.line(projection(member.start), projection(member.end), theme.stroke(ui::Role::Mechanism));
    if (const femoop::Fault* const fault = why_not_solved(session))
        write_at_foot(painter, sentence(*fault, options.tr), theme, projection, shape);
}

} // namespace frame
