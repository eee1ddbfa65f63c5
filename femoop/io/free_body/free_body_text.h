#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/free_body/free_body.h"
#include "femoop/model/fault/translator.h"

namespace femoop::free_body {

/// What a force is and where: "load on AB at x = 2.5 m", "section of BC at x = 0 m", "reaction at A".
std::string force_text(const Force& force, const Model& model, const Translator& tr);

/// The equations of equilibrium with their numbers, which add up to nothing as they are printed, a line each:
/// "ΣFy = 36 + 30 − 66 = 0  [kN]"; of moments with forces that have arms two:
/// "ΣM(2, 0) = −30 kN · 1 m − 36 kN · 1.5 m + 84 kN·m", "= −30 − 54 + 84 = 0  [kN·m]".
std::vector<std::string> equation_lines(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                                        const Translator& tr);

/// The force of a bar alone: "N of U1U2 = −90 kN · 3 m / 4 m", "= −270 / 4 = −67.5  [kN]  about (6, 0), where the other
/// bars meet".
std::vector<std::string> ritter_lines(const FreeBody& body, const Model& model, const RitterPoint& point,
                                      const Translator& tr);

/// Why a cut lifts nothing out: the structure hangs together by these members (members_across).
std::string uncut_sentence(const std::vector<MemberId>& across, const Model& model, const Translator& tr);

/// The body, a table of the forces on it, one of their arms and moments about the point, the equations, and the Ritter
/// points.
std::string free_body_text(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                           const Translator& tr);

/// The same as a part of a LaTeX document, a section*.
std::string free_body_latex(const FreeBody& body, const Model& model, const Eigen::Vector3d& about,
                            const Translator& tr);

/// The same for a program, with every digit: members of the object that is open.
void write_free_body(JsonWriter& json, const FreeBody& body, const Model& model, const Eigen::Vector3d& about);

} // namespace femoop::free_body
