#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "femoop/methods/truss/reciprocal.h"
#include "femoop/model/fault/translator.h"
#include "femoop/tabular/table.h"

namespace femoop::truss {

enum class ParagraphKind : std::uint8_t { Title, Heading, Sentence, Equation, Table };

struct Paragraph {
    ParagraphKind kind = ParagraphKind::Sentence;
    std::string text;
    tabular::Table table;
};

/// A calculation by hand from top to bottom. `plain_text` and `latex` (truss_text.h) write it.
using Sheet = std::vector<Paragraph>;

/// The forces from outside, the bars that carry nothing, joint after joint with equations and polygon, all bars.
Sheet joint_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);

/// The forces from outside, the bars that carry nothing with the rule of each, and how many there are.
Sheet zero_force_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);

/// Each bar of a cut that can be found, with its Ritter point. \pre why_no_cut says nothing
Sheet cut_sheet(const Model& model, const Truss& truss, CaseId load_case, const std::vector<MemberId>& bars,
                const Translator& tr);

/// The spaces, the diagram stage by stage, its points and sides, how each bar is read. \pre why_no_reciprocal says nothing
Sheet diagram_sheet(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);

} // namespace femoop::truss
