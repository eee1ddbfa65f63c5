#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "apps/plane/discretize/meshed_drawing.h"
#include "apps/plane/view/plate_picture.h"

/// A plane model with its drawing, ready to be looked at.
class PlateSubject {
public:
    explicit PlateSubject(std::string_view text); ///< of its file
    static PlateSubject example(const std::string& name);

    const femoop::plane::PlaneModel& model() const { return *model_; }
    /// A drawing is meshed and solved before its results are looked at.
    void mesh();
    plane::PlateInput input() const;

private:
    std::unique_ptr<const femoop::plane::PlaneModel> model_;
    std::unique_ptr<const discretize::Drawing> drawing_;
    std::unique_ptr<const discretize::MeshedDrawing> mesh_;
    std::unique_ptr<const femoop::plane::PlaneResults> results_;
};
