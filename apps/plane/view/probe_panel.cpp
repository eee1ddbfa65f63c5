#include "apps/plane/view/probe_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

using ui::Point;
using ui::Role;

constexpr double probe_border = 12.0;  // [px]
constexpr double em_of_table = 21.0;   // how wide the table's type makes it
constexpr double line_height = 1.38;   // [em]
constexpr double least_circle = 120.0; // [px]

/// The table of a probe, and the circle in what it leaves of the panel.
class ProbePanelPicture {
public:
    ProbePanelPicture(ui::Painter& painter, const ProbePanel& panel, const PlateOptions& options,
                      const ui::DisplayUnits& units, const ui::Box& box)
        : painter_(painter),
          panel_(panel),
          options_(options),
          units_(units),
          theme_(options.theme),
          box_({box.min + Point{probe_border, 8.0}, box.max - Point{probe_border, 8.0}}),
          y_(box_.min.y)
    {
        style_ = theme_.text(Role::Label, ui::Anchor::TopLeft);
        style_.size = std::min(theme_.type().small, box_.width() / em_of_table);
    }

    void draw(const std::optional<mohr::Frame>& frame)
    {
        write_title();
        if (!panel_.has_results) return write_note(options_.tr("no results to be read here"));
        if (!panel_.state) return write_note(options_.tr("there is no material at this place"));
        write_head();
        for (const ProbeValue& value : panel_.state->values) write_row(value);
        write_notes();
        const ui::Box room{{box_.min.x, y_ + 0.8 * style_.size}, box_.max};
        if (room.height() < least_circle || room.width() < least_circle) return;
        const mohr::StressPoint point = stress_point(*panel_.state, units_);
        mohr::draw_stress_circle(painter_, point, look(), frame.value_or(mohr::frame_of(point)), room);
    }

private:
    /// Of the circle: small enough that its words have room.
    mohr::Look look() const
    {
        mohr::Look look;
        look.theme = options_.theme;
        look.tr = options_.tr;
        look.pole = false;
        look.size = std::clamp(style_.size / theme_.type().normal, 0.5, 1.0);
        return look;
    }

    /// Where a column ends: smoothed, of elements, jump.
    double column(std::size_t i) const
    {
        constexpr std::array ends{0.50, 0.76, 1.0};
        return box_.min.x + ends.at(i) * box_.width();
    }
    void write(double x, const std::string& text, const ui::TextStyle& style) { painter_.text({x, y_}, text, style); }
    void write_right(std::size_t at_column, const std::string& text, ui::TextStyle style)
    {
        style.anchor = ui::Anchor::TopRight;
        write(column(at_column), text, style);
    }
    ui::TextStyle faint() const
    {
        ui::TextStyle style = style_;
        style.color = theme_[Role::FaintLabel].text;
        return style;
    }

    void write_title()
    {
        ui::TextStyle title = style_;
        title.weight = ui::Weight::Bold;
        title.size = std::min(theme_.type().normal, 1.2 * style_.size);
        write(box_.min.x,
              options_.tr("Probe {n}", {{"n", std::to_string(panel_.n)}}) + "  " +
                  units_.place(panel_.at.x(), panel_.at.y()) + " " + units_.unit(ui::Measure::Length).name,
              title);
        y_ += 1.7 * title.size;
    }

    void write_note(const std::string& text)
    {
        for (const std::string& line : ui::wrapped_lines(painter_.fonts(), text, faint(), box_.width())) {
            write(box_.min.x, line, faint());
            y_ += line_height * style_.size;
        }
    }

    void write_head()
    {
        write_right(0, options_.tr("smoothed"), faint());
        write_right(1, options_.tr("elements"), faint());
        if (panel_.state->n_elements > 1) write_right(2, options_.tr("jump"), faint());
        y_ += line_height * style_.size;
        painter_.line({box_.min.x, y_}, {box_.max.x, y_},
                      {.color = theme_.stroke(Role::Dimension).color, .width = 0.8});
        y_ += 0.3 * style_.size;
    }

    void write_row(const ProbeValue& value)
    {
        const auto number = [&](double v) { return number_of(v, value.measure, units_); };
        write(box_.min.x, value.symbol, style_);
        write_right(0, number(value.smoothed), style_);
        if (value.element) write_right(1, number(*value.element), style_);
        if (value.jump) write_right(2, number(*value.jump), style_);
        y_ += line_height * style_.size;
    }

    void write_beyond()
    {
        const ProbeState& state = *panel_.state;
        if (state.beyond.empty()) return;
        write_note(options_.tr("on the border of regions: above is {region}", {{"region", state.region}}));
        for (const ProbeState::Beyond& beyond : state.beyond) write_note(text_of(beyond, units_));
    }

    void write_notes()
    {
        y_ += 0.3 * style_.size;
        write_beyond();
        const std::string stress = units_.unit(ui::Measure::Stress).name,
                          length = units_.unit(ui::Measure::Displacement).name;
        write_note(options_.tr("u [{length}], σ and τ [{stress}], θ1 [°] from x to σ1",
                               {{"length", length}, {"stress", stress}}));
        if (panel_.state->n_elements > 1)
            write_note(options_.tr("jump between the {n} elements that meet here",
                                   {{"n", std::to_string(panel_.state->n_elements)}}));
    }

    ui::Painter& painter_;
    const ProbePanel& panel_;
    const PlateOptions& options_;
    const ui::DisplayUnits& units_;
    ui::Theme theme_;
    ui::Box box_;
    ui::TextStyle style_;
    double y_;
};

} // namespace

double probe_panel_width(const ui::Theme& theme, double sheet_width)
{
    const double wanted = 24.0 * theme.type().small + 2.0 * probe_border;
    return std::min(std::max(wanted, 0.32 * sheet_width), 0.40 * sheet_width);
}

void draw_probe_panel(ui::Painter& painter, const ProbePanel& panel, const PlateOptions& options,
                      const ui::DisplayUnits& units, const std::optional<mohr::Frame>& frame, const ui::Box& box)
{
    const ui::ClipScope clip(painter, box);
    const ui::Theme theme(options.theme);
    painter.line(box.min, {box.min.x, box.max.y}, {.color = theme.stroke(Role::Dimension).color, .width = 0.8});
    ProbePanelPicture(painter, panel, options, units, box).draw(frame);
}

} // namespace plane
