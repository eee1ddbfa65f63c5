#include "tests/apps/plane_view/plate_subject.h"

#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"

PlateSubject::PlateSubject(std::string_view text)
    : model_(std::make_unique<const femoop::plane::PlaneModel>(femoop::plane::read_plane_model(text)))
{
    if (model_->is_drawn) drawing_ = std::make_unique<const discretize::Drawing>(*model_);
    else if (model_->n_cases() > 0)
        results_ = std::make_unique<const femoop::plane::PlaneResults>(femoop::plane::analyse(*model_));
}

PlateSubject PlateSubject::example(const std::string& name)
{
    return PlateSubject(text_of(source_folder() + "/examples/" + name + ".json"));
}

void PlateSubject::mesh()
{
    mesh_ = std::make_unique<const discretize::MeshedDrawing>(*drawing_);
    results_ = std::make_unique<const femoop::plane::PlaneResults>(femoop::plane::analyse(mesh_->model()));
}

plane::PlateInput PlateSubject::input() const
{
    return {.model = *model_,
            .drawing = drawing_.get(),
            .mesh = mesh_ ? &mesh_->model() : nullptr,
            .results = results_.get()};
}
