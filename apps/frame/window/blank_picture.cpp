#include "apps/frame/window/blank_picture.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "ui/paint/theme.h"
#include "ui/paint/wrapped_lines.h"

namespace frame {

namespace {

std::vector<std::string> reasons(const Session& session, const BlankCase& blank)
{
    constexpr std::size_t most = 4;
    const ui::Catalogue& tr = session.view.tr;
    std::vector<std::string> all{tr("Case {case} has no results.", {{"case", session.model().case_name(blank.id)}})};
    for (const femoop::Fault& fault : std::span(blank.faults).first(std::min(blank.faults.size(), most)))
        all.push_back("• " + sentence(fault, tr));
    if (blank.faults.size() > most)
        all.push_back(tr("… and {count} more", {{"count", std::to_string(blank.faults.size() - most)}}));
    return all;
}

} // namespace

void draw_why_blank(ui::Painter& painter, const Session& session, const DrawOptions& options)
{
    const BlankCase* const blank = session.shown_blank();
    if (blank == nullptr || !blank->mechanisms.empty() || session.hidden) return;
    const ui::Theme theme(options.theme);
    ui::TextStyle style = theme.text(ui::Role::Error, ui::Anchor::BottomLeft);
    style.plate = theme.background();
    std::vector<std::string> lines;
    for (const std::string& reason : reasons(session, *blank)) {
        const auto wrapped = ui::wrapped_lines(painter.fonts(), reason, style, painter.size().width - 32.0);
        lines.insert(lines.end(), wrapped.begin(), wrapped.end());
    }
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const double step = 1.4 * style.size;
    double y = painter.sheet().max.y - 10.0 - step * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
        painter.text({16.0, y}, line, style);
        y += step;
    }
}

} // namespace frame
