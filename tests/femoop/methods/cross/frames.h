#pragma once

#include "femoop/model/model.h"
#include "tests/frame_maker.h"

inline constexpr auto fixed = femoop::SupportKind::Fixed, pin = femoop::SupportKind::Pin,
                      roller = femoop::SupportKind::Roller;
