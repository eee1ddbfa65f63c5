// Golden pictures of moment distribution: beams and frames, locked, on the way and balanced, themes and languages.
#include <doctest/doctest.h>

#include <algorithm>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/cross/document/file.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/scene.h"
#include "apps/cross/view/sheet_places.h"
#include "tests/apps/cross/strings.h"
#include "tests/golden/scene.h"
#include "ui/paint/label/oriented_box.h"
#include "ui/paint/surface.h"
#include "ui/paint/surface/golden_text.h"

using namespace cross;
namespace fc = femoop::cross;

TEST_SUITE_BEGIN("pictures");

namespace {

struct Shot {
    std::size_t n_turns = 0;
    std::size_t stage = 0;
    double phase = 1.0;
    Look look{};
    ui::Size size{1000.0, 760.0};
    std::optional<fc::JointId> hover{};
};

Document example(const std::string& name) { return read_document_file("examples/" + name + ".json"); }

void take_turns(Document& document, Solution& solution, std::size_t n)
{
    document.plays.resize(solution.task->n_sheets());
    for (std::size_t i = 0; i < n; ++i) {
        document.plays[document.stage].advance(*next_turn(document, solution));
        work(solution, document);
    }
}

void check(const std::string& name, Document document, const Shot& shot)
{
    Solution solution = solve(document);
    document.stage = shot.stage;
    if (solution.task) take_turns(document, solution, shot.n_turns);
    std::optional<femoop::Results> state;
    if (solution.task)
        state = fc::state_results(document.model, solution.task->problem,
                                  present_locks(document, solution, shot.phase));
    const ui::Theme theme(shot.look.theme);
    golden::check_scene(name, {.size = shot.size, .background = theme.background()}, [&](ui::Painter& painter) {
        draw(painter, {document, solution, state ? &*state : nullptr, shot.phase, shot.hover, shot.look});
    });
}

Document portal(const char* load_case)
{
    Document document = example("portal");
    document.method.load_case = *document.model.find_case(load_case);
    return document;
}

} // namespace

TEST_CASE("What lies under the pointer stays there while the pictures zoom and 200 times is the most")
{
    const Eigen::Vector2d own(10.0, 3.0), at(4.0, 2.0);
    const Zoom twice = zoomed({}, own, at, 2.0);
    const auto distance = [&](const Zoom& zoom) -> Eigen::Vector2d {
        return zoom.factor * (at - zoom.middle.value_or(own));
    };
    CHECK(distance(twice).isApprox(distance({})));
    CHECK(distance(zoomed(twice, own, at, 1e9)).isApprox(distance({})));
    CHECK(zoomed(twice, own, at, 1e9).factor == Zoom::most);
    CHECK(moved(twice, own, {1.0, 0.5}).middle->isApprox(*twice.middle - Eigen::Vector2d(1.0, 0.5)));
}

TEST_CASE("A locked beam has its fixed-end moments and a lock on every joint")
{
    check("cross_locked", starting_document(), {});
}

TEST_CASE("Each balance is underlined and the last turn stands out")
{
    check("cross_midway", starting_document(), {.n_turns = 3, .hover = fc::JointId(0)});
}

TEST_CASE("A joint half turned carries nothing over yet")
{
    check("cross_turning", starting_document(), {.n_turns = 2, .phase = 0.45});
}

TEST_CASE("Carry-overs fly along the members from near end to far end")
{
    check("cross_carrying", starting_document(), {.n_turns = 2, .phase = 0.85});
}

TEST_CASE("A balanced beam has lost its oldest rows where there was no room")
{
    check("cross_balanced", starting_document(), {.n_turns = 11, .size = {1000.0, 640.0}});
}

TEST_CASE("A portal's props hold it while the loads are distributed")
{
    check("cross_portal_loads", portal("W"), {.n_turns = 3});
}

TEST_CASE("A sway alone has fixed-end moments in the columns")
{
    check("cross_portal_sway", portal("W"), {.n_turns = 2, .stage = 1});
}

TEST_CASE("All sheets together have no locks") { check("cross_portal_together", portal("W"), {.stage = 2}); }

TEST_CASE("The head of a column is no broader than the column, whatever its nodes are called")
{
    Document document = example("portal");
    document.model.nodes[0].id = "Apoio esquerdo";
    document.model.nodes[1].id = "Nó central";
    const Solution solution = solve(document);
    REQUIRE(solution.task);
    const ui::Fonts fonts;
    const ui::Painter painter({100.0, 100.0}, fonts);
    const ui::TextStyle style{.size = 12.0};
    for (const double width : {58.0, 90.0, 250.0})
        for (const fc::End& end : solution.task->problem.ends) {
            CAPTURE(end.label);
            CHECK(painter.measure(head_within(painter, document.model, end, style, width), style).width <= width);
        }
    const fc::End& foot = solution.task->problem.ends[0];
    CHECK(foot.label == "Apoio esquerdo-Nó central");
    CHECK(head_within(painter, document.model, foot, style, 250.0) == foot.label);
    CHECK(head_within(painter, document.model, foot, style, 90.0) == "Apoi…-Nó c…");
}

TEST_CASE("Half of a symmetric portal is written left of the axis, and the sums stand on both sides")
{
    Document document = example("portal");
    document.method.extent = fc::Extent::Half;
    check("cross_half", document, {.n_turns = 1});
}

TEST_CASE("In Portuguese on the projector the sheet is read from the last row")
{
    Look look;
    look.theme = ui::ThemeName::Projector;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("cross_projector_pt", starting_document(), {.n_turns = 4, .look = look, .size = {1280.0, 960.0}});
}

TEST_CASE("Printed the sheet needs no colour")
{
    Look look;
    look.theme = ui::ThemeName::Print;
    check("cross_print", example("continuous_beam"), {.n_turns = 3, .look = look});
}

namespace {

/// Where a word stands in the structure's picture of a portal; nothing where it does not.
std::optional<ui::Box> box_of(const std::string& text, const Drawn& drawn)
{
    const auto found = std::ranges::find(drawn.texts, text, &WrittenText::text);
    return found == drawn.texts.end() ? std::nullopt : std::optional(found->box);
}

} // namespace

TEST_CASE("A portal's load is written below the heading in every window, and its lengths whole")
{
    const Document document = portal("G");
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
        for (const ui::Size size : {ui::Size{630.0, 720.0}, ui::Size{1280.0, 720.0}, ui::Size{1920.0, 1000.0}}) {
            CAPTURE(size.width);
            Look look;
            look.theme = theme;
            ui::Painter painter(size, fonts);
            const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look});
            const bool is_brief = !box_of("Structure and loads: G", drawn); // the title says the units
            const auto written = [&](const std::string& value, const char* unit) {
                return box_of(is_brief ? value : value + " " + unit, drawn);
            };
            const auto heading = box_of(is_brief ? "Loads: G [kN, m]" : "Structure and loads: G", drawn);
            const auto load = written("12", "kN/m");
            REQUIRE(heading);
            REQUIRE(load);
            CHECK(load->min.y > heading->center().y);
            for (const drawing::LoadMark& mark : drawn.loads)
                for (const ui::Point& at : mark.area) CHECK(at.y > heading->max.y);
            for (const char* const length : {"4.5", "8"}) {
                CAPTURE(length);
                const auto box = written(length, "m");
                REQUIRE(box);
                CHECK(drawn.views.front().box.contains(box->min));
                CHECK(drawn.views.front().box.contains(box->max));
            }
        }
}

TEST_CASE(
    "A beam's lengths and stiffnesses are written whole where loads point up as well as down, on a small projector")
{
    Document document = starting_document();
    auto& loads = document.model.load_cases.front().members;
    REQUIRE(loads.size() == 3);
    std::get<femoop::DistributedLoad>(loads[0].load).values.front().start = femoop::Quantity(8.1);
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
        for (const ui::Size size : {ui::Size{900.0, 494.0}, ui::Size{630.0, 720.0}, ui::Size{1280.0, 694.0}}) {
            CAPTURE(size.width);
            Look look;
            look.theme = theme;
            ui::Painter painter(size, fonts);
            const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look});
            for (const char* const length : {"8 m", "6 m", "20 m"}) {
                CAPTURE(length);
                REQUIRE(box_of(length, drawn));
                CHECK(drawn.views.front().box.contains(box_of(length, drawn)->min));
                CHECK(drawn.views.front().box.contains(box_of(length, drawn)->max));
            }
            CHECK(std::ranges::count(drawn.texts, std::string("EI"), &WrittenText::text) == 3);
        }
}

namespace {

/// The sizes of type in which words stand in a picture.
std::vector<double> sizes_of(const std::string& words, const ui::Painter& painter)
{
    std::vector<double> sizes;
    std::istringstream lines(ui::golden_text(painter.picture())); // (120.0, 46.5) center 13 "0.360"
    for (std::string line, word; std::getline(lines, line);) {
        if (!line.ends_with('"' + words + '"')) continue;
        std::istringstream in(line);
        in >> word >> word >> word >> sizes.emplace_back();
    }
    return sizes;
}

} // namespace

TEST_CASE("The numbers of a beam's sheet grow with the wheel, on the projector too")
{
    const auto size_of_factor = [](const Zoom& zoom) {
        const Document document = starting_document();
        const Solution solution = solve(document);
        const Look look{.theme = ui::ThemeName::Projector, .zoom = zoom};
        const ui::Fonts fonts;
        ui::Painter painter({1280.0, 690.0}, fonts);
        draw(painter, {document, solution, nullptr, 1.0, {}, look});
        const std::vector<double> sizes = sizes_of("0.360", painter);
        return sizes.empty() ? 0.0 : sizes.front();
    };
    REQUIRE(size_of_factor({}) > 0.0);
    CHECK(size_of_factor({.factor = 2.0}) > 1.7 * size_of_factor({}));
}

namespace {

struct Enlarged {
    double zoom = 0.0, type = 0.0;
    std::size_t n_without_room = 0;
};

/// A sheet as it is shown in so much room.
Enlarged enlarged(const Document& document, ui::Size size, ui::ThemeName theme)
{
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    ui::Painter painter(size, fonts);
    Look look{.theme = theme};
    const Scene scene{document, solution, nullptr, 1.0, {}, look};
    look.zoom = {.factor = legible_zoom(painter, scene), .middle = {}, .is_of_sheet = true};
    const Drawn drawn = draw(painter, scene);
    return {look.zoom.factor, drawn.sheet_type, drawn.n_without_room};
}

/// A sheet of a file as the projector shows it.
Enlarged enlarged_for_last_row(const std::string& path, ui::Size size)
{
    return enlarged(read_document_file(path), size, ui::ThemeName::Projector);
}

} // namespace

TEST_CASE("In a small window every column of a beam has room, without the sheet being enlarged")
{
    for (const ui::Size size : {ui::Size{657.0, 724.0}, ui::Size{443.0, 525.0}, ui::Size{303.0, 525.0}}) {
        CAPTURE(size.width);
        const Enlarged sheet = enlarged(starting_document(), size, ui::ThemeName::Light);
        CHECK(sheet.n_without_room == 0);
        CHECK(sheet.zoom == 1.0);
    }
}

TEST_CASE("On the projector no number of a sheet is smaller than the panels' text, and every column has room")
{
    const double panels = ui::Theme(ui::ThemeName::Projector).type().normal;
    const ui::Size between_panels{632.0, 694.0}, whole_window{1280.0, 694.0};
    for (const char* const path :
         {"tests/cases/own/staged-two-storeys.json", "tests/cases/own/staged-listed.json",
          "tests/cases/own/staged-gable.json", "examples/portal.json", "examples/three_spans.json"})
        for (const ui::Size size : {between_panels, whole_window}) {
            CAPTURE(path);
            CAPTURE(size.width);
            const Enlarged sheet = enlarged_for_last_row(path, size);
            CHECK(sheet.type >= panels);
            CHECK(sheet.n_without_room == 0);
        }
}

namespace {

/// Overhangs of 1.5 m and 2 m beside the spans of a beam that is pinned at its left end.
Document with_two_overhangs()
{
    Document document = read_document_file("examples/three_spans.json");
    femoop::Model& model = document.model;
    model.nodes[0].at[0] = femoop::Quantity(6.5);
    model.nodes[0].support.reset();
    model.nodes[1].support->kind = femoop::SupportKind::Pin;
    model.nodes[3].support->kind = femoop::SupportKind::Roller;
    femoop::Node end{.id = "E"};
    end.at = {22.0, 0.0, 0.0};
    femoop::Member overhang = model.members[2];
    overhang.id = "DE";
    overhang.nodes = {femoop::NodeId(3), model.add(std::move(end))};
    femoop::MemberLoad load = model.load_cases.front().members[0];
    load.member = model.add(std::move(overhang));
    model.load_cases.front().members.push_back(std::move(load));
    return document;
}

} // namespace

TEST_CASE(
    "Between the projector's panels a beam with two overhangs and a frame of two storeys have all columns in sight")
{
    const double panels = ui::Theme(ui::ThemeName::Projector).type().normal;
    for (const Document& document : {with_two_overhangs(), read_document_file("tests/cases/own/staged-listed.json"),
                                     read_document_file("tests/cases/own/staged-two-storeys.json")}) {
        CAPTURE(document.model.title);
        const Enlarged sheet = enlarged(document, {622.0, 690.0}, ui::ThemeName::Projector);
        CHECK(sheet.zoom == 1.0);
        CHECK(sheet.type >= panels);
        CHECK(sheet.n_without_room == 0);
    }
}

TEST_CASE("Between the panels of a projector the values over a beam's sheet are as large as the panels' text")
{
    const double panels = ui::Theme(ui::ThemeName::Projector).type().normal;
    const Look look{.theme = ui::ThemeName::Projector};
    for (const Document& document : {starting_document(), with_two_overhangs()})
        for (const ui::Size size : {ui::Size{433.0, 490.0}, ui::Size{622.0, 690.0}, ui::Size{1262.0, 970.0}}) {
            CAPTURE(size.width);
            const Solution solution = solve(document);
            const ui::Fonts fonts;
            ui::Painter painter(size, fonts);
            draw(painter, {document, solution, nullptr, 1.0, {}, look});
            const std::vector<double> sizes = sizes_of("38 kN/m", painter);
            REQUIRE(sizes.size() == 1);
            CHECK(sizes.front() >= panels);
        }
}

TEST_CASE("The largest moment of a swaying portal is written in its diagram and on its sheet, in every window")
{
    Document document = portal("W");
    Solution solution = solve(document);
    document.stage = 2;
    work(solution, document);
    const auto state = fc::state_results(document.model, solution.task->problem,
                                         present_locks(document, solution, 1.0));
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
        for (const ui::Size size : {ui::Size{657.0, 724.0}, ui::Size{1280.0, 694.0}, ui::Size{1285.0, 1005.0}}) {
            CAPTURE(size.width);
            const Look look{.theme = theme};
            ui::Painter painter(size, fonts);
            draw(painter, {document, solution, &state, 1.0, {}, look});
            CHECK(sizes_of("32.59", painter).size() == 2);
        }
}

TEST_CASE("A short column keeps the fixed-end moment, and tells what is gone beside the number after it")
{
    const Document document = [] {
        Document worked = with_two_overhangs();
        Solution solution = solve(worked);
        take_turns(worked, solution, 4);
        return worked;
    }();
    const Solution solution = solve(document);
    const Look look{.theme = ui::ThemeName::Projector};
    const ui::Fonts fonts;
    ui::Painter painter({622.0, 690.0}, fonts);
    draw(painter, {document, solution, nullptr, 1.0, {}, look});
    const Numbers numbers(document, solution, look);
    const fc::Problem& problem = solution.task->problem;
    for (std::size_t e = 0; e < problem.ends.size(); ++e)
        CHECK_FALSE(sizes_of(numbers.moment(problem.ends[e], problem.loading.fixed_end[e]), painter).empty());
    CHECK_FALSE(sizes_of("⋮", painter).empty());
}

TEST_CASE("On a small projector every column of a beam has room, in type as large as its height allows")
{
    for (const ui::Size size : {ui::Size{900.0, 494.0}, ui::Size{432.0, 494.0}, ui::Size{1280.0, 500.0}}) {
        CAPTURE(size.width);
        const Enlarged sheet = enlarged_for_last_row("examples/three_spans.json", size);
        CHECK(sheet.type >= 13.5);
        CHECK(sheet.n_without_room == 0);
    }
}

TEST_CASE("Between the panels of a small projector a beam's numbers are as large as the panels' text, its values whole")
{
    const Document document = read_document_file("examples/three_spans.json");
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    for (const ui::Size size : {ui::Size{432.0, 494.0}, ui::Size{520.0, 494.0}, ui::Size{632.0, 494.0}}) {
        CAPTURE(size.width);
        CHECK(enlarged_for_last_row("examples/three_spans.json", size).type >=
              ui::Theme(ui::ThemeName::Projector).type().normal);
        ui::Painter painter(size, fonts);
        const Look look{.theme = ui::ThemeName::Projector};
        const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look});
        for (const char* const load : {"8 kN/m", "38 kN/m", "28 kN/m"}) CHECK(box_of(load, drawn).has_value());
    }
}

TEST_CASE("The columns of a frame of six storeys stand below the heading of its sheet")
{
    const Document document = read_document_file("examples/storey_frame.json");
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector}) {
        Look look;
        look.theme = theme;
        ui::Painter painter({1280.0, 694.0}, fonts);
        draw(painter, {document, solution, nullptr, 1.0, {}, look});
        Strings strings(fonts);
        painter.picture().draw_on(strings);
        const auto heading = std::ranges::find_if(
            strings.all, [](const auto& string) { return string.words.starts_with("Sheet of the loads"); });
        REQUIRE(heading != strings.all.end());
        for (const Strings::String& string : strings.all) {
            CAPTURE(string.words);
            CHECK((string.words == heading->words || !string.box.overlaps(heading->box)));
        }
    }
}

TEST_CASE("In the whole window of a projector a frame of two storeys is seen whole")
{
    CHECK(enlarged_for_last_row("tests/cases/own/staged-two-storeys.json", {1280.0, 694.0}).zoom == 1.0);
}

namespace {

/// Where the heads of arrows are.
class ArrowHeads : public ui::Surface {
public:
    void clip(const ui::Box& /*box*/) override {}
    void stroke(const ui::Path& /*path*/, const ui::Stroke& /*stroke*/) override {}
    void fill(std::span<const ui::Point> polygon, ui::Color /*color*/) override
    {
        for (const ui::Point& at : polygon)
            if (polygon.size() == 3) uppermost = std::min(uppermost, at.y);
    }
    void stroke_arc(const ui::Arc& /*arc*/, const ui::Stroke& /*stroke*/) override {}
    void fill_disc(ui::Point /*center*/, double /*radius*/, ui::Color /*color*/) override {}
    void text(ui::Point /*at*/, std::string_view /*utf8*/, const ui::TextStyle& /*style*/) override {}

    double uppermost = 1e9;
};

} // namespace

TEST_CASE("A carry-over whose balance has left its full column has no arrow, which would come from nowhere")
{
    Document document = read_document_file("tests/cases/own/staged-two-storeys.json");
    Solution solution = solve(document);
    take_turns(document, solution, 7);
    const ui::Fonts fonts;
    ui::Painter painter({1280.0, 694.0}, fonts);
    const Look look{.theme = ui::ThemeName::Projector};
    draw(painter, {document, solution, nullptr, 1.0, {}, look});
    ArrowHeads heads;
    painter.picture().draw_on(heads);
    CHECK(heads.uppermost > 20.0);
}

namespace {

const std::string stepped_frame = "tests/scenarios/cross/stepped_frame.json";

/// Strings that an arrow runs through, with no ground of their own over it.
class StruckStrings : public Strings {
public:
    StruckStrings(const ui::Fonts& fonts, const ui::Theme& theme)
        : Strings(fonts), arrow_(theme.stroke(ui::Role::Created).color), ground_(theme.background())
    {}

    void stroke(const ui::Path& path, const ui::Stroke& stroke) override
    {
        if (stroke.color != arrow_ || path.points.size() != 2) return;
        arrows_.emplace_back(path.points[0], path.points[1]);
        grounds_.clear();
    }
    void fill(std::span<const ui::Point> polygon, ui::Color color) override
    {
        ui::Box box{polygon.front(), polygon.front()};
        for (const ui::Point point : polygon) box = ui::united(box, {point, point});
        if (color == ground_) grounds_.push_back(box);
    }
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override
    {
        Strings::text(at, utf8, style);
        const ui::Box box = all.back().box;
        const ui::OrientedBox inside(box.center(), box.grown(-1.0).size());
        const auto strikes = [&](const auto& arrow) { return inside.meets_segment(arrow.first, arrow.second); };
        const auto covers = [&](const ui::Box& ground) { return ground.contains(box.center()); };
        if (std::ranges::any_of(arrows_, strikes) && std::ranges::none_of(grounds_, covers))
            struck.push_back(all.back());
    }

    std::size_t n_arrows() const { return arrows_.size(); }
    std::vector<String> struck;

private:
    ui::Color arrow_, ground_;
    std::vector<std::pair<ui::Point, ui::Point>> arrows_;
    std::vector<ui::Box> grounds_;
};

} // namespace

TEST_CASE("No arrow of what is carried over runs through a number")
{
    const ui::Fonts fonts;
    const Look look{.theme = ui::ThemeName::Projector};
    std::size_t n_arrows = 0;
    for (const std::string& file : {stepped_frame, std::string("tests/cases/own/staged-two-storeys.json")}) {
        Document document = read_document_file(file);
        Solution solution = solve(document);
        for (int turn = 1; turn <= 8 && next_turn(document, solution); ++turn) {
            take_turns(document, solution, 1);
            for (const ui::Size size : {ui::Size{450.0, 525.0}, ui::Size{640.0, 694.0}, ui::Size{1280.0, 694.0}}) {
                CAPTURE(turn);
                CAPTURE(size.width);
                ui::Painter painter(size, fonts);
                draw(painter, {document, solution, nullptr, 1.0, {}, look});
                StruckStrings strings(fonts, ui::Theme(look.theme));
                painter.picture().draw_on(strings);
                n_arrows += strings.n_arrows();
                for (const Strings::String& string : strings.struck) FAIL_CHECK(string.words);
            }
        }
    }
    CHECK(n_arrows > 0);
}

TEST_CASE("The note of columns without room stands on no name of a sum's lines")
{
    Document document = read_document_file(stepped_frame);
    Solution solution = solve(document);
    for (std::size_t stage = 0; stage < solution.task->n_sheets(); ++stage) {
        document.stage = stage;
        for (int turn = 0; turn < 40 && next_turn(document, solution); ++turn) take_turns(document, solution, 1);
    }
    document.stage = solution.task->n_sheets();
    const ui::Fonts fonts;
    bool has_note = false;
    for (double width = 420.0; width <= 480.0; width += 10.0) {
        CAPTURE(width);
        ui::Painter painter({width, 525.0}, fonts);
        draw(painter, {document, solution, nullptr, 1.0, {}, Look{}});
        Strings strings(fonts);
        painter.picture().draw_on(strings);
        const auto with = [&](std::string_view words) {
            std::vector<ui::Box> boxes;
            for (const Strings::String& string : strings.all)
                if (string.words.find(words) != std::string::npos) boxes.push_back(string.box);
            return boxes;
        };
        for (const std::string_view note : {"member ends without", "zoom in", "Table"})
            for (const ui::Box& box : with(note)) {
                has_note = true;
                for (const std::string_view name : {"loads", "sway at", "sum"})
                    for (const ui::Box& line : with(name)) CHECK_FALSE(line.overlaps(box));
            }
    }
    CHECK(has_note);
}

TEST_CASE("After all joints at once the shortest column shows the last balance and what was carried over to it")
{
    Document document = read_document_file("tests/cases/own/staged-two-storeys.json");
    document.method.order = fc::Order::AllAtOnce;
    Solution solution = solve(document);
    take_turns(document, solution, 3);
    const Look look{.theme = ui::ThemeName::Projector};
    const ui::Fonts fonts;
    ui::Painter painter({1280.0, 694.0}, fonts);
    draw(painter, {document, solution, nullptr, 1.0, {}, look});
    const std::string drawn = ui::golden_text(painter.picture());
    const Numbers numbers(document, solution, look);
    const fc::Sheet& sheet = *solution.sheet(document);
    for (const auto& changes : {sheet.balanced(sheet.steps.back()), sheet.carried_over(sheet.steps.back())})
        for (const fc::Change& change : changes) {
            const std::string text = numbers.moment(solution.task->problem[change.end], change.value);
            CAPTURE(text);
            CHECK(drawn.find('"' + text + '"') != std::string::npos);
        }
}

TEST_CASE("In a narrow picture the forces of two props are written at its foot, named by their nodes")
{
    const Document document = read_document_file("tests/cases/own/staged-two-storeys.json");
    const Solution solution = solve(document);
    const auto state = fc::state_results(document.model, solution.task->problem,
                                         present_locks(document, solution, 1.0));
    const ui::Fonts fonts;
    const auto drawn_at = [&](ui::Size size) {
        ui::Painter painter(size, fonts);
        draw(painter, {document, solution, &state, 1.0, {}, {}});
        return ui::golden_text(painter.picture());
    };
    for (const std::string force : {"C  −17.5 kN", "E  −12.5 kN"}) {
        CAPTURE(force);
        CHECK(drawn_at({443.0, 525.0}).find(force) != std::string::npos);
        CHECK(drawn_at({1280.0, 700.0}).find(force) == std::string::npos);
    }
}

TEST_CASE("Why a mechanism has no deformed shape is written below the heading, however narrow the picture")
{
    Document document = starting_document();
    for (femoop::Node& node : document.model.nodes)
        if (node.support) node.support->kind = femoop::SupportKind::Roller;
    const Solution solution = solve(document);
    REQUIRE(solution.task);
    REQUIRE_FALSE(solution.task->remarks.empty());
    const ui::Fonts fonts;
    for (const double width : {300.0, 432.0, 1000.0}) {
        CAPTURE(width);
        ui::Painter painter({width, 694.0}, fonts);
        draw(painter, {document, solution, nullptr, 1.0, {}, Look{}});
        Strings strings(fonts);
        painter.picture().draw_on(strings);
        for (const Strings::String& heading : strings.all)
            for (const Strings::String& string : strings.all)
                if (&heading != &string && heading.box.min.x == string.box.min.x)
                    CHECK_FALSE(heading.box.grown(-1.0).overlaps(string.box.grown(-1.0)));
    }
}

TEST_CASE("In fractions factors and moments are exact")
{
    Look look;
    look.fractions = true;
    check("cross_fractions", starting_document(), {.n_turns = 2, .look = look});
}

TEST_CASE("Shears and reactions of a state with locked joints stand where the moments were")
{
    Look look;
    look.shears = true;
    check("cross_shears", starting_document(), {.n_turns = 2, .look = look});
}

TEST_CASE("By the tension side both ends of a joint have one sign")
{
    Look look;
    look.signs = Signs::TensionSide;
    look.theme = ui::ThemeName::Dark;
    check("cross_tension_side", starting_document(), {.n_turns = 5, .look = look});
}

TEST_CASE("What cannot be distributed is said in place of the pictures")
{
    check("cross_refused", example("grillage"), {});
}

TEST_SUITE_END();
