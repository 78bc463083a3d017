#include "engine/anatomy/chest/chest_region.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace carina
{
namespace
{

/// Whether one of these words is in the name of a part, in capitals or not.
bool isNamed(const AnatomyPart& part, std::initializer_list<const char*> words)
{
    std::string name = part.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::any_of(
        words, [&name](const char* word) { return name.find(word) != std::string::npos; });
}

} // namespace

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
        return ChestRegion::Wall;
    case PartRole::Tooth:
        return ChestRegion::Teeth;
    case PartRole::Skin:
        return ChestRegion::Skin;
    case PartRole::Trachea:
    case PartRole::Oesophagus:
    case PartRole::Heart:
    case PartRole::Vessel:
        return ChestRegion::Mediastinum;
    case PartRole::Larynx:
    case PartRole::Epiglottis:
    case PartRole::LaryngealMucosa:
    case PartRole::VocalFold:
        return ChestRegion::Larynx;
    case PartRole::Tongue:
    case PartRole::Hyoid: // which gives way to a blade together with the root of the tongue
    case PartRole::Mucosa:
    case PartRole::Muscle:
        return ChestRegion::Throat;
    case PartRole::Pharynx:
        return ChestRegion::Pharynx;
    default:
        return ChestRegion::Still;
    }
}

ChestRegion regionOf(const AnatomyPart& part)
{
    if (part.role == PartRole::Mucosa && isNamed(part, {"palat"}))
        return ChestRegion::Pharynx;
    if (part.role == PartRole::Mucosa && isNamed(part, {"upper jaw", "upper lip"}))
        return ChestRegion::Skin;
    if (part.role == PartRole::Tooth && isNamed(part, {"right upper central"}))
        return ChestRegion::LooseTooth;
    return regionOf(part.role);
}

bool movesWithMandible(const AnatomyPart& part)
{
    if (part.role == PartRole::Mandible)
        return true;
    if (part.role == PartRole::Tooth)
        return isNamed(part, {" lower ", "lower jaw"});
    return (part.role == PartRole::Other || part.role == PartRole::Mucosa)
           && isNamed(part, {"lower jaw", "lower lip"});
}

std::optional<ThroatTissue> tissueOf(ChestRegion region)
{
    switch (region) {
    case ChestRegion::Mediastinum:
    case ChestRegion::Throat:
    case ChestRegion::Larynx:
        return ThroatTissue::Airway;
    case ChestRegion::Pharynx:
        return ThroatTissue::Pharynx;
    default:
        return std::nullopt;
    }
}

std::optional<AirwayTissue> airwayTissueOf(ChestRegion region)
{
    switch (region) {
    case ChestRegion::LooseTooth:
        return AirwayTissue::LooseTooth;
    case ChestRegion::Teeth:
        return AirwayTissue::Teeth;
    case ChestRegion::Skin:
        return AirwayTissue::Skin;
    case ChestRegion::Mediastinum:
        return AirwayTissue::Windpipe;
    case ChestRegion::Throat:
        return AirwayTissue::Throat;
    case ChestRegion::Pharynx:
        return AirwayTissue::Pharynx;
    case ChestRegion::Larynx:
        return AirwayTissue::Larynx;
    default:
        return std::nullopt;
    }
}

} // namespace carina
