#include "engine/anatomy/organ_group.h"

#include <algorithm>

namespace carina
{

OrganGroup groupOf(PartRole role)
{
    if (lungSide(role))
        return OrganGroup::Lungs;
    switch (role) {
    case PartRole::Trachea:
    case PartRole::RightMainBronchus:
    case PartRole::LeftMainBronchus:
    case PartRole::BronchialTree:
    case PartRole::Larynx:
    case PartRole::Epiglottis:
    case PartRole::Tongue:
    case PartRole::Pharynx:
    case PartRole::Mucosa:
    case PartRole::LaryngealMucosa:
    case PartRole::VocalFold:
    case PartRole::Hyoid:
        return OrganGroup::Airway;
    case PartRole::Mandible:
    case PartRole::Tooth:
    case PartRole::Skull:
    case PartRole::Spine:
    case PartRole::Rib:
        return OrganGroup::Skeleton;
    case PartRole::Heart:
    case PartRole::Vessel:
        return OrganGroup::Vessels;
    case PartRole::Diaphragm:
    case PartRole::Muscle:
        return OrganGroup::Muscles;
    default:
        return OrganGroup::Other;
    }
}

const char* groupName(OrganGroup group)
{
    switch (group) {
    case OrganGroup::Airway:
        return "airway";
    case OrganGroup::Lungs:
        return "lungs";
    case OrganGroup::Skeleton:
        return "skeleton";
    case OrganGroup::Vessels:
        return "vessels";
    case OrganGroup::Muscles:
        return "muscles";
    case OrganGroup::Other:
        return "other";
    }
    return "";
}

std::optional<OrganGroup> groupFromName(std::string_view name)
{
    const auto found = std::ranges::find_if(
        kOrganGroups, [name](OrganGroup group) { return name == groupName(group); });
    return found == kOrganGroups.end() ? std::nullopt : std::optional{*found};
}

} // namespace carina
