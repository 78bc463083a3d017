#include "engine/anatomy/chest_region.h"

namespace carina
{

ChestRegion regionOf(PartRole role)
{
    switch (role) {
    case PartRole::RightUpperLobe:
    case PartRole::RightMiddleLobe:
    case PartRole::RightLung:
        return ChestRegion::RightUpperLung;
    case PartRole::RightLowerLobe:
        return ChestRegion::RightLowerLung;
    case PartRole::LeftUpperLobe:
    case PartRole::LeftLung:
        return ChestRegion::LeftUpperLung;
    case PartRole::LeftLowerLobe:
        return ChestRegion::LeftLowerLung;
    case PartRole::RightMainBronchus:
    case PartRole::LeftMainBronchus:
    case PartRole::BronchialTree:
        return ChestRegion::Bronchi;
    case PartRole::Diaphragm:
        return ChestRegion::Diaphragm;
    case PartRole::Rib:
    case PartRole::Skin:
        return ChestRegion::Wall;
    case PartRole::Trachea:
    case PartRole::Oesophagus:
    case PartRole::Heart:
    case PartRole::Vessel:
        return ChestRegion::Mediastinum;
    default:
        return ChestRegion::Still;
    }
}

} // namespace carina
