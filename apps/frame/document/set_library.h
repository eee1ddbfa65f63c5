#pragma once

#include <string>
#include <vector>

#include "apps/frame/document/named_sets.h"
#include "femoop/model/model.h"

namespace frame {

/// The named sets in the form of a model, which is how they are written, read and counted in other units: a support is
/// that of a node of its name, a load the only one of a load case of its name. Analysis and units are those of `like`.
femoop::Model library_of(const std::vector<NamedSet>& sets, const femoop::Model& like);

/// The named sets of such a model; a node without support and a load case with several loads are none.
std::vector<NamedSet> sets_in(const femoop::Model& library);

/// The places in such a model of what is no named set and bears none: `sets_in` loses it.
std::vector<std::string> places_beyond_sets(const femoop::Model& library);

/// Whether a model of this analysis takes the support or load.
bool is_usable(const NamedSet& set, const femoop::Model& model);

} // namespace frame
