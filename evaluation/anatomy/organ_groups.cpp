#include "evaluation/anatomy/organ_groups.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <string_view>

namespace carina
{
namespace
{

bool hasOneOf(const std::string& name, std::initializer_list<std::string_view> words)
{
    return std::ranges::any_of(
        words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// The organ that a part belongs to; empty for what is not compared.
std::string organOf(const AnatomyPart& part)
{
    std::string name = part.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    switch (part.role) {
    case PartRole::Larynx:
        return hasOneOf(name, {"thyroid cartilage", "cricoid cartilage", "arytenoid cartilage",
                               "vocal ligament"})
                   ? "larynx"
                   : "";
    case PartRole::Pharynx:
        return hasOneOf(name, {"constrictor"})                  ? "pharynx"
               : hasOneOf(name, {"hard palate", "soft palate"}) ? name
                                                                : "";
    case PartRole::Tongue:
        return name == "tongue" ? "tongue" : "";
    case PartRole::Tooth:
        return "teeth";
    case PartRole::Rib:
        if (hasOneOf(name, {"sternum", "manubrium", "xiphoid"}))
            return "sternum";
        if (hasOneOf(name, {"clavicle"}))
            return "clavicles";
        return hasOneOf(name, {"scapula"}) ? "" : "ribs";
    case PartRole::Spine:
        if (hasOneOf(name, {"cervical vertebra", "atlas"}) || name == "axis")
            return "cervical spine";
        return hasOneOf(name, {"thoracic vertebra"}) && !hasOneOf(name, {"dis"}) ? "thoracic spine"
                                                                                 : "";
    case PartRole::Skull:
        return hasOneOf(name, {"maxilla"}) ? "maxilla" : "";
    case PartRole::Mucosa:
    case PartRole::VocalFold:
    case PartRole::Hyoid:
    case PartRole::Heart:
    case PartRole::Vessel:
    case PartRole::Muscle:
    case PartRole::Other:
        return "";
    default:
        return roleName(part.role);
    }
}

OrganScale scaleOf(const std::string& organ)
{
    constexpr std::array kChestOrgans{"right_upper_lobe", "right_middle_lobe", "right_lower_lobe",
                                      "left_upper_lobe",  "left_lower_lobe",   "bronchial_tree",
                                      "diaphragm",        "oesophagus",        "ribs",
                                      "sternum",          "clavicles",         "thoracic spine"};
    return std::ranges::find(kChestOrgans, organ) == kChestOrgans.end() ? OrganScale::Airway
                                                                        : OrganScale::Chest;
}

} // namespace

std::map<std::string, Organ> organsOf(const Anatomy& anatomy)
{
    std::map<std::string, Organ> organs;
    for (const AnatomyPart& part : anatomy.parts) {
        std::string name = organOf(part);
        if (name.empty() || part.levels.empty() || part.levels.front().empty())
            continue;
        Organ& organ = organs[name];
        organ.scale = scaleOf(name);
        append(organ.mesh, part.levels.front());
    }
    return organs;
}

} // namespace carina
