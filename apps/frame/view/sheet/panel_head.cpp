#include "apps/frame/view/sheet/panel_head.h"

#include "apps/frame/view/sheet/legend.h"

#include <algorithm>

namespace frame {

namespace {

// [px]
constexpr double left_border = 16.0;
constexpr double right_border = 6.0;
constexpr double gap = 14.0;    // between name, bar and note
constexpr double bar_gap = 6.0; // between the bar and its text

/// Lines that a head may take, by what names, bars and notes need in both languages.
std::size_t n_lines(const ui::Theme& theme, double panel_width)
{
    const double width = panel_width / theme.type().normal;
    if (width < 21.0) return 4;
    if (width < 26.0) return 3;
    return width < 38.0 ? 2 : 1;
}

ui::TextStyle small_text(const ui::Theme& theme, ui::Role role)
{
    ui::TextStyle style = theme.text(role, ui::Anchor::Left);
    style.size = theme.type().small;
    return style;
}

/// Writes the parts of one head one after another.
class HeadWriter {
public:
    HeadWriter(ui::Painter& painter, const ui::Theme& theme, const ui::Box& row)
        : painter_(painter),
          theme_(theme),
          row_(row),
          width_(row.width() - left_border - right_border),
          n_lines_(n_lines(theme, row.width()))
    {}

    void write_name(const PanelHead& head)
    {
        ui::TextStyle style = theme_.text(head.role, ui::Anchor::Left);
        style.weight = ui::Weight::Bold;
        write_lines(wrapped(painter_.fonts(), head.name, style, width_), style);
    }

    void write_bar(const PanelHead& head)
    {
        const ui::TextStyle style = small_text(theme_, head.role);
        const double width = head.bar + bar_gap + painter_.measure(head.bar_text, style).width;
        if (!find_room(width)) return;
        draw_bar(head, style);
        x_ += width + gap;
    }

    /// Below name and bar wherever the head has several lines.
    void write_note(const PanelHead& head)
    {
        const ui::TextStyle style = small_text(theme_, ui::Role::FaintLabel);
        const double room = n_lines_ == 1 ? width_ - x_ : width_;
        const std::vector<std::string> lines = wrapped(painter_.fonts(), head.note, style, room);
        const std::size_t first = n_lines_ == 1 ? 0 : line_ + 1;
        if (first + lines.size() > n_lines_ || !fit(lines, style, room)) return;
        if (n_lines_ > 1) next_line();
        write_lines(lines, style);
    }

private:
    ui::Point pen() const
    {
        const double normal = theme_.type().normal, small = theme_.type().small;
        const double y = line_ == 0 ? 0.8 * normal : 1.6 * normal + (1.4 * static_cast<double>(line_) - 0.8) * small;
        return row_.min + ui::Point{left_border + x_, y};
    }

    void next_line()
    {
        ++line_;
        x_ = 0.0;
    }

    /// Moves the pen to the next line where this one is full; false where that does not help.
    bool find_room(double width)
    {
        if (x_ + width <= width_) return true;
        if (width > width_ || line_ + 1 >= n_lines_) return false;
        next_line();
        return true;
    }

    bool fit(const std::vector<std::string>& lines, const ui::TextStyle& style, double room) const
    {
        return std::all_of(lines.begin(), lines.end(),
                           [&](const std::string& line) { return painter_.measure(line, style).width <= room; });
    }

    /// Leaves the pen behind the last line.
    void write_lines(const std::vector<std::string>& lines, const ui::TextStyle& style)
    {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (i > 0) next_line();
            painter_.text(pen(), lines[i], style);
        }
        if (!lines.empty()) x_ += painter_.measure(lines.back(), style).width + gap;
    }

    void draw_bar(const PanelHead& head, const ui::TextStyle& style)
    {
        const auto& look = theme_.stroke(head.role);
        const ui::Stroke stroke = {.color = look.color, .width = look.width};
        const ui::Point at = pen(), along{head.bar, 0.0}, up{0.0, -4.0};
        painter_.line(at, at + along, stroke);
        for (const ui::Point end : {at, at + along}) painter_.line(end + up, end - up, stroke);
        painter_.text(at + along + ui::Point{bar_gap, 0.0}, head.bar_text, style);
    }

    ui::Painter& painter_;
    const ui::Theme& theme_;
    ui::Box row_;
    double width_;
    std::size_t n_lines_;
    std::size_t line_ = 0;
    double x_ = 0.0; // of the pen, from the left border
};

} // namespace

double head_height(const ui::Theme& theme, double panel_width)
{
    const auto n_below = static_cast<double>(n_lines(theme, panel_width) - 1);
    return 1.6 * theme.type().normal + n_below * 1.4 * theme.type().small;
}

void draw_panel_head(ui::Painter& painter, const PanelHead& head, const ui::Theme& theme, const ui::Box& row)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    HeadWriter writer(painter, theme, row);
    writer.write_name(head);
    if (head.bar > 0.0) writer.write_bar(head);
    writer.write_note(head);
}

} // namespace frame
