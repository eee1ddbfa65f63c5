// Frames in space.
#include <string>
#include <vector>

#include "femoop/typical/sketch.h"
#include "femoop/typical/typical.h"

namespace femoop {

namespace {

SupportKind foot_support(Base base) { return base == Base::Fixed ? SupportKind::Fixed : SupportKind::Pin; }

/// The joints of a floor, row by row along x.
class Floor {
public:
    Floor(Sketch& sketch, const SpaceFrame& frame, int level) : n_x_(frame.bays_x + 1)
    {
        for (int j = 0; j <= frame.bays_y; ++j)
            for (int i = 0; i <= frame.bays_x; ++i) {
                const std::string name = letter_name(j * n_x_ + i) + "." + std::to_string(level);
                nodes_.push_back(sketch.node(name, i * frame.bay_x, j * frame.bay_y, level * frame.storey));
            }
    }
    NodeId at(int i, int j) const { return nodes_[static_cast<std::size_t>(j * n_x_ + i)]; }
    const std::vector<NodeId>& nodes() const { return nodes_; }

private:
    int n_x_;
    std::vector<NodeId> nodes_;
};

void add_beams(Sketch& sketch, const SpaceFrame& frame, const Floor& floor)
{
    for (int j = 0; j <= frame.bays_y; ++j)
        for (int i = 0; i <= frame.bays_x; ++i) {
            if (i > 0) sketch.load_down(sketch.member(floor.at(i - 1, j), floor.at(i, j)), -frame.load);
            if (j > 0) sketch.load_down(sketch.member(floor.at(i, j - 1), floor.at(i, j)), -frame.load);
            if (i == 0) sketch.load(floor.at(i, j), Dof::ux, frame.wind);
        }
}

} // namespace

Model SpaceFrame::model() const
{
    require_within("bays_x", bays_x, 1, 10);
    require_within("bays_y", bays_y, 1, 10);
    require_within("storeys", storeys, 1, 20);
    require_positive("bay_x", bay_x);
    require_positive("bay_y", bay_y);
    require_positive("storey", storey);
    Sketch sketch("Space frame", AnalysisKind::Frame3d);
    Floor below(sketch, *this, 0);
    for (const NodeId foot : below.nodes()) sketch.support(foot, foot_support(base));
    for (int level = 1; level <= storeys; ++level) {
        const Floor floor(sketch, *this, level);
        for (std::size_t i = 0; i < floor.nodes().size(); ++i) sketch.member(below.nodes()[i], floor.nodes()[i]);
        add_beams(sketch, *this, floor);
        below = floor;
    }
    return std::move(sketch).model();
}

Model Tower::model() const
{
    require_within("levels", levels, 1, 30);
    require_positive("height", height);
    require_positive("foot", foot);
    require_positive("top", top);
    Sketch sketch("Tower", AnalysisKind::Frame3d);
    std::vector<NodeId> below;
    for (int level = 0; level <= levels; ++level) {
        const double share = static_cast<double>(level) / levels, half = 0.5 * (foot + share * (top - foot));
        std::vector<NodeId> corners;
        for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}}) {
            const std::string name = letter_name(static_cast<int>(corners.size())) + std::to_string(level);
            corners.push_back(sketch.node(name, x, y, share * height));
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (level == 0) sketch.support(corners[i], SupportKind::Fixed);
            else sketch.member(below[i], corners[i]);
            if (level > 0) sketch.member(corners[i], corners[(i + 1) % 4]);
        }
        below = corners;
    }
    for (const NodeId corner : below) {
        sketch.load(corner, Dof::ux, wind);
        sketch.load(corner, Dof::uz, -load);
    }
    return std::move(sketch).model();
}

} // namespace femoop
