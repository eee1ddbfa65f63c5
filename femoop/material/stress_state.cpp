#include "femoop/material/stress_state.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array in_a_sheet{StressComponent::x, StressComponent::y, StressComponent::xy};
constexpr std::array in_a_body{StressComponent::x,  StressComponent::y,  StressComponent::z,
                               StressComponent::xy, StressComponent::yz, StressComponent::zx};
constexpr std::array<std::string_view, n_stress_components> stress_names{"sx", "sy", "sz", "txy", "tyz", "tzx"};
constexpr std::array<std::string_view, n_stress_components> strain_names{"ex", "ey", "ez", "gxy", "gyz", "gzx"};

} // namespace

std::string_view name(StressComponent component) { return stress_names[static_cast<std::size_t>(component)]; }

std::string_view strain_name(StressComponent component) { return strain_names[static_cast<std::size_t>(component)]; }

std::span<const StressComponent> components(StressState state)
{
    if (state == StressState::PlaneStress) return in_a_sheet;
    return std::span(in_a_body).first(static_cast<std::size_t>(n_components(state)));
}

} // namespace femoop
