#include "apps/drawing/sheet/panel_head.h"

#include "apps/drawing/sheet/legend.h"
#include "ui/paint/wrapped_lines.h"

#include <algorithm>

namespace drawing {

namespace {

// [px]
constexpr double left_border = 16.0;
constexpr double right_border = 6.0;
constexpr double gap = 14.0;    // between name, bar and note
constexpr double bar_gap = 6.0; // between the bar and its text

constexpr std::size_t most_lines = 4;

ui::TextStyle small_text(const ui::Theme& theme, ui::Role role)
{
    ui::TextStyle style = theme.text(role, ui::Anchor::Left);
    style.size = theme.type().small;
    return style;
}

/// Writes the parts of one head one after another; without a painter it only finds how many lines they take.
class HeadWriter {
public:
    HeadWriter(ui::Painter* painter, const ui::Theme& theme, const ui::Fonts& fonts, const ui::Box& row)
        : painter_(painter), theme_(theme), fonts_(fonts), row_(row), width_(row.width() - left_border - right_border)
    {}

    void write(const PanelHead& head)
    {
        write_name(head);
        if (head.bar > 0.0) write_bar(head);
        if (!head.note.empty()) write_note(head);
    }

    std::size_t n_lines() const { return line_ + 1; }
    double width() const { return left_border + widest_; }

private:
    void write_name(const PanelHead& head)
    {
        ui::TextStyle style = theme_.text(head.role, ui::Anchor::Left);
        style.weight = ui::Weight::Bold;
        write_lines(ui::wrapped_lines(fonts_, head.name, style, width_), style);
    }

    void write_bar(const PanelHead& head)
    {
        const ui::TextStyle style = small_text(theme_, head.role);
        const double width = head.bar + bar_gap + measure(head.bar_text, style);
        if (!find_room(width)) return;
        if (painter_) draw_bar(head, style);
        go_on(width);
    }

    /// On one line with the rest, or on lines of its own below.
    void write_note(const PanelHead& head)
    {
        const ui::TextStyle style = small_text(theme_, ui::Role::FaintLabel);
        if (x_ + measure(head.note, style) <= width_) return write_lines({head.note}, style);
        const std::vector<std::string> lines = ui::wrapped_lines(fonts_, head.note, style, width_);
        if (line_ + 1 + lines.size() > most_lines || !fit(lines, style)) return;
        next_line();
        write_lines(lines, style);
    }

    double measure(std::string_view text, const ui::TextStyle& style) const
    {
        return fonts_.measure(text, style).width;
    }

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
        if (width > width_ || n_lines() >= most_lines) return false;
        next_line();
        return true;
    }

    bool fit(const std::vector<std::string>& lines, const ui::TextStyle& style) const
    {
        return std::all_of(lines.begin(), lines.end(),
                           [&](const std::string& line) { return measure(line, style) <= width_; });
    }

    /// Leaves the pen behind the last line.
    void write_lines(const std::vector<std::string>& lines, const ui::TextStyle& style)
    {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (i > 0) next_line();
            if (painter_) painter_->text(pen(), lines[i], style);
        }
        for (const std::string& line : lines) widest_ = std::max(widest_, measure(line, style));
        if (!lines.empty()) go_on(measure(lines.back(), style));
    }

    void go_on(double width)
    {
        widest_ = std::max(widest_, x_ + width);
        x_ += width + gap;
    }

    void draw_bar(const PanelHead& head, const ui::TextStyle& style)
    {
        const auto& look = theme_.stroke(head.role);
        const ui::Stroke stroke = {.color = look.color, .width = look.width};
        const ui::Point at = pen(), along{head.bar, 0.0}, up{0.0, -4.0};
        painter_->line(at, at + along, stroke);
        for (const ui::Point end : {at, at + along}) painter_->line(end + up, end - up, stroke);
        painter_->text(at + along + ui::Point{bar_gap, 0.0}, head.bar_text, style);
    }

    ui::Painter* painter_;
    const ui::Theme& theme_;
    const ui::Fonts& fonts_;
    ui::Box row_;
    double width_;
    std::size_t line_ = 0;
    double x_ = 0.0;      // of the pen, from the left border
    double widest_ = 0.0; // of the lines so far
};

} // namespace

double head_height(const PanelHead& head, const ui::Theme& theme, const ui::Fonts& fonts, double panel_width)
{
    HeadWriter writer(nullptr, theme, fonts, {{0.0, 0.0}, {panel_width, 0.0}});
    writer.write(head);
    return 1.6 * theme.type().normal + static_cast<double>(writer.n_lines() - 1) * 1.4 * theme.type().small;
}

void draw_panel_head(ui::Painter& painter, const PanelHead& head, const ui::Theme& theme, const ui::Box& row)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    HeadWriter measuring(nullptr, theme, painter.fonts(), row);
    measuring.write(head);
    painter.rectangle({row.min, {row.min.x + measuring.width() + right_border, row.max.y}}, theme.background());
    HeadWriter(&painter, theme, painter.fonts(), row).write(head);
}

} // namespace drawing
