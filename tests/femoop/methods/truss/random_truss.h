#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/methods/truss/truss.h"
#include "femoop/model/model.h"

inline constexpr femoop::SupportKind Pin = femoop::SupportKind::Pin, Roller = femoop::SupportKind::Roller;

/// Plane trusses that are built in a line: one load case "P".
///
///     TrussMaker made;
///     made.node("A", {0, 0}, Pin).node("B", {4, 0}, Roller).node("C", {2, 3}).bars({"AB", "AC", "BC"}).load("C", {5, -12});
class TrussMaker {
public:
    TrussMaker();
    TrussMaker& node(const std::string& id, const Eigen::Vector2d& at,
                     femoop::SupportKind kind = femoop::SupportKind::Custom);
    TrussMaker& bar(const std::string& a, const std::string& b);
    TrussMaker& bars(const std::vector<std::string>& pairs_of_letters);
    TrussMaker& load(const std::string& id, const Eigen::Vector2d& force);

    femoop::Model model;
};

/// The truss that the analysis finds statically determinate.
femoop::truss::Truss truss_in(const femoop::Model& model, femoop::CaseId load_case = {});

/// A statically determinate truss that grows from a triangle by the two steps of Henneberg: a new joint on two bars, or
/// on three in place of one bar between two of them. Every joint is loaded. It need not be planar.
femoop::Model random_truss(unsigned seed, int n_steps);

/// One that grows outwards: two bars at a time onto a bar of its outline, crossing none. Joints of the outline are loaded.
femoop::Model random_planar_truss(unsigned seed, int n_steps);
