#include "apps/frame/tools/tool_loads.h"

#include <algorithm>
#include <array>

#include "ui/text/catalogue.h"

namespace frame {

using femoop::AnalysisKind;
using ui::translatable;

namespace {

constexpr ToolLoadEntry uniform_down{{LoadKind::Uniform, LoadWay::Down},
                                     "load.uniform",
                                     translatable("Add a uniform load ↓"),
                                     translatable("Uniform load ↓")};
constexpr ToolLoadEntry uniform_across{{LoadKind::UniformAcross, LoadWay::Down},
                                       "load.across",
                                       translatable("Add a uniform load across"),
                                       translatable("Uniform load across")};
constexpr ToolLoadEntry force_down{
    {LoadKind::Force, LoadWay::Down}, "load.force_down", translatable("Add a force ↓"), translatable("Force ↓")};
constexpr ToolLoadEntry triangular_down{{LoadKind::Triangular, LoadWay::Down},
                                        "load.triangular",
                                        translatable("Add a triangular load ↓"),
                                        translatable("Triangular load ↓")};
constexpr ToolLoadEntry moment_x{{LoadKind::Moment, LoadWay::X},
                                 "load.moment_x",
                                 translatable("Add a moment about x"),
                                 translatable("Moment about x")};
constexpr ToolLoadEntry moment_y{{LoadKind::Moment, LoadWay::Y},
                                 "load.moment_y",
                                 translatable("Add a moment about y"),
                                 translatable("Moment about y")};

constexpr std::array in_plane{
    uniform_down,
    uniform_across,
    force_down,
    ToolLoadEntry{
        {LoadKind::Force, LoadWay::X}, "load.force_right", translatable("Add a force →"), translatable("Force →")},
    ToolLoadEntry{{LoadKind::Moment, LoadWay::Z}, "load.moment", translatable("Add a moment"), translatable("Moment")},
    triangular_down,
};
constexpr std::array of_grillage{uniform_down, uniform_across, force_down, moment_x, moment_y, triangular_down};
constexpr std::array in_space{
    uniform_down,
    ToolLoadEntry{{LoadKind::Uniform, LoadWay::X},
                  "load.uniform_x",
                  translatable("Add a uniform load along x"),
                  translatable("Uniform load along x")},
    ToolLoadEntry{{LoadKind::Uniform, LoadWay::Y},
                  "load.uniform_y",
                  translatable("Add a uniform load along y"),
                  translatable("Uniform load along y")},
    uniform_across,
    force_down,
    ToolLoadEntry{{LoadKind::Force, LoadWay::X},
                  "load.force_right",
                  translatable("Add a force along x"),
                  translatable("Force along x")},
    ToolLoadEntry{{LoadKind::Force, LoadWay::Y},
                  "load.force_y",
                  translatable("Add a force along y"),
                  translatable("Force along y")},
    moment_x,
    moment_y,
    ToolLoadEntry{{LoadKind::Moment, LoadWay::Z},
                  "load.moment",
                  translatable("Add a moment about z"),
                  translatable("Moment about z")},
    triangular_down,
    ToolLoadEntry{{LoadKind::Triangular, LoadWay::X},
                  "load.triangular_x",
                  translatable("Add a triangular load along x"),
                  translatable("Triangular load along x")},
    ToolLoadEntry{{LoadKind::Triangular, LoadWay::Y},
                  "load.triangular_y",
                  translatable("Add a triangular load along y"),
                  translatable("Triangular load along y")},
};

} // namespace

std::span<const ToolLoadEntry> tool_loads(AnalysisKind kind)
{
    if (femoop::is_3d(kind)) return in_space;
    if (kind == AnalysisKind::Grillage) return of_grillage;
    return in_plane;
}

const ToolLoadEntry& entry_of(const ToolLoad& load, AnalysisKind kind)
{
    const std::span<const ToolLoadEntry> all = tool_loads(kind);
    const auto same = std::ranges::find(all, load, &ToolLoadEntry::load);
    if (same != all.end()) return *same;
    return *std::ranges::find(all, load.kind, [](const ToolLoadEntry& entry) { return entry.load.kind; });
}

} // namespace frame
