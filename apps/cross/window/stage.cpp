#include "apps/cross/window/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/cross/session/own_order.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/window/cell_names.h"
#include "apps/cross/window/expectation.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace cross {

namespace {

constexpr std::array<std::pair<std::string_view, Part>, 4> parts{
    {{"structure", Part::Structure}, {"deformed", Part::Deformed}, {"moments", Part::Moments}, {"sheet", Part::Sheet}}};

std::optional<femoop::cross::JointId> joint_named(const Session& session, std::string_view name)
{
    const auto node = session.document().model.find_node(name);
    const auto& task = session.solution().task;
    return node && task ? task->problem.joint_at(*node) : std::nullopt;
}

std::optional<std::string> in_english(const std::optional<ui::Phrase>& reason)
{
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

std::optional<std::string> told(const Session& session, bool is_done)
{
    return is_done ? std::nullopt : std::optional(ui::Catalogue()(session.notice->sentence));
}

std::string wanted(std::string_view id, std::string_view found, const std::string& what)
{
    return std::string(id) + ": found \"" + std::string(found) + "\", wanted " + what;
}

std::optional<std::string> balance(Session& session, std::string_view name)
{
    const auto joint = joint_named(session, name);
    if (!joint) return wanted("work.balance", name, "a joint that can be balanced");
    return in_english(session.balance(*joint));
}

std::optional<std::string> set_case(Session& session, std::string_view name)
{
    const auto found = session.document().model.find_case(name);
    if (!found) return wanted("method.case", name, "a load case or combination");
    Method method = session.document().method;
    method.load_case = *found;
    session.set_method(method, ui::translatable("Choose a load case"));
    return std::nullopt;
}

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

/// "3 17": difficulty and number.
std::optional<std::string> begin_exercise(Session& session, std::string_view argument)
{
    const auto words = ui::words_of(argument);
    const auto number = [&](std::size_t i) { return i < words.size() ? ui::number_typed(words[i]) : std::nullopt; };
    const auto is_whole = [&](std::size_t i, double least, double most) {
        return number(i) && *number(i) >= least && *number(i) <= most && *number(i) == std::floor(*number(i));
    };
    if (words.size() != 2 || !is_whole(0, 1.0, n_difficulties) ||
        !is_whole(1, 0.0, std::numeric_limits<std::uint32_t>::max()))
        return wanted("exercise.new", argument, "a difficulty from 1 to 6 and a whole number from 0 to 4294967295");
    session.begin_exercise(
        {static_cast<femoop::cross::Difficulty>(static_cast<int>(*number(0))), static_cast<std::uint32_t>(*number(1))});
    return std::nullopt;
}

/// So many of the cells that are empty, with what belongs in them.
std::optional<std::string> fill(Session& session, double n)
{
    if (const auto reason = session.why_no_paper()) return in_english(reason);
    const std::size_t n_cells = session.paper()->form.blanks.size();
    for (std::size_t i = 0; i < n_cells && n > 0.0; ++i) {
        const femoop::cross::BlankId cell(i);
        if (session.paper()->is_written(cell) || session.paper()->form[cell].may_stay_empty) continue;
        session.write(cell, text_for(*session.paper(), cell, units_of(session.document().model, session.tr())));
        n -= 1.0;
    }
    return std::nullopt;
}

/// A command whose argument is a number.
std::optional<std::string> run_with_number(Session& session, std::string_view id, double number)
{
    Method method = session.document().method;
    if (id == "work.jump") session.jump(static_cast<std::size_t>(number));
    if (id == "work.sheet") session.set_stage(static_cast<std::size_t>(number));
    if (id == "method.digits") method.digits = std::min(16, static_cast<int>(number));
    if (id == "method.tolerance") method.tolerance = number;
    session.set_method(method, ui::translatable("Change the method"));
    return std::nullopt;
}

} // namespace

ui::Stage::Sought OffscreenStage::find(std::string_view place)
{
    if (const auto pixel = ui::pixel_place(place)) return *pixel;
    const auto words = ui::words_of(place);
    if (const auto at = in_structure(application(), words)) return ui::PointerPlace{at->x, at->y};
    if (!words.empty() && words[0] == "cell") {
        if (const auto at = in_cell(application(), words)) return ui::PointerPlace{at->x, at->y};
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
    return ui::PointerPlace{at->x, at->y};
}

std::optional<std::string> OffscreenStage::run_command(std::string_view id, std::string_view argument)
{
    Session& session = application().desk().session;
    if (argument.empty()) return ui::run_by_name(application().commands(), id, application().desk());
    if (id == "file.open") return told(session, session.open(argument));
    if (id == "file.save") return told(session, session.save(argument));
    if (id == "file.export") return in_english(application().export_as(argument));
    if (id == "exercise.new") return begin_exercise(session, argument);
    if (id == "work.balance") return balance(session, argument);
    if (id == "method.order") return in_english(take_own_order(session, argument));
    if (id == "method.case") return set_case(session, argument);
    constexpr std::array with_number{"work.jump", "work.sheet", "method.digits", "method.tolerance", "exercise.fill"};
    if (std::ranges::find(with_number, id) == with_number.end())
        return ui::run_by_name(application().commands(), id, application().desk());
    const auto number = ui::number_typed(argument);
    if (!number || *number < 0.0) return wanted(id, argument, "a number");
    if (id == "exercise.fill") return fill(session, *number);
    return run_with_number(session, id, *number);
}

std::optional<std::string> OffscreenStage::expect(std::string_view words) { return why_not(words, application()); }

} // namespace cross
