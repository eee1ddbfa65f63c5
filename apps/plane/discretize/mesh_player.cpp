#include "apps/plane/discretize/mesh_player.h"

#include <algorithm>

namespace discretize {

MeshPlayer::MeshPlayer(const Drawing& drawing, const std::shared_ptr<const topology::SizeField>& sizes)
    : drawing_(drawing),
      outlines_(outlines_of(drawing_)),
      settings_(settings_of(drawing_, outlines_, sizes)),
      divisions_(drawing_, outlines_, settings_),
      regions_(drawing_, outlines_, settings_, divisions_, {})
{
    regions_.prepare();
    restart();
    while (forward()) {
    }
    n_steps_ = place_;
    restart();
}

void MeshPlayer::restart()
{
    meshers_.clear();
    meshers_.push_back(regions_.outline_mesher(0));
    step_.reset();
    place_ = 0;
}

/// One step, of the next outline where the one under way is done. False where all are.
bool MeshPlayer::forward()
{
    topology::MeshStep made = meshers_.back().mesher->next();
    while (made == topology::MeshStep::Done) {
        if (meshers_.size() == outlines_.size()) return false;
        meshers_.push_back(regions_.outline_mesher(meshers_.size()));
        made = meshers_.back().mesher->next();
    }
    step_ = made;
    ++place_;
    return true;
}

void MeshPlayer::go_to(std::size_t place)
{
    place = std::min(place, n_steps_);
    if (place < place_) restart();
    while (place_ < place && forward()) {
    }
}

topology::MeshMarks MeshPlayer::marks() const
{
    return step_ ? meshers_.back().mesher->marks() : topology::MeshMarks{};
}

std::vector<topology::CellMesh> MeshPlayer::meshes() const
{
    std::vector<topology::CellMesh> all;
    for (const OutlineMesher& each : meshers_) all.push_back(each.mesher->mesh());
    return all;
}

} // namespace discretize
