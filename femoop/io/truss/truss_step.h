#pragma once

#include <string>
#include <vector>

#include "femoop/methods/truss/joint_method.h"
#include "femoop/methods/truss/section_method.h"
#include "femoop/model/fault/translator.h"

namespace femoop::truss {

/// One step of the way from joint to joint, as it is written on the board. Forces in the model's units.
struct StepText {
    std::vector<std::string> question; ///< what is unknown at the joint, or of the section, and the equations
    std::vector<std::string> answer;   ///< the bars that they give; empty where a joint only checks
};
StepText step_text(const Step& step, const Truss& truss, const Model& model, const Translator& tr);

/// "N(AD) = -36.0555 kN (compression)"; without a unit where the sheet has said it.
enum class Unit : std::uint8_t { Written, Known };
std::string force_result(MemberId bar, double force, const Model& model, const Translator& tr, Unit unit);

/// "AB, BC and CD".
std::string bars_text(const std::vector<MemberId>& bars, const Model& model, const Translator& tr);

/// What is unknown at the joint of a step.
std::string joint_sentence(const Step& step, const Model& model, const Translator& tr);

/// The bars of a cut, and the part whose equilibrium is written.
std::string cut_sentence(const RitterCut& cut, const Model& model, const Translator& tr);

/// About which point moments are taken to find a bar of a cut, or that forces across the others do.
std::string ritter_sentence(const CutEquation& found, const Truss& truss, const Model& model, const Translator& tr);

} // namespace femoop::truss
