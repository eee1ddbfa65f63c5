#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>

#include "femoop/element/span_load.h"
#include "femoop/model/dof.h"

namespace femoop {

/// What distinguishes the five models of member structures: the degrees of freedom of a node in global axes, and
/// the displacements of a member's end, in its own axes, that strain it.
/// Source  [MarthaParente2002]: the class AnalysisModel
template <AnalysisKind kind> struct AnalysisModel;

template <> struct AnalysisModel<AnalysisKind::Truss2d> {
    static constexpr std::array global{Dof::ux, Dof::uy};
    static constexpr std::array local{LocalAxis::x};
};
template <> struct AnalysisModel<AnalysisKind::Frame2d> {
    static constexpr std::array global{Dof::ux, Dof::uy, Dof::rz};
    static constexpr std::array local{LocalAxis::x, LocalAxis::y, LocalAxis::rz};
};
template <> struct AnalysisModel<AnalysisKind::Grillage> {
    static constexpr std::array global{Dof::uz, Dof::rx, Dof::ry};
    static constexpr std::array local{LocalAxis::y, LocalAxis::rx, LocalAxis::rz};
};
template <> struct AnalysisModel<AnalysisKind::Truss3d> {
    static constexpr std::array global{Dof::ux, Dof::uy, Dof::uz};
    static constexpr std::array local{LocalAxis::x};
};
template <> struct AnalysisModel<AnalysisKind::Frame3d> {
    static constexpr std::array global{Dof::ux, Dof::uy, Dof::uz, Dof::rx, Dof::ry, Dof::rz};
    static constexpr std::array local{LocalAxis::x,  LocalAxis::y,  LocalAxis::z,
                                      LocalAxis::rx, LocalAxis::ry, LocalAxis::rz};
};

/// Calls `use` with the model as a compile-time constant, so that what follows works on matrices of fixed size.
template <class Use> decltype(auto) with_model(AnalysisKind kind, Use&& use)
{
    switch (kind) {
    case AnalysisKind::Truss2d: return use(std::integral_constant<AnalysisKind, AnalysisKind::Truss2d>());
    case AnalysisKind::Frame2d: return use(std::integral_constant<AnalysisKind, AnalysisKind::Frame2d>());
    case AnalysisKind::Grillage: return use(std::integral_constant<AnalysisKind, AnalysisKind::Grillage>());
    case AnalysisKind::Truss3d: return use(std::integral_constant<AnalysisKind, AnalysisKind::Truss3d>());
    case AnalysisKind::Frame3d: break;
    }
    return use(std::integral_constant<AnalysisKind, AnalysisKind::Frame3d>());
}

/// The displacements of a node that a model counts, in its order.
inline std::span<const Dof> model_dofs(AnalysisKind kind)
{
    return with_model(kind, [](auto k) { return std::span<const Dof>(AnalysisModel<decltype(k)::value>::global); });
}

/// The displacements of a member's end that strain it, in the model's order.
inline std::span<const LocalAxis> member_axes_of(AnalysisKind kind)
{
    return with_model(kind,
                      [](auto k) { return std::span<const LocalAxis>(AnalysisModel<decltype(k)::value>::local); });
}

} // namespace femoop
