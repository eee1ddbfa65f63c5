#include "apps/frame/view/pick.h"

#include "apps/frame/view/results/diagram.h"
#include "apps/frame/view/sheet/subject.h"
#include "apps/frame/view/sketch/scene.h"
#include "apps/frame/view/sketch/symbols.h"

#include <algorithm>
#include <cmath>

namespace frame {

namespace {

using femoop::MemberComponent;

/// A line of the reading: "M", "12.5 kN·m", in the colour of its diagram.
struct Line {
    std::string name;
    std::string value;
    ui::Role role;
};

std::string printed(const ui::DisplayUnits& units, double value, ui::Measure measure)
{
    const std::string text = units.text(value, measure);
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::vector<Line> lines(const femoop::Model& model, const ui::DisplayUnits& units, const femoop::Curve& curve,
                        const MemberPlace& place)
{
    std::vector<Line> list{{"x", printed(units, place.x, ui::Measure::Length), ui::Role::Label}};
    for (const MemberComponent component : femoop::all_member_components) {
        const std::string name(femoop::name(component, model.analysis));
        if (name.empty()) continue;
        const bool is_displacement = component >= MemberComponent::u;
        list.push_back({name, printed(units, curve.value(component, place.x), measure_of(component)),
                        is_displacement ? ui::Role::Deformed : role_of(component)});
    }
    return list;
}

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
        frame::draw(sketch_, {.tail = frame_(pulls ? a : b, 0.0),
                              .head = frame_(pulls ? b : a, 0.0),
                              .role = ui::Role::AxialForce,
                              .stroke = sketch_.thin(ui::Role::AxialForce)});
    }

    // Positive along -y' on this face.
    void draw_shear() const
    {
        if (!is_there(forces_.Vy)) return;
        const double h = forces_.Vy > 0.0 ? sketch_.px(15.0) : -sketch_.px(15.0);
        frame::draw(sketch_, {.tail = frame_(sketch_.px(4.0), h),
                              .head = frame_(sketch_.px(4.0), -h),
                              .role = ui::Role::ShearForce,
                              .stroke = sketch_.thin(ui::Role::ShearForce)});
    }

    // Positive counter-clockwise on this face: it stretches the -y' fibre.
    void draw_moment() const
    {
        if (!is_there(forces_.Mz)) return;
        frame::draw(sketch_, CurvedArrow{.frame = frame_.moved(sketch_.px(4.0), 0.0),
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

/// A box beside the cursor with a sketch at its left and lines of text at its right.
class ReadingBox {
public:
    ReadingBox(ui::Painter& painter, const ui::Theme& theme, std::string title, std::vector<Line> lines)
        : painter_(painter), theme_(theme), title_(std::move(title)), lines_(std::move(lines))
    {
        sketch_width_ = 114.0 * theme.symbol_scale();
        for (const Line& line : lines_) {
            name_width_ = std::max(name_width_, painter.measure(line.name, style(line)).width);
            value_width_ = std::max(value_width_, painter.measure(line.value, style(line)).width);
        }
        const double text_width = name_width_ + 12.0 + value_width_;
        const double title_width = painter.measure(title_, title_style()).width;
        size_ = {std::max(sketch_width_ + text_width, title_width) + 20.0,
                 16.0 + step() * static_cast<double>(lines_.size() + 1)};
    }

    void draw(ui::Point cursor, const femoop::SectionForces& forces) const
    {
        const ui::Box box = placed(cursor);
        painter_.rectangle(box.grown(1.0), theme_.stroke(ui::Role::Dimension).color);
        painter_.rectangle(box, theme_.background());
        ui::Point at = box.min + ui::Point{10.0, 8.0 + 0.5 * step()};
        painter_.text(at, title_, title_style());
        const double left = box.max.x - 10.0 - value_width_ - 12.0 - name_width_;
        for (const Line& line : lines_) {
            at.y += step();
            painter_.text({left, at.y}, line.name, style(line));
            ui::TextStyle right = style(line);
            right.anchor = ui::Anchor::Right;
            painter_.text({box.max.x - 10.0, at.y}, line.value, right);
        }
        Sketch sketch({.painter = &painter_, .theme = &theme_, .room = painter_.sheet()});
        const ui::Point face{box.min.x + 0.5 * sketch_width_, box.min.y + 0.5 * (size_.height + step())};
        CutMember(sketch, face, forces, 1e-6 * largest(forces)).draw();
    }

private:
    double step() const { return 1.45 * theme_.type().normal; }
    ui::TextStyle style(const Line& line) const { return theme_.text(line.role, ui::Anchor::Left); }
    ui::TextStyle title_style() const
    {
        ui::TextStyle style = theme_.text(ui::Role::Label, ui::Anchor::Left);
        style.weight = ui::Weight::Bold;
        return style;
    }

    // Right below the cursor, or on its other side where the sheet ends.
    ui::Box placed(ui::Point cursor) const
    {
        const ui::Box sheet = painter_.sheet();
        ui::Point corner = cursor + ui::Point{18.0, 18.0};
        if (corner.x + size_.width > sheet.max.x - 4.0) corner.x = cursor.x - 18.0 - size_.width;
        if (corner.y + size_.height > sheet.max.y - 4.0) corner.y = cursor.y - 18.0 - size_.height;
        corner = {std::max(4.0, corner.x), std::max(4.0, corner.y)};
        return ui::box_at(corner, size_);
    }

    ui::Painter& painter_;
    const ui::Theme& theme_;
    std::string title_;
    std::vector<Line> lines_;
    double sketch_width_ = 0.0;
    double name_width_ = 0.0;
    double value_width_ = 0.0;
    ui::Size size_{};
};

} // namespace

void draw_reading(ui::Painter& painter, const femoop::Model& model, const femoop::Results& results,
                  const ViewOptions& options, const MemberPlace& place, ui::Point cursor)
{
    const bool is_there = place.member.index < model.members.size() && options.load_case.index < results.n_cases();
    if (!is_there || results.n_members() != model.members.size()) return;
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const ui::Theme theme(options.theme);
    const Subject subject(model, &results, options);
    const Subject::Plan plan = subject.plan(painter.size(), painter.fonts());
    const MemberShape& member = subject.shape()[place.member];
    for (const Panel& panel : plan.panels) {
        const Projection projection(plan.camera, panel.box.min);
        const ui::Point at = projection(member.at(place.x));
        const ui::Point across = ui::left_normal(ui::direction(projection.direction(member.x())));
        const double half = 10.0 * theme.symbol_scale();
        painter.line(at - half * across, at + half * across, theme.stroke(ui::Role::Selection));
    }
    const femoop::Curve curve = results[options.load_case].curve(place.member);
    const double x = std::clamp(place.x, 0.0, curve.length());
    const std::string title = options.tr("member {member}", {{"member", model[place.member].id}});
    ReadingBox(painter, theme, title, lines(model, display_units(model, options), curve, {place.member, x}))
        .draw(cursor, curve.forces(x));
}

} // namespace frame
