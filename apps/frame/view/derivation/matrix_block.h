#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/frame/view/derivation/derivation_picture.h"
#include "femoop/io/derivation/derivation_text.h"
#include "ui/paint/geometry.h"
#include "ui/paint/painter.h"

namespace frame {

/// A matrix of a step as it is written on a sheet: symbol, names above its columns and beside its rows, numbers in
/// brackets. A list of named numbers has no brackets; where they are added up a line stands above the sum.
class MatrixBlock {
public:
    MatrixBlock(const femoop::derivation::NamedMatrix& matrix, femoop::derivation::Notation notation,
                const DerivationLook& look, const ui::Fonts& fonts, double em);

    ui::Size size() const;
    void draw(ui::Painter& painter, ui::Point corner) const;

private:
    double line() const;
    double names_width() const;
    double column_left(std::size_t column) const;
    void draw_numbers(ui::Painter& painter, ui::Point corner) const;
    void draw_brackets(ui::Painter& painter, ui::Point corner) const;
    ui::TextStyle style(ui::Role role, ui::Anchor anchor) const;

    std::string symbol_;
    femoop::derivation::Notation notation_;
    const DerivationLook& look_;
    const ui::Fonts& fonts_;
    double em_;
    std::vector<std::string> rows_, columns_;
    std::vector<std::vector<std::string>> numbers_; ///< row by row
    std::vector<double> widths_;                    ///< of the columns
};

} // namespace frame
