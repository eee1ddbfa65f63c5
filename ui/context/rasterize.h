#pragma once

#include "ui/context/pixels.h"
#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"

namespace ui {

struct Raster {
    double scale = 1.0;
    Color background = rgb(0xFFFFFF);
};

/// The picture in physical pixels, drawn off screen. \throws ContextError
Pixels rasterized(const Picture& picture, const Fonts& fonts, const Raster& raster);

} // namespace ui
