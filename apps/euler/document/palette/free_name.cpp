#include "apps/euler/document/palette/free_name.h"

namespace euler {

namespace {

template <class IsTaken> std::string first_free(const std::string& letter, std::size_t number, const IsTaken& is_taken)
{
    while (is_taken(letter + std::to_string(number))) ++number;
    return letter + std::to_string(number);
}

} // namespace

std::optional<std::size_t> living_solid(const topology::ScriptRunner& runner, std::string_view name)
{
    for (std::size_t i = 0; i < runner.solids().size(); ++i)
        if (runner.solids()[i].is_alive() && runner.solids()[i].name == name) return i;
    return std::nullopt;
}

std::string free_solid_name(const topology::ScriptRunner& runner)
{
    return first_free("s", 1, [&](const std::string& name) { return living_solid(runner, name).has_value(); });
}

std::string free_vertex_name(const topology::Names& names, const topology::Solid& solid)
{
    return first_free("v", solid.vertices().n_rows() + 1,
                      [&](const std::string& name) { return names.vertices.is_given(name); });
}

std::string free_face_name(const topology::Names& names, const topology::Solid& solid)
{
    return first_free("f", solid.faces().n_rows() + 1,
                      [&](const std::string& name) { return names.faces.is_given(name); });
}

} // namespace euler
