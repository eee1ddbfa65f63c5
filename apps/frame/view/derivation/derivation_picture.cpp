#include "apps/frame/view/derivation/derivation_picture.h"

#include <algorithm>
#include <array>
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
        for (const double size : sizes) {
            lay_out(size * look.theme.type().normal);
            if (bottom_ <= sheet.height - panel_margin && right_ <= room_right()) break;
        }
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
        if (has_no_map()) return;
        const double left = sheet_.width - panel_margin - map_width();
        const auto draw_map = is_numbering() ? draw_numbering : draw_stiffness_map;
        draw_map(painter, derivation_, step_, model_, look_,
                 {{left, panel_margin}, {sheet_.width - panel_margin, sheet_.height - panel_margin}});
    }

private:
    bool has_no_map() const { return !derivation_.redundants.empty(); } ///< the force method has no K
    bool is_numbering() const { return step_.kind == StepKind::Numbering; }
    double map_width() const
    {
        if (has_no_map()) return 0.0;
        if (is_numbering()) return std::min(two_maps_share * sheet_.width, 2.2 * sheet_.height);
        return std::min(map_share * sheet_.width, 1.25 * sheet_.height);
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
                  {{"number", drawing::effect_text(model_, look_.units, derivation_.effect)},
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

    // Beside one another, and below where there is no room.
    void lay_out(double em)
    {
        em_ = em;
        blocks_.clear();
        places_.clear();
        const double gap = 2.0 * em;
        Point pen{panel_margin, head_height() + 0.5 * em};
        double row_height = 0.0;
        right_ = 0.0;
        // What a superposition finds stands first: redundants, reactions, moments.
        const bool is_reversed = step_.kind == StepKind::StateSuperposition;
        for (std::size_t i = 0; i < step_.matrices.size(); ++i) {
            const NamedMatrix& matrix = step_.matrices[is_reversed ? step_.matrices.size() - 1 - i : i];
            const MatrixBlock& block = blocks_.emplace_back(matrix, femoop::derivation::notation_of(step_, matrix),
                                                            look_, fonts_, em);
            const ui::Size size = block.size();
            if (pen.x > panel_margin && pen.x + size.width > room_right()) {
                pen = {panel_margin, pen.y + row_height + 0.6 * em};
                row_height = 0.0;
            }
            places_.push_back(pen);
            pen.x += size.width + gap;
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
