#include "apps/frame/view/derivation/derivation_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/drawing/results/influence_picture.h"
#include "apps/frame/view/derivation/matrix_block.h"
#include "apps/frame/view/derivation/stiffness_map.h"
#include "femoop/io/derivation/derivation_text.h"
#include "ui/paint/wrapped_lines.h"

namespace frame {

using femoop::derivation::Derivation;
using femoop::derivation::NamedMatrix;
using femoop::derivation::Step;
using femoop::derivation::StepKind;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

constexpr double panel_margin = 12.0;
constexpr double map_share = 0.34; // of the sheet's width, at most
constexpr double narrow_map = 0.6;
constexpr double two_maps_share = 0.6;
constexpr std::array sizes{1.25, 1.12, 1.0, 0.92, 0.84, 0.76, 0.7}; // of the theme's type, the first that fits

/// One step laid out on a sheet.
class StepSheet {
public:
    StepSheet(const Derivation& derivation, const femoop::Model& model, const DerivationLook& look, ui::Size sheet,
              const ui::Fonts& fonts)
        : derivation_(derivation),
          model_(model),
          look_(look),
          sheet_(sheet),
          fonts_(fonts),
          place_(std::min(look.step, derivation.steps.size() - 1)),
          step_(derivation.steps[place_])
    {
        if (fits(Layout::Whole)) return;
        if (has_no_map() && !fits(Layout::Parted)) fits(Layout::Whole);
        if (!has_no_map() && !is_numbering()) make_room();
    }

    ui::Size needed() const
    {
        return {right_ + (sheet_.width - room_right()),
                std::max(bottom_ + panel_margin, 12.0 * look_.theme.type().normal)};
    }

    void draw(ui::Painter& painter) const
    {
        draw_head(painter);
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            blocks_[i].draw(painter, places_[i]);
            const bool is_system = femoop::derivation::is_system(step_);
            if (is_system && i > 0) draw_sign(painter, i);
        }
        if (has_no_map() || map_width() == 0.0) return;
        const double left = sheet_.width - panel_margin - map_width();
        const auto draw_map = is_numbering() ? draw_numbering : draw_stiffness_map;
        draw_map(painter, derivation_, step_, model_, look_,
                 {{left, panel_margin}, {sheet_.width - panel_margin, sheet_.height - panel_margin}});
    }

private:
    /// Are long lists parted, so that their parts stand beside one another?
    enum class Layout : std::uint8_t { Whole, Parted };

    /// In the largest type that has room; \returns false where the smallest has none.
    bool fits(Layout layout)
    {
        for (const double size : sizes) {
            if (size < least_size()) break;
            lay_out(size * look_.theme.type().normal, layout);
            if (bottom_ <= seen_bottom() && right_ <= room_right()) return true;
        }
        return false;
    }

    /// A matrix that reaches under the map has more room beside a narrower one, or without it.
    void make_room()
    {
        for (const double share : {narrow_map, 0.0}) {
            if (right_ <= room_right()) return;
            map_scale_ = share;
            fits(Layout::Whole);
        }
    }

    /// A class reads the force method from afar; it is scrolled rather than shrunk.
    double least_size() const
    {
        const ui::TypeSizes& type = look_.theme.type();
        const bool is_read_from_afar = look_.theme.name() == ui::ThemeName::Projector && has_no_map();
        return is_read_from_afar ? 0.98 * type.small / type.normal : sizes.back();
    }

    bool has_no_map() const { return !derivation_.redundants.empty(); } ///< the force method has no K
    bool is_numbering() const { return step_.kind == StepKind::Numbering; }
    double map_width() const
    {
        if (has_no_map()) return 0.0;
        if (is_numbering()) return std::min(two_maps_share * sheet_.width, 2.2 * sheet_.height);
        const double height = std::min(sheet_.height, look_.seen_height.value_or(sheet_.height));
        return map_scale_ * std::min(map_share * sheet_.width, 1.25 * height);
    }
    double room_right() const { return sheet_.width - map_width() - 3.0 * panel_margin; }

    ui::TextStyle title_style() const
    {
        ui::TextStyle style = look_.theme.text(Role::Label, Anchor::TopLeft);
        style.weight = ui::Weight::Bold;
        style.size = 1.15 * style.size;
        return style;
    }
    ui::TextStyle sentence_style() const { return look_.theme.text(Role::Label, Anchor::TopLeft); }

    std::string title() const
    {
        const auto& tr = look_.tr;
        if (has_no_map()) return tr("Force method in {case}", {{"case", model_.case_name(derivation_.load_case)}});
        return tr("{number} = {value} in {case}",
                  {{"number", femoop::derivation::number_name(
                                  derivation_, drawing::effect_text(model_, look_.units, derivation_.effect))},
                   {"value",
                    ui::with_minus_signs(look_.units.text(derivation_.value, drawing::measure_of(derivation_.effect)))},
                   {"case", model_.case_name(derivation_.load_case)}});
    }
    std::string place_text() const
    {
        const std::string step = look_.tr("step {n} of {total}", {{"n", std::to_string(place_ + 1)},
                                                                  {"total", std::to_string(derivation_.steps.size())}});
        const bool is_one_of_many = derivation_.load_case.index >= model_.load_cases.size() && step_.load_case;
        return is_one_of_many ? step + ", " + model_.case_name(*step_.load_case) : step;
    }
    std::vector<std::string> lines(const std::string& text, const ui::TextStyle& style) const
    {
        return ui::wrapped_lines(fonts_, text, style, room_right() - panel_margin);
    }
    std::vector<std::string> sentence_lines() const
    {
        return lines(femoop::derivation::with_raised_powers(femoop::derivation::sentence(step_, model_, look_.tr)),
                     sentence_style());
    }
    double head_height() const
    {
        const double titles = 1.45 * title_style().size * static_cast<double>(title_lines().size());
        return panel_margin + titles + 1.4 * sentence_style().size * static_cast<double>(sentence_lines().size() + 1);
    }
    std::vector<std::string> title_lines() const { return lines(title() + "   " + place_text(), title_style()); }

    void draw_head(ui::Painter& painter) const
    {
        const ui::LayerScope layer(painter, ui::Layer::Labels);
        Point pen{panel_margin, panel_margin};
        const auto write = [&](const std::vector<std::string>& all, const ui::TextStyle& style, double height) {
            for (const std::string& one : all) {
                painter.text(pen, one, style);
                pen.y += height * style.size;
            }
        };
        write(title_lines(), title_style(), 1.45);
        write(sentence_lines(), sentence_style(), 1.4);
        ui::TextStyle faint = look_.theme.text(Role::FaintLabel, Anchor::TopLeft);
        faint.size = look_.theme.type().small;
        write({femoop::derivation::derivation_units(model_, look_.tr)}, faint, 1.4);
    }

    double seen_bottom() const
    {
        return std::min(sheet_.height, look_.seen_height.value_or(sheet_.height)) - panel_margin;
    }
    double gap() const { return (has_no_map() ? 1.4 : 2.0) * em_; }

    struct Part {
        NamedMatrix matrix;
        femoop::derivation::Notation notation;
    };

    /// Into how many parts a list of the force method goes that is higher than what is seen of the sheet.
    Eigen::Index n_parts(const MatrixBlock& whole, Eigen::Index n_rows, double top) const
    {
        const double room = std::max(seen_bottom() - top, em_);
        const double most = std::floor((room_right() - panel_margin) / (whole.size().width + gap()));
        const double wanted = std::ceil(whole.size().height / room);
        return static_cast<Eigen::Index>(std::clamp(std::min(most, wanted), 1.0, static_cast<double>(n_rows)));
    }

    void add_parts(std::vector<Part>& parts, const NamedMatrix& matrix, Layout layout, double top) const
    {
        const auto notation = femoop::derivation::notation_of(step_, matrix);
        const Eigen::Index n = matrix.values.rows();
        const bool may_part = layout == Layout::Parted && notation == femoop::derivation::Notation::List && n > 1;
        const MatrixBlock whole(matrix, notation, look_, fonts_, em_);
        const Eigen::Index n_parts = may_part ? this->n_parts(whole, n, top) : 1;
        if (n_parts == 1) return parts.push_back({matrix, notation});
        const Eigen::Index n_rows = (n + n_parts - 1) / n_parts;
        for (Eigen::Index from = 0; from < n; from += n_rows) {
            const Eigen::Index to = std::min(from + n_rows, n);
            const std::vector<std::string> rows(matrix.rows.begin() + from, matrix.rows.begin() + to);
            parts.push_back(
                {{matrix.symbol, rows, matrix.columns, matrix.values.middleRows(from, to - from)}, notation});
        }
    }

    // What a superposition finds stands first: redundants, reactions, moments.
    std::vector<Part> shown_parts(Layout layout, double top) const
    {
        const bool is_reversed = step_.kind == StepKind::StateSuperposition;
        const std::size_t n = step_.matrices.size();
        std::vector<Part> parts;
        for (std::size_t i = 0; i < n; ++i) add_parts(parts, step_.matrices[is_reversed ? n - 1 - i : i], layout, top);
        return parts;
    }

    // Beside one another, and below where there is no room.
    void lay_out(double em, Layout layout)
    {
        em_ = em;
        blocks_.clear();
        places_.clear();
        Point pen{panel_margin, head_height() + 0.5 * em};
        double row_height = 0.0;
        right_ = 0.0;
        for (const auto& [matrix, notation] : shown_parts(layout, pen.y)) {
            const MatrixBlock& block = blocks_.emplace_back(matrix, notation, look_, fonts_, em);
            const ui::Size size = block.size();
            if (pen.x > panel_margin && pen.x + size.width > room_right()) {
                pen = {panel_margin, pen.y + row_height + 0.6 * em};
                row_height = 0.0;
            }
            places_.push_back(pen);
            pen.x += size.width + gap();
            row_height = std::max(row_height, size.height);
            right_ = std::max(right_, places_.back().x + size.width);
            bottom_ = pen.y + row_height;
        }
    }

    // K · u = f
    void draw_sign(ui::Painter& painter, std::size_t before) const
    {
        const bool is_beside = places_[before].y == places_[before - 1].y;
        if (!is_beside) return;
        const ui::LayerScope layer(painter, ui::Layer::Labels);
        ui::TextStyle style = look_.theme.text(Role::Label, Anchor::Center);
        style.size = 1.2 * em_;
        painter.text({places_[before].x - 0.9 * em_, places_[before].y + 0.5 * (blocks_[before].size().height + em_)},
                     before == 1 ? "·" : "=", style);
    }

    const Derivation& derivation_;
    const femoop::Model& model_;
    const DerivationLook& look_;
    ui::Size sheet_;
    const ui::Fonts& fonts_;
    std::size_t place_;
    const Step& step_;
    double em_ = 0.0, bottom_ = 0.0, right_ = 0.0;
    double map_scale_ = 1.0; ///< of the map's usual width; 0: there is no room for it
    std::vector<MatrixBlock> blocks_;
    std::vector<Point> places_;
};

} // namespace

ui::Size sheet_for(const Derivation& derivation, const femoop::Model& model, const DerivationLook& look, ui::Size room,
                   const ui::Fonts& fonts)
{
    if (derivation.steps.empty()) return room;
    const ui::Size needed = StepSheet(derivation, model, look, room, fonts).needed();
    return {std::max(needed.width, room.width), std::max(needed.height, room.height)};
}

void draw_derivation(ui::Painter& painter, const Derivation& derivation, const femoop::Model& model,
                     const DerivationLook& look)
{
    if (derivation.steps.empty()) return;
    StepSheet(derivation, model, look, painter.size(), painter.fonts()).draw(painter);
}

} // namespace frame
