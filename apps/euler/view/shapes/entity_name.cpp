#include "apps/euler/view/shapes/entity_name.h"

#include "topology/halfedge/operators/refusal.h"

namespace euler {

std::string entity_name(const Subject& subject, topology::Entity entity)
{
    if (entity.kind == topology::EntityKind::HalfEdge) return "%" + std::to_string(entity.index + 1);
    if (entity.kind == topology::EntityKind::Edge) return topology::table_name(entity);
    return subject.names->of(entity, *subject.solid);
}

} // namespace euler
