#include "apps/frame/window/stage.h"

#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "apps/frame/session/tabs.h"
#include "apps/frame/view/geometry/structure_shape.h"
#include "apps/frame/view/reading.h"
#include "apps/frame/view/sketch/scene.h"
#include "ui/text/number_format.h"

namespace frame {

namespace {

std::vector<std::string> words_of(std::string_view text)
{
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// "50%" or a length from the start.
std::optional<double> along(std::string_view text, double length)
{
    if (text.ends_with('%')) {
        const auto percent = ui::number_typed(text.substr(0, text.size() - 1));
        return percent ? std::optional(0.01 * *percent * length) : std::nullopt;
    }
    return ui::number_typed(text);
}

std::optional<Cut> cut_at(const femoop::Model& model, const std::string& member, std::string_view at)
{
    const auto id = model.find_member(member);
    if (!id) return std::nullopt;
    const auto x = along(at, shape_of(model)[*id].length);
    return x ? std::optional(Cut{*id, *x}) : std::nullopt;
}

// "(2, 0)" or "(2, 0, 1)".
std::optional<Eigen::Vector3d> model_point(std::string_view text)
{
    if (text.size() < 5 || text.front() != '(' || text.back() != ')') return std::nullopt;
    std::istringstream stream{std::string(text.substr(1, text.size() - 2))};
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::string coordinate;
    Eigen::Index i = 0;
    for (; i < 3 && std::getline(stream, coordinate, ','); ++i) {
        const auto value = ui::number_typed(coordinate);
        if (!value) return std::nullopt;
        point[i] = *value;
    }
    return i >= 2 ? std::optional(point) : std::nullopt;
}

} // namespace

std::optional<ui::PointerPlace> OffscreenStage::find(std::string_view place)
{
    const Session& session = application_.session();
    const Canvas& canvas = application_.canvas();
    const std::vector<std::string> words = words_of(place);
    std::optional<ui::Point> at;
    if (words.size() == 3 && words[0] == "pixel") {
        const auto x = ui::number_typed(words[1]);
        const auto y = ui::number_typed(words[2]);
        if (x && y) at = ui::Point{*x, *y};
    } else if (words.size() == 2 && words[0] == "node") {
        if (const auto id = session.model().find_node(words[1])) at = canvas.in_window(shape_of(session.model())[*id]);
    } else if (words.size() == 3 && words[0] == "member") {
        if (const auto cut = cut_at(session.model(), words[1], words[2])) at = canvas.in_window(*cut);
    } else if (const auto point = model_point(place)) {
        at = canvas.in_window(*point);
    }
    return at ? std::optional(ui::PointerPlace{at->x, at->y}) : std::nullopt;
}

std::optional<std::string> OffscreenStage::run_command(std::string_view id, std::string_view argument)
{
    Desk& desk = application_.desk();
    const ui::Catalogue english;
    if (id == "file.open" && !argument.empty()) {
        if (!open_file(desk, argument)) return english(desk.session.notice->sentence);
        return std::nullopt;
    }
    if (id == "file.save" && !argument.empty()) {
        if (!desk.session.save(argument)) return english(desk.session.notice->sentence);
        return std::nullopt;
    }
    if (id == "file.export_table" && !argument.empty()) {
        const auto reason = application_.tables().export_to(desk, argument);
        return reason ? std::optional(english(*reason)) : std::nullopt;
    }
    if (constexpr std::string_view prefix = "template."; id.starts_with(prefix))
        return desk.typical.obey(desk.session, id.substr(prefix.size()), argument);
    if (id == "file.export" && !argument.empty()) {
        const auto reason = application_.export_as(argument);
        return reason ? std::optional(english(*reason)) : std::nullopt;
    }
    if (constexpr std::string_view prefix = "section."; id.starts_with(prefix))
        return desk.section.obey(desk.session, id.substr(prefix.size()), argument);
    const auto* const command = application_.commands().find(id);
    if (command == nullptr) return "no command \"" + std::string(id) + "\"";
    const auto reason = run(*command, desk);
    return reason ? std::optional(english(*reason)) : std::nullopt;
}

std::optional<std::string> OffscreenStage::take_picture(std::string_view name)
{
    keep_(name, context_.pixels(), application_);
    return std::nullopt;
}

namespace {

// member AB M at 50% is -12.5 kN·m
std::optional<std::string> expect_value(const Session& session, const std::vector<std::string>& words)
{
    const auto cut = cut_at(session.model(), words[1], words[4]);
    if (!cut) return "no place " + words[4] + " of a member \"" + words[1] + "\"";
    if (!session.solution().results) return "the model has no results";
    std::string wanted = with_minus(words[6]);
    for (std::size_t i = 7; i < words.size(); ++i) wanted += ' ' + words[i];
    for (const ReadingLine& line : reading(session.model(), *session.solution().results, session.view, *cut)) {
        if (line.name != words[2]) continue;
        if (line.value == wanted) return std::nullopt;
        return "expected " + words[2] + " = " + wanted + ", found " + line.value;
    }
    return "no value " + words[2];
}

std::string selection_text(const Session& session, const ui::Catalogue& tr)
{
    std::string text;
    for (const Part& part : session.selection.parts())
        text += (text.empty() ? "" : ", ") + tr(title(session.model(), part));
    return text.empty() ? "nothing" : text;
}

} // namespace

std::optional<std::string> OffscreenStage::expect(std::string_view text)
{
    const Session& session = application_.session();
    const ui::Catalogue english;
    const std::vector<std::string> words = words_of(text);
    const bool is_value = words.size() >= 7 && words[0] == "member" && words[3] == "at" && words[5] == "is";
    if (is_value) return expect_value(session, words);
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view what = text.substr(0, blank);
    const std::string wanted(text.substr(std::min(blank + 1, text.size())));
    std::string found;
    if (what == "undo") {
        const auto label = session.history().undo_label();
        found = label ? english(*label) : "nothing";
    } else if (what == "selection") {
        found = selection_text(session, english);
    } else if (what == "case") {
        found = session.model().case_name(session.view.load_case);
    } else if (what == "problems") {
        found = std::to_string(session.solution().faults.size());
    } else if (what == "file") {
        found = session.file_name();
    } else if (what == "notice") {
        found = session.notice ? english(session.notice->sentence) : "nothing";
    } else {
        return "cannot expect \"" + std::string(text) +
               "\"; known are member, undo, selection, case, problems, file, notice";
    }
    if (found == wanted) return std::nullopt;
    return "expected " + std::string(what) + " " + wanted + ", found " + found;
}

void play(std::string_view script, ui::Offscreen& context, Application& application,
          const OffscreenStage::KeepPicture& keep)
{
    ui::Player player(ui::read_scenario(script));
    OffscreenStage stage(context, application, keep);
    std::optional<ui::Key> key_held;
    application.frame({});
    application.frame({});
    while (const auto frame = player.next(stage)) {
        ui::Input input;
        input.pointer = ui::Point{frame->pointer.x, frame->pointer.y};
        input.is_button_down[static_cast<std::size_t>(ui::PointerButton::Left)] = frame->is_left_down;
        input.wheel = {0.0, frame->wheel};
        input.seconds = ui::Player::time_step;
        input.text = frame->text;
        if (key_held) input.keys.push_back({*std::exchange(key_held, std::nullopt), false});
        if (frame->key) {
            input.modifiers = frame->key->modifiers;
            input.keys.push_back({frame->key->key, true});
            key_held = frame->key->key;
        }
        application.frame(input);
    }
}

} // namespace frame
