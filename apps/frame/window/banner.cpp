#include "apps/frame/window/banner.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/session/fault_target.h"
#include "apps/frame/session/tabs.h"
#include "femoop/model/fault/errors_among.h"
#include "ui/widgets/offer.h"

namespace frame {

namespace {

std::string button(const ui::Catalogue& tr, std::string_view label, const char* id) { return tr(label) + id; }

ui::FootMessage message_of(const Notice& notice, const ui::Catalogue& tr)
{
    ui::FootMessage message{{tr(notice.sentence)}, {button(tr, ui::translatable("Close"), "###close notice")}};
    for (const femoop::Fault& fault : notice.faults) {
        if (notice.is_about_model) message.links.push_back(message.lines.size());
        message.lines.push_back("• " + sentence(fault, tr));
    }
    if (notice.to_mend) message.buttons.push_back(button(tr, ui::translatable("Open all the same"), "###open notice"));
    return message;
}

/// What keeps the picture from showing results, with its head; nothing where it shows them, or says it itself.
struct Hindrance {
    std::string head; ///< all that is said, since the picture has the faults; "" where they are said here
    std::vector<femoop::Fault> faults;
};

Hindrance hindrance(const Session& session)
{
    const ui::Catalogue& tr = session.view.tr;
    if (!session.shown_mechanisms().empty()) return {}; // the picture itself says how a mechanism moves
    if (const BlankCase* const blank = session.shown_blank())
        return {tr("Case {case} has no results.", {{"case", session.model().case_name(blank->id)}}), blank->faults};
    if (session.solution().results) return {};
    return {"", errors_among(session.solution().faults)};
}

// One line, so that the picture keeps its room while a model is mended.
ui::FootMessage message_of(const Hindrance& hindrance, const ui::Catalogue& tr)
{
    const std::size_t n = hindrance.faults.size();
    std::string line = hindrance.head.empty() ? sentence(hindrance.faults.front(), tr) : hindrance.head;
    if (hindrance.head.empty() && n > 1)
        line = tr("First of {count} problems: {sentence}", {{"count", std::to_string(n)}, {"sentence", line}});
    return {{std::move(line)},
            {button(tr, ui::translatable("Go there"), "###go to fault"),
             button(tr, ui::translatable("Problems"), "###problems")},
            {0}};
}

void show_problems(Workspace& workspace)
{
    workspace.topic = Topic::Problems;
    workspace.has_panels = true;
}

} // namespace

std::optional<ui::FootMessage> banner(const Workspace& workspace)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    if (workspace.session.notice) return message_of(*workspace.session.notice, tr);
    if (!workspace.offer.empty()) return ui::offer_message(workspace.offer, tr);
    const Hindrance found = hindrance(workspace.session);
    return found.faults.empty() ? std::nullopt : std::optional(message_of(found, tr));
}

void answer_banner(Workspace& workspace, const ui::FootMessage& message, std::size_t pressed)
{
    if (!workspace.session.notice) {
        if (!workspace.offer.empty()) return workspace.asked.push_back(ui::answer_of_button(pressed));
        const Hindrance found = hindrance(workspace.session);
        if (pressed == 1 || found.faults.empty()) show_problems(workspace);
        else go_to(workspace, found.faults.front()); // by its button or its sentence
        return;
    }
    if (pressed >= message.buttons.size()) {
        const femoop::Fault fault = workspace.session.notice->faults.at(pressed - message.buttons.size());
        return go_to(workspace, fault); // the notice stays for the next one
    }
    const std::optional<std::filesystem::path> to_mend = workspace.session.notice->to_mend;
    workspace.session.notice.reset();
    if (pressed == 1 && to_mend) open_file(workspace, *to_mend, Session::Purpose::Mend);
}

} // namespace frame
