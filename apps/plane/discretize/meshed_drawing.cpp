#include "apps/plane/discretize/meshed_drawing.h"

#include <iterator>
#include <utility>

#include "apps/plane/discretize/mesh_model.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/plane/check/plane_check.h"

namespace discretize {

MeshedDrawing::MeshedDrawing(const Drawing& drawing, const std::function<bool()>& is_cancelled,
                             const std::shared_ptr<const topology::SizeField>& sizes)
{
    const std::vector<FaceOutline> outlines = outlines_of(drawing);
    if (outlines.empty()) {
        faults_ = {{femoop::FaultKind::NothingToMesh, {}}};
        return;
    }
    const std::vector<MeshSettings> settings = settings_of(drawing, outlines, sizes);
    const EdgeDivisions divisions(drawing, outlines, settings);
    faults_ = divisions.faults();
    if (!femoop::errors_among(faults_).empty()) return;
    RegionMesher mesher(drawing, outlines, settings, divisions, is_cancelled);
    mesher.run();
    if (is_cancelled && is_cancelled()) return; // a part of a mesh is none
    faults_ = mesher.errors();
    if (!faults_.empty()) return;
    faults_ = mesher.warnings();
    mesh_ = mesher.mesh();
    make_model(drawing, outlines);
}

MeshedDrawing::MeshedDrawing(const Drawing& drawing, RegionMesh mesh) : mesh_(std::move(mesh))
{
    make_model(drawing, outlines_of(drawing));
}

void MeshedDrawing::make_model(const Drawing& drawing, const std::vector<FaceOutline>& outlines)
{
    MeshModelMaker maker(drawing, outlines, mesh_);
    auto model = std::make_shared<PlaneModel>(maker.model());
    for (const auto& faults : {maker.errors(), femoop::plane::check(*model)})
        faults_.insert(faults_.end(), faults.begin(), faults.end());
    if (!femoop::errors_among(faults_).empty()) return;
    n_points_ = maker.n_points();
    node_of_point_ = maker.node_of_point();
    checks_ = maker.checks();
    for (std::size_t i = 0; i < maker.regions().size(); ++i)
        if (maker.regions()[i]) reports_.push_back(mesh_.reports[i]);
    model_ = std::move(model);
}

} // namespace discretize
