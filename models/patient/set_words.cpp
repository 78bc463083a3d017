#include "models/patient/set_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

QString said(const char* text) { return QCoreApplication::translate("SetWords", text); }

/// One word for each direction of each axis of the body: along it, against it.
QString directionWord(int direction, bool along)
{
    switch (direction) {
    case 0:
        return along ? said("left") : said("right");
    case 1:
        return along ? said("posterior") : said("anterior");
    default:
        return along ? said("superior") : said("inferior");
    }
}

} // namespace

QString roleWord(PartRole role)
{
    switch (role) {
    case PartRole::Trachea:
        return said("Trachea");
    case PartRole::RightMainBronchus:
        return said("Right main bronchus");
    case PartRole::LeftMainBronchus:
        return said("Left main bronchus");
    case PartRole::BronchialTree:
        return said("Bronchi within the lungs");
    case PartRole::Larynx:
        return said("Larynx");
    case PartRole::Epiglottis:
        return said("Epiglottis");
    case PartRole::RightUpperLobe:
        return said("Right upper lobe");
    case PartRole::RightMiddleLobe:
        return said("Right middle lobe");
    case PartRole::RightLowerLobe:
        return said("Right lower lobe");
    case PartRole::LeftUpperLobe:
        return said("Left upper lobe");
    case PartRole::LeftLowerLobe:
        return said("Left lower lobe");
    case PartRole::RightLung:
        return said("Right lung, whole");
    case PartRole::LeftLung:
        return said("Left lung, whole");
    case PartRole::Diaphragm:
        return said("Diaphragm");
    case PartRole::Mandible:
        return said("Mandible");
    case PartRole::Tooth:
        return said("Tooth or gum");
    case PartRole::Tongue:
        return said("Tongue");
    case PartRole::Pharynx:
        return said("Mouth, palate, pharynx");
    case PartRole::Oesophagus:
        return said("Oesophagus");
    case PartRole::Skull:
        return said("Skull");
    case PartRole::Spine:
        return said("Spine");
    case PartRole::Rib:
        return said("Rib, sternum, shoulder");
    case PartRole::Heart:
        return said("Heart");
    case PartRole::Vessel:
        return said("Vessel");
    case PartRole::Muscle:
        return said("Muscle");
    case PartRole::Skin:
        return said("Skin");
    case PartRole::Mucosa:
        return said("Lining of mouth and throat");
    case PartRole::LaryngealMucosa:
        return said("Lining of the larynx");
    case PartRole::VocalFold:
        return said("Vocal fold");
    case PartRole::Hyoid:
        return said("Hyoid bone");
    case PartRole::Other:
        return said("Something else");
    }
    return {};
}

std::vector<PartRole> allRoles()
{
    std::vector<PartRole> roles;
    for (int role = 0; role <= static_cast<int>(PartRole::Other); ++role)
        roles.push_back(static_cast<PartRole>(role));
    return roles;
}

std::vector<UnitChoice> unitChoices()
{
    return {{1e-3, said("millimetres")},
            {1e-2, said("centimetres")},
            {1.0, said("metres")},
            {0.0254, said("inches")}};
}

QString axesWord(const Mat3& R_AF)
{
    std::array<QString, 3> words;
    for (int axis = 0; axis < 3; ++axis) {
        int direction = 0;
        R_AF.col(axis).cwiseAbs().maxCoeff(&direction);
        words[static_cast<std::size_t>(axis)] =
            directionWord(direction, R_AF(direction, axis) > 0.0);
    }
    return said("x %1, y %2, z %3").arg(words[0], words[1], words[2]);
}

std::vector<AxesChoice> axesChoices()
{
    std::vector<AxesChoice> choices;
    std::array order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Mat3 R_AF = Mat3::Zero();
            for (int axis = 0; axis < 3; ++axis)
                R_AF(order[static_cast<std::size_t>(axis)], axis) =
                    (signs >> axis & 1) == 0 ? 1.0 : -1.0;
            if (R_AF.determinant() > 0.0)
                choices.push_back({R_AF, axesWord(R_AF)});
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return choices;
}

} // namespace carina
