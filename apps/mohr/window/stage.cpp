#include "apps/mohr/window/stage.h"

#include <algorithm>
#include <array>

#include "ui/command/argument.h"

namespace mohr {

namespace {

struct NamedHandle {
    std::string_view name;
    Handle handle;
};
constexpr std::array handles{
    NamedHandle{"face x", Handle::FaceX},   NamedHandle{"face y", Handle::FaceY},
    NamedHandle{"plane", Handle::Plane},    NamedHandle{"centre", Handle::Centre},
    NamedHandle{"first", Handle::First},    NamedHandle{"second", Handle::Second},
    NamedHandle{"third", Handle::Third},    NamedHandle{"arrow x", Handle::ArrowX},
    NamedHandle{"arrow y", Handle::ArrowY}, NamedHandle{"arrow shear", Handle::ArrowShear},
    NamedHandle{"turn", Handle::Turn},      NamedHandle{"cursor", Handle::Cursor},
    NamedHandle{"normal", Handle::Normal},  NamedHandle{"fibre", Handle::Fibre},
    NamedHandle{"cube x", Handle::CubeX},   NamedHandle{"cube y", Handle::CubeY},
    NamedHandle{"cube z", Handle::CubeZ},   NamedHandle{"cube xy", Handle::CubeXY},
    NamedHandle{"cube yz", Handle::CubeYZ}, NamedHandle{"cube zx", Handle::CubeZX},
};

std::string names_of_places()
{
    std::string names = "a place: ";
    for (const NamedHandle& handle : handles) names += std::string(handle.name) + ", ";
    return names + "circle (50, -40) or pixel 400 300";
}

} // namespace

OffscreenStage::Found OffscreenStage::locate(std::string_view place)
{
    const Canvas& canvas = application().canvas();
    if (place.starts_with("circle ("))
        if (const auto p = ui::Argument{place, place.substr(7)}.numbers(2))
            return canvas.corner() + canvas.drawn().circle.to_sheet({p->at(0), p->at(1)});
    const auto named = std::ranges::find(handles, place, &NamedHandle::name);
    if (named == handles.end()) return names_of_places();
    const auto at = canvas.in_window(named->handle);
    if (!at) return "one that is drawn";
    return *at;
}

} // namespace mohr
