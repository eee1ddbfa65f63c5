#include "apps/drawing/reading.h"

#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/sketch/symbols.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"
#include "ui/paint/label/oriented_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

namespace drawing {

namespace {

using femoop::MemberComponent;

/// The part of the member before the section, with what acts on its cut face.
class CutMember {
public:
    CutMember(Sketch& sketch, ui::Point middle_of_face, const femoop::SectionForces& forces, double noise)
        : sketch_(sketch), frame_{.origin = middle_of_face}, forces_(forces), noise_(noise)
    {}

    void draw() const
    {
        draw_stub();
        draw_axial();
        draw_shear();
        draw_moment();
    }

private:
    void draw_stub() const
    {
        const double length = sketch_.px(44.0);
        const double h = sketch_.px(11.0);
        const std::vector<ui::Point> block{frame_(-length, h), frame_(0.0, h), frame_(0.0, -h), frame_(-length, -h)};
        sketch_.polygon(block, sketch_.theme().fill(ui::Role::Support));
        sketch_.polyline(block, sketch_.thin(ui::Role::Member), Clearance::None);
    }

    bool is_there(double value) const { return std::abs(value) > noise_; }

    void draw_axial() const
    {
        if (!is_there(forces_.N)) return;
        const double a = sketch_.px(12.0);
        const double b = sketch_.px(40.0);
        const bool pulls = forces_.N > 0.0;
        drawing::draw(sketch_, {.tail = frame_(pulls ? a : b, 0.0),
                                .head = frame_(pulls ? b : a, 0.0),
                                .role = ui::Role::AxialForce,
                                .stroke = sketch_.thin(ui::Role::AxialForce)});
    }

    // Positive along -y' on this face.
    void draw_shear() const
    {
        if (!is_there(forces_.Vy)) return;
        const double h = forces_.Vy > 0.0 ? sketch_.px(15.0) : -sketch_.px(15.0);
        drawing::draw(sketch_, {.tail = frame_(sketch_.px(4.0), h),
                                .head = frame_(sketch_.px(4.0), -h),
                                .role = ui::Role::ShearForce,
                                .stroke = sketch_.thin(ui::Role::ShearForce)});
    }

    // Positive counter-clockwise on this face: it stretches the -y' fibre.
    void draw_moment() const
    {
        if (!is_there(forces_.Mz)) return;
        drawing::draw(sketch_, CurvedArrow{.frame = frame_.moved(sketch_.px(4.0), 0.0),
                                           .radius = 22.0,
                                           .sense = forces_.Mz,
                                           .role = ui::Role::BendingMoment,
                                           .start = -0.42 * std::numbers::pi,
                                           .sweep = 0.84 * std::numbers::pi});
    }

    Sketch& sketch_;
    SymbolFrame frame_;
    femoop::SectionForces forces_;
    double noise_;
};

double largest(const femoop::SectionForces& f)
{
    return std::max({std::abs(f.N), std::abs(f.Vy), std::abs(f.Vz), std::abs(f.T), std::abs(f.My), std::abs(f.Mz)});
}

ui::Point nearest(const ui::Box& box, ui::Point p)
{
    return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

// Diagonals first: straight above and below stand loads and diagrams.
constexpr std::array<ui::Point, 8> sides{
    {{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};

/// The straight line from a to b, with a gap at every string of the picture that it meets.
void draw_between_strings(ui::Painter& painter, ui::Point a, ui::Point b, const ui::Stroke& stroke)
{
    std::vector<ui::OrientedBox> met;
    for (const ui::Box& string : painter.picture().text_boxes(painter.fonts())) {
        const ui::OrientedBox words(string.center(), string.grown(1.0 + 0.5 * stroke.width).size());
        if (words.meets_segment(a, b)) met.push_back(words);
    }
    const int n = static_cast<int>(std::ceil(ui::distance(a, b))); // pixels
    const auto at = [&](int i) { return a + static_cast<double>(i) / n * (b - a); };
    const auto is_free = [&](int i) {
        return std::none_of(met.begin(), met.end(),
                            [&](const ui::OrientedBox& words) { return words.meets_segment(at(i), at(i + 1)); });
    };
    for (int i = 0; i < n; ++i) {
        const int begin = i;
        while (i < n && is_free(i)) ++i;
        if (i > begin) painter.line(at(begin), at(i), stroke);
    }
}

/// A box beside the cursor with a sketch at its left and lines of text at its right.
class ReadingBox {
public:
    enum class Side : std::uint8_t { Free, Sketch }; ///< what stands at the left hand of the lines

    ReadingBox(ui::Painter& painter, const ui::Theme& theme, std::string title, std::vector<ReadingLine> lines,
               Side left, double top)
        : painter_(painter),
          theme_(theme),
          title_(std::move(title)),
          lines_(std::move(lines)),
          room_{{0.0, top}, painter.sheet().max}
    {
        if (left == Side::Sketch) sketch_width_ = 114.0 * theme.symbol_scale();
        for (const ReadingLine& line : lines_) {
            name_width_ = std::max(name_width_, painter.measure(line.name, style(line)).width);
            value_width_ = std::max(value_width_, painter.measure(line.value, style(line)).width);
        }
        const double text_width = name_width_ + 12.0 + value_width_;
        const double title_width = painter.measure(title_, title_style()).width;
        size_ = {std::max(sketch_width_ + text_width, title_width) + 20.0,
                 16.0 + step() * static_cast<double>(lines_.size() + 1)};
    }

    /// With the cut member where there are forces of one case.
    void draw(ui::Point beside, const std::optional<femoop::SectionForces>& forces) const
    {
        const ui::Box box = placed(beside);
        draw_leader(beside, box);
        painter_.rectangle(box.grown(1.0), theme_.stroke(ui::Role::Dimension).color);
        painter_.rectangle(box, theme_.background());
        ui::Point at = box.min + ui::Point{10.0, 8.0 + 0.5 * step()};
        painter_.text(at, title_, title_style());
        const double left = box.max.x - 10.0 - value_width_ - 12.0 - name_width_;
        for (const ReadingLine& line : lines_) {
            at.y += step();
            painter_.text({left, at.y}, line.name, style(line));
            ui::TextStyle right = style(line);
            right.anchor = ui::Anchor::Right;
            painter_.text({box.max.x - 10.0, at.y}, line.value, right);
        }
        if (!forces) return;
        Sketch sketch({.painter = &painter_, .theme = &theme_, .room = painter_.sheet()});
        const ui::Point face{box.min.x + 0.5 * sketch_width_, box.min.y + 0.5 * (size_.height + step())};
        CutMember(sketch, face, *forces, 1e-6 * largest(*forces)).draw();
    }

private:
    double step() const { return 1.45 * theme_.type().normal; }
    ui::TextStyle style(const ReadingLine& line) const { return theme_.text(line.role, ui::Anchor::Left); }
    ui::TextStyle title_style() const
    {
        ui::TextStyle style = theme_.text(ui::Role::Label, ui::Anchor::Left);
        style.weight = ui::Weight::Bold;
        return style;
    }

    /// A place for the box, and how much it disturbs there.
    struct Trial {
        ui::Box box{};
        int harm = std::numeric_limits<int>::max();
    };
    static constexpr int covers_one = 1000; // a string, beside one that the leader crosses and that can still be read

    // Near or farther off, where it and its leader disturb the fewest strings; elsewhere where all these cover one.
    ui::Box placed(ui::Point beside) const
    {
        const std::vector<ui::Box> strings = painter_.picture().text_boxes(painter_.fonts());
        Trial best;
        const auto try_at = [&](ui::Point center) {
            const ui::Box box = on_sheet(center);
            if (const int harm = harm_of(box, beside, strings, best.harm); harm < best.harm) best = {box, harm};
        };
        for (const double away : {18.0, 50.0, 90.0, 140.0, 200.0, 270.0})
            for (const ui::Point side : sides)
                try_at(beside + ui::Point{side.x * (away + 0.5 * size_.width), side.y * (away + 0.5 * size_.height)});
        if (best.harm < covers_one) return best.box;
        for (const ui::Point place : places_from(beside)) {
            try_at(place);
            if (best.harm < covers_one) break;
        }
        return best.box;
    }

    // Counted up to what is too much already.
    static int harm_of(const ui::Box& box, ui::Point beside, const std::vector<ui::Box>& strings, int too_much)
    {
        int sum = box.contains(beside) ? 25 * covers_one : 0;
        for (const ui::Box& string : strings) {
            if (sum >= too_much) break;
            const ui::OrientedBox words(string.center(), string.size());
            if (string.overlaps(box.grown(4.0))) sum += covers_one;
            else if (words.meets_segment(beside, nearest(box, beside))) sum += 1;
        }
        return sum;
    }

    // All over the room, the nearest first.
    std::vector<ui::Point> places_from(ui::Point beside) const
    {
        constexpr double step = 24.0; // [px]
        std::vector<ui::Point> places;
        for (double x = room_.min.x; x <= room_.max.x; x += step)
            for (double y = room_.min.y; y <= room_.max.y; y += step) places.push_back({x, y});
        std::ranges::stable_sort(places, {}, [&](ui::Point place) { return ui::distance(place, beside); });
        return places;
    }

    ui::Box on_sheet(ui::Point center) const
    {
        const ui::Box room = room_.grown(-4.0);
        const ui::Point corner = center - 0.5 * ui::Point{size_.width, size_.height};
        return ui::box_at({std::max(room.min.x, std::min(corner.x, room.max.x - size_.width)),
                           std::max(room.min.y, std::min(corner.y, room.max.y - size_.height))},
                          size_);
    }

    void draw_leader(ui::Point beside, const ui::Box& box) const
    {
        const ui::Point end = nearest(box, beside);
        if (ui::distance(beside, end) > 40.0)
            draw_between_strings(painter_, beside, end, theme_.stroke(ui::Role::Leader));
    }

    ui::Painter& painter_;
    const ui::Theme& theme_;
    std::string title_;
    std::vector<ReadingLine> lines_;
    ui::Box room_; ///< that the card may cover
    double sketch_width_ = 0.0;
    double name_width_ = 0.0;
    double value_width_ = 0.0;
    ui::Size size_{};
};

bool has(const femoop::Model& model, const femoop::Results& results, const DrawOptions& options, const Cut& cut)
{
    return cut.member.index < model.members.size() && options.load_case.index < results.n_cases() &&
           results.n_members() == model.members.size() && results.n_nodes() == model.nodes.size();
}

ui::Role role_of_line(MemberComponent component)
{
    return femoop::is_displacement(component) ? ui::Role::Deformed : role_of(component);
}

// "M": "-12.5 (G) … 58.5 (U1) kN·m"
std::vector<ReadingLine> lines_of_envelope(const femoop::Model& model, const femoop::Results& results,
                                           const DrawOptions& options, const Cut& cut)
{
    const femoop::Envelope envelope(results, envelope_cases(model, options));
    const ui::DisplayUnits units = display_units(model, options);
    NumbersOfCases numbers(results, units);
    const auto words = [&](const femoop::Governing& bound, ui::Measure measure) {
        const std::string number = numbers[bound.load_case].number(bound.value, measure);
        return envelope.cases().size() == 1 ? number : governed(number, model.case_name(bound.load_case));
    };
    std::vector<ReadingLine> list{
        {"x", numbers[envelope.cases().front()].text(cut.x, ui::Measure::Length), ui::Role::Label}};
    for (const MemberComponent component : femoop::member_components(model.analysis)) {
        const ui::Measure measure = measure_of(component);
        const femoop::GoverningRange range = envelope.at(cut.member, component, cut.x);
        const std::string least = words(range.min, measure), most = words(range.max, measure);
        list.push_back({std::string(femoop::name(component, model.analysis)),
                        (least == most ? least : least + " … " + most) + " " + units.unit(measure).name,
                        role_of_line(component)});
    }
    return list;
}

std::vector<ReadingLine> lines_of_case(const femoop::Model& model, const femoop::CaseResult& result,
                                       const DrawOptions& options, const Cut& cut)
{
    const CaseNumbers numbers(result, display_units(model, options));
    const femoop::Curve curve = result.curve(cut.member);
    std::vector<ReadingLine> list{{"x", numbers.text(cut.x, ui::Measure::Length), ui::Role::Label}};
    for (const MemberComponent component : femoop::member_components(model.analysis))
        list.push_back({std::string(femoop::name(component, model.analysis)),
                        numbers.text(curve.value(component, cut.x), measure_of(component)), role_of_line(component)});
    return list;
}

Cut within(const femoop::Results& results, const Cut& cut)
{
    return {cut.member, std::clamp(cut.x, 0.0, results.geometry(cut.member).length)};
}

void mark_section(ui::Painter& painter, const femoop::Model& model, const ui::Theme& theme, const ReadingCard& card)
{
    const femoop::MemberGeometry member = femoop::geometry_of(model, model[card.cut.member]);
    const Eigen::Vector3d along = member.axes.row(0);
    for (const Panel& panel : card.plan.panels) {
        const Projection projection(card.plan.camera, panel.box.min);
        const ui::Point at = projection(member.at(card.cut.x));
        const ui::Point across = ui::left_normal(ui::direction(projection.direction(along)));
        const double half = 10.0 * theme.symbol_scale();
        draw_between_strings(painter, at - half * across, at + half * across, theme.stroke(ui::Role::Selection));
    }
}

} // namespace

std::vector<ReadingLine> reading(const femoop::Model& model, const femoop::Results& results, const DrawOptions& options,
                                 const Cut& cut)
{
    if (!has(model, results, options, cut)) return {};
    const Cut read = within(results, cut);
    return options.is_envelope ? lines_of_envelope(model, results, options, read)
                               : lines_of_case(model, results[options.load_case], options, read);
}

void draw_reading(ui::Painter& painter, const femoop::Model& model, const DrawOptions& options, const ReadingCard& card,
                  const std::vector<ReadingLine>& lines)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme(options.theme);
    mark_section(painter, model, theme, card);
    const std::string title = options.tr("member {member}", {{"member", model[card.cut.member].id}});
    ReadingBox(painter, theme, title, lines, ReadingBox::Side::Free, card.top).draw(card.beside, std::nullopt);
}

void draw_reading(ui::Painter& painter, const DrawInput& input, const DrawOptions& options, const ReadingCard& card)
{
    if (!input.results || !has(input.model, *input.results, options, card.cut)) return;
    const std::vector<ReadingLine> lines = reading(input.model, *input.results, options, card.cut);
    if (options.is_envelope) return draw_reading(painter, input.model, options, card, lines);
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme(options.theme);
    mark_section(painter, input.model, theme, card);
    const std::string title = options.tr("member {member}", {{"member", input.model[card.cut.member].id}});
    const ReadingBox box(painter, theme, title, lines, ReadingBox::Side::Sketch, card.top);
    const Cut read = within(*input.results, card.cut);
    box.draw(card.beside, (*input.results)[options.load_case].curve(read.member).forces(read.x));
}

} // namespace drawing
