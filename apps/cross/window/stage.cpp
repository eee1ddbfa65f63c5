#include "apps/cross/window/stage.h"

#include <algorithm>
#include <array>

#include "apps/cross/session/commands.h"
#include "apps/cross/window/cell_names.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace cross {

namespace {

constexpr std::array<std::pair<std::string_view, Part>, 4> parts{
    {{"structure", Part::Structure}, {"deformed", Part::Deformed}, {"moments", Part::Moments}, {"sheet", Part::Sheet}}};

/// "node B", "load 1", "at 9 0" in the picture of the structure.
std::optional<ui::Point> in_structure(const Application& application, const std::vector<std::string>& words)
{
    const Drawn& drawn = application.canvas().drawn();
    const ui::Point corner = application.canvas().corner();
    if (words.size() == 2 && words[0] == "node")
        if (const auto node = application.session().document().model.find_node(words[1]);
            node && node->index < drawn.nodes.size())
            return corner + drawn.nodes.at(node->index).at;
    if (words.size() == 2 && words[0] == "end") {
        const Side side = words[1] == "left" ? Side::Left : Side::Right;
        const double scale = ui::Theme(application.session().look.theme).symbol_scale();
        if (const auto sign = sign_beyond(application.session().document().model, drawn, side, scale))
            return corner + *sign;
    }
    if (words.size() > 1 && words[0] == "value") {
        std::string wanted;
        for (std::size_t i = 1; i < words.size(); ++i) wanted += (i > 1 ? " " : "") + words[i];
        for (const WrittenText& written : drawn.texts)
            if (written.text == wanted) return corner + written.box.center();
    }
    const auto number = [&](std::size_t i) { return i < words.size() ? ui::number_typed(words[i]) : std::nullopt; };
    if (words.size() == 2 && words[0] == "load" && number(1) && *number(1) >= 1.0 &&
        *number(1) <= static_cast<double>(drawn.loads.size())) {
        const drawing::LoadMark& load = drawn.loads[static_cast<std::size_t>(*number(1)) - 1];
        return corner + 0.5 * (load.root + load.tip);
    }
    if (words.size() == 3 && words[0] == "at" && number(1) && number(2))
        return corner + drawn.on_sheet({*number(1), *number(2)});
    return std::nullopt;
}

/// "cell factor BA" on the sheet.
std::optional<ui::Point> in_cell(const Application& application, const std::vector<std::string>& words)
{
    const auto named = cell_named(application.session(), words);
    if (!named) return std::nullopt;
    for (const CellMark& mark : application.canvas().drawn().cells)
        if (mark.cell == named->cell) return application.canvas().corner() + mark.box.center();
    return std::nullopt;
}

} // namespace

OffscreenStage::Found OffscreenStage::locate(std::string_view place)
{
    const auto words = ui::words_of(place);
    if (const auto at = in_structure(application(), words)) return *at;
    if (!words.empty() && words[0] == "cell") {
        if (const auto at = in_cell(application(), words)) return *at;
        return "a cell of the sheet that is seen, such as cell factor BA, cell balance 1 BA or cell sum BA";
    }
    const std::string what =
        "cell factor BA, joint NAME, joint NAME in structure, deformed, moments or sheet, node NAME, load 1, "
        "end left, value 8 kN/m, at 2 0, or pixel 400 300";
    if (words.size() < 2 || words[0] != "joint") return what;
    const auto joint = joint_named(application().session(), words[1]);
    if (!joint) return "a joint that can be balanced";
    Part part = Part::Sheet;
    if (words.size() == 4 && words[2] == "in") {
        const auto* const found = std::ranges::find(parts, words[3], &std::pair<std::string_view, Part>::first);
        if (found == parts.end()) return what;
        part = found->second;
    }
    const auto at = application().canvas().in_window(*joint, part);
    if (!at) return "one that is drawn";
    return *at;
}

} // namespace cross
