#include "models/station/object_tool.h"

namespace carina
{

std::optional<ToolRole> trackedBy(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Head:
        return ToolRole::Head;
    case ObjectKind::Jaw:
        return ToolRole::Jaw;
    case ObjectKind::Tube:
        return ToolRole::Tube;
    case ObjectKind::Hand:
        return ToolRole::Hand;
    case ObjectKind::Laryngoscope:
        return ToolRole::Laryngoscope;
    case ObjectKind::Stylus:
        return ToolRole::Stylus;
    case ObjectKind::Patient:
    case ObjectKind::OrganGroup:
    case ObjectKind::SpareTube:
    case ObjectKind::View:
    case ObjectKind::Pointer:
        break;
    }
    return std::nullopt;
}

} // namespace carina
