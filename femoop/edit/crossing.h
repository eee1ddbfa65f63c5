#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/edit/member_line.h"
#include "femoop/edit/moved_parts.h"

namespace femoop {

/// What becomes of two members that come to cross: they are cut and joined at a node, or pass each other as the
/// diagonals of an X bracing do.
enum class Crossings : std::uint8_t { Cut, Keep };

/// Where two lines cross inside both; nothing for parallel ones.
std::optional<Eigen::Vector3d> crossing(const MemberLine& a, const MemberLine& b, double nearness);

/// Where members cross that were moved or made. Not where two cross that did so before: they pass each other on
/// purpose, and so does what lands on one of the two. New members that came as `n_copies` equal groups, each a copy of
/// one structure, cross within their group as those they were copied from, and so on purpose too.
std::vector<Eigen::Vector3d> new_crossings(const Model& model, const MovedParts& moved, std::size_t n_copies = 1);

} // namespace femoop
