#pragma once

#include <string>
#include <vector>

#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace frame {

/// Something that can be read along a member, and how it is named and drawn.
struct Reading {
    femoop::MemberComponent component;
    const char* name;
    ui::Measure measure;
    ui::Role role;
};

/// The section forces of members in this kind of model, by the names that the model file has for them. Truss members
/// have V and M too, from loads along them.
std::vector<Reading> section_forces(femoop::AnalysisKind kind);

/// One line of a readout: "M", "-12.5 kN·m", in the looks of a role.
struct ReadoutLine {
    std::string name;
    std::string value;
    ui::Role role = ui::Role::Label;
};

/// What is to be read at a cut: section forces, then displacements. Empty where there are no results.
std::vector<ReadoutLine> readout_lines(const Session& session, const Cut& cut);
std::string readout_title(const Session& session, const Cut& cut);

/// A card beside the cut with its values and a free-body sketch of the part before the cut, its arrows in the
/// directions in which the forces really act:
///
///         ____________      | V > 0 (along -y')
///        |   member   | --->  N > 0 (tension)
///         ------------  v ) M > 0 (counter-clockwise)
///
/// `at` is the cut's place on the sheet; the card stays within the sheet.
void draw_readout(ui::Painter& painter, const Session& session, const Cut& cut, ui::Point at);

} // namespace frame
