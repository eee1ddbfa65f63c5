// Where words stand in the pictures of Mohr's circle: not on lines of others.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/mohr/document/edit.h"
#include "apps/mohr/view/scene.h"
#include "ui/paint/label/oriented_box.h"
#include "ui/paint/surface.h"

using namespace mohr;

namespace {

/// Of a line, seen within a box alone.
struct Segment {
    ui::Point a, b;
    ui::Box clip;

    bool runs_through(const ui::Box& box) const
    {
        const ui::Box seen = ui::intersection(box, clip);
        return !seen.is_empty() && ui::OrientedBox(seen.center(), seen.size()).meets_segment(a, b);
    }
    /// It is level, and comes from the left to about half of the box's height.
    bool is_minus_of(const ui::Box& box) const
    {
        const bool is_level = a.y == b.y && std::abs(a.y - box.center().y) < 0.3 * box.height();
        return is_level && std::min(a.x, b.x) < box.min.x - 1.0 && std::max(a.x, b.x) > box.min.x + 1.0;
    }
};
struct Word {
    std::string text;
    ui::Box box;
    bool has_ground;
};

/// The lines of a picture but for its grid and its leaders, and its words.
class LinesAndWords final : public ui::Surface {
public:
    LinesAndWords(const ui::Fonts& fonts, const ui::Theme& theme) : fonts_(fonts), theme_(theme) {}

    std::vector<Segment> lines;
    std::vector<Word> words;
    double height_of_curves = 0.0;
    ElementMap element{};

    void begin_layer(ui::Layer layer) override { layer_ = layer; }
    void clip(const ui::Box& box) override { clip_ = box; }
    void fill(std::span<const ui::Point>, ui::Color) override {}
    void fill_disc(ui::Point, double, ui::Color) override {}
    void stroke(const ui::Path& path, const ui::Stroke& stroke) override
    {
        if (layer_ == ui::Layer::Labels || stroke == theme_.stroke(ui::Role::Grid)) return;
        if (path.points.size() == n_of_curve) height_of_curves = std::max(height_of_curves, height(path.points));
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
            lines.push_back({path.points[i], path.points[i + 1], clip_});
        if (path.ends == ui::PathEnds::Closed) lines.push_back({path.points.back(), path.points.front(), clip_});
    }
    void stroke_arc(const ui::Arc& arc, const ui::Stroke&) override
    {
        constexpr int n = 200;
        for (int i = 0; i < n; ++i)
            lines.push_back(
                {arc.at(arc.start + arc.sweep * i / n), arc.at(arc.start + arc.sweep * (i + 1) / n), clip_});
    }
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override
    {
        words.push_back({std::string(utf8), ui::text_box(fonts_, at, utf8, style), style.plate.has_value()});
    }

private:
    static constexpr std::size_t n_of_curve = 91; ///< points: every two degrees
    static double height(std::span<const ui::Point> points)
    {
        const auto [low, high] = std::ranges::minmax_element(points, {}, &ui::Point::y);
        return high->y - low->y;
    }

    const ui::Fonts& fonts_;
    ui::Theme theme_;
    ui::Box clip_{};
    ui::Layer layer_ = ui::Layer::Lines;
};

struct Sheet {
    ui::Size size;
    ui::ThemeName theme;
    ui::Language language;
    bool both_rules = false;
};

const ui::Fonts& fonts()
{
    static const ui::Fonts all;
    return all;
}

LinesAndWords drawn(const Document& document, const Sheet& sheet, std::optional<Handle> hover = std::nullopt)
{
    Look look;
    look.theme = sheet.theme;
    look.tr = ui::Catalogue(sheet.language);
    look.both_rules = sheet.both_rules;
    const Solution solution = solve(document, look.rule);
    ui::OrbitCamera eye;
    eye.look(0.6, 0.45);
    ui::Painter painter(sheet.size, fonts());
    LinesAndWords found(fonts(), look.full_theme());
    found.element =
        draw(painter, {document, solution, look, fitting_frame(document, solution), eye, std::nullopt, hover}).element;
    painter.picture().draw_on(found);
    return found;
}

std::vector<std::string> on_a_line(const LinesAndWords& picture, bool has_ground)
{
    std::vector<std::string> found;
    for (const Word& word : picture.words) {
        const ui::Box inner = word.box.grown(-1.0);
        const auto runs_through = [&](const Segment& line) { return line.runs_through(inner); };
        const bool is_crossed = std::ranges::any_of(picture.lines, runs_through);
        if (is_crossed && word.has_ground == has_ground) found.push_back(word.text);
    }
    return found;
}

std::string listed(const std::vector<std::string>& words)
{
    std::string all;
    for (const std::string& word : words) all += "[" + word + "]";
    return all;
}

/// Every subject, without a criterion and with one.
std::vector<Document> documents()
{
    std::vector<Document> all;
    for (int i = 0; i <= static_cast<int>(Subject::Section); ++i) {
        Document document = textbook_state();
        document.subject = static_cast<Subject>(i);
        all.push_back(document);
        if (document.subject == Subject::Inertia) continue;
        document.criterion = femoop::mohr::Criterion::VonMises;
        all.push_back(document);
    }
    return all;
}

} // namespace

TEST_CASE("No words lie bare on a line")
{
    using enum ui::ThemeName;
    const std::vector<std::pair<ui::Size, ui::ThemeName>> sheets{
        {{1000.0, 720.0}, Light}, {{690.0, 540.0}, Light}, {{900.0, 540.0}, Projector}, {{1280.0, 740.0}, Projector}};
    for (const auto& sheet : sheets)
        for (const ui::Language language : {ui::Language::English, ui::Language::Portuguese})
            for (const Document& document : documents()) {
                CAPTURE(sheet.first.width);
                CAPTURE(ui::text(sheet.second));
                CAPTURE(static_cast<int>(language));
                CAPTURE(static_cast<int>(document.subject));
                CAPTURE(document.criterion.has_value());
                CHECK(listed(on_a_line(drawn(document, {sheet.first, sheet.second, language}), false)) == "");
            }
}

TEST_CASE("Where there is room no words but the numbers of an axis lie on a line at all")
{
    const auto is_number = [](const std::string& word) {
        return word.find_first_not_of("−0123456789.") == std::string::npos;
    };
    for (const Document& document : documents()) {
        if (document.criterion) continue; // its envelopes take the room
        CAPTURE(static_cast<int>(document.subject));
        const auto picture = drawn(document, {{1000.0, 720.0}, ui::ThemeName::Light, ui::Language::English});
        std::vector<std::string> words = on_a_line(picture, true);
        std::erase_if(words, is_number);
        CHECK(listed(words) == "");
    }
}

TEST_CASE("No axis ends as a minus sign before the words that lie on it")
{
    using enum ui::ThemeName;
    const std::vector<std::pair<ui::Size, ui::ThemeName>> sheets{
        {{725.0, 757.0}, Light}, {{1000.0, 720.0}, Light}, {{690.0, 540.0}, Light}, {{900.0, 540.0}, Projector}};
    for (const auto& sheet : sheets)
        for (const Document& document : documents()) {
            CAPTURE(sheet.first.width);
            CAPTURE(static_cast<int>(document.subject));
            CAPTURE(document.criterion.has_value());
            const auto picture = drawn(document, {sheet.first, sheet.second, ui::Language::English});
            for (const Word& word : picture.words) {
                CAPTURE(word.text);
                CHECK_FALSE(std::ranges::any_of(picture.lines,
                                                [&](const Segment& line) { return line.is_minus_of(word.box); }));
            }
        }
}

TEST_CASE("In a small window on the projector no number of the pictures is left out")
{
    const Document document = textbook_state(); // a plane stress
    const auto missing = [](const LinesAndWords& picture, std::string_view begin, std::ptrdiff_t n) {
        const auto begins = [&](const Word& word) { return word.text.starts_with(begin); };
        return std::ranges::count_if(picture.words, begins) < n ? std::string(begin) : std::string();
    };
    for (const ui::Language language : {ui::Language::English, ui::Language::Portuguese})
        for (const bool both_rules : {false, true}) {
            CAPTURE(static_cast<int>(language));
            CAPTURE(both_rules);
            const auto picture = drawn(document, {{900.0, 540.0}, ui::ThemeName::Projector, language, both_rules});
            for (const char* of_a_circle : {"X (", "Y (", "N (", "σ1 = ", "σ2 = ", "C = ", "R = "})
                CHECK(missing(picture, of_a_circle, both_rules ? 2 : 1) == "");
            for (const char* elsewhere : {"σx′ = ", "σy′ = ", "τx′y′ = ", "θ = "})
                CHECK(missing(picture, elsewhere, 1) == "");
        }
}

TEST_CASE("Beside the panels of a projector each normal stress stands at a face that it acts on")
{
    Document document = textbook_state();
    for (const double angle : {20.0, -55.0, 65.0}) {
        document.angle = angle;
        const auto picture = drawn(document, {{576.0, 742.0}, ui::ThemeName::Projector, ui::Language::Portuguese});
        const double turn = document.angle * std::numbers::pi / 180.0;
        const ui::Point x{std::cos(turn), -std::sin(turn)}, y{-std::sin(turn), -std::cos(turn)};
        for (const Word& word : picture.words) {
            const bool is_x = word.text.starts_with("σx′ = "), is_y = word.text.starts_with("σy′ = ");
            if (!is_x && !is_y) continue;
            const auto nearest = [&](ui::Point normal) {
                const auto distance = [&](double side) {
                    return ui::distance(word.box.center(),
                                        picture.element.middle + side * picture.element.half * normal);
                };
                return std::min(distance(1.0), distance(-1.0));
            };
            CAPTURE(word.text);
            CAPTURE(document.angle);
            CHECK((nearest(x) < nearest(y)) == is_x);
        }
    }
}

TEST_CASE("No words stand so near to an axis's title that they look like a part of it")
{
    Document document = textbook_state();
    document.state() = {"-100 MPa", "0 MPa", "0 MPa"}; // σ1 = 0 and Y lie where the title does
    for (const bool both_rules : {false, true}) {
        CAPTURE(both_rules);
        const auto picture = drawn(document, {{725.0, 757.0}, ui::ThemeName::Light, ui::Language::English, both_rules});
        for (const Word& title : picture.words) {
            if (title.text != "σ [MPa]") continue;
            const ui::Box around = title.box.grown(0.3 * title.box.height());
            for (const Word& word : picture.words) {
                CAPTURE(word.text);
                CHECK((&word == &title || !word.box.overlaps(around) || word.text.find('=') == std::string::npos));
            }
        }
    }
}

TEST_CASE("What lies under the pointer moves no words")
{
    Document document = textbook_state();
    for (const Subject subject : {Subject::PlaneStress, Subject::SpaceStress}) {
        document.subject = subject;
        const Sheet sheet{{1000.0, 720.0}, ui::ThemeName::Light, ui::Language::English};
        const auto rest = drawn(document, sheet);
        for (const Handle handle : {Handle::FaceX, Handle::Plane, Handle::First, Handle::Turn, Handle::Normal}) {
            const auto hovered = drawn(document, sheet, handle);
            REQUIRE(hovered.words.size() == rest.words.size());
            for (std::size_t i = 0; i < rest.words.size(); ++i) CHECK(hovered.words[i].box == rest.words[i].box);
        }
    }
}

TEST_CASE("The curves are not flat, on the projector in a small window too")
{
    const Document document = textbook_state();
    for (const ui::Size size : {ui::Size{900.0, 540.0}, ui::Size{1280.0, 740.0}, ui::Size{1024.0, 700.0}})
        for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector}) {
            CAPTURE(size.width);
            CAPTURE(ui::text(theme));
            const double line = ui::Theme(theme).type().normal;
            CHECK(drawn(document, {size, theme, ui::Language::English}).height_of_curves > 4.0 * line);
        }
}
