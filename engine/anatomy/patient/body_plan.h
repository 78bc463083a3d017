#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/shapes/implicit_shape.h"

#include <algorithm>
#include <string>

namespace carina
{

/// The posture in which a patient is made. Rest: mouth closed, epiglottis over the entrance of the
/// larynx. Laryngoscopy: mouth open, tongue and epiglottis lifted off the path of a tube, as by a
/// laryngoscope.
enum class Posture : std::uint8_t { Rest, Laryngoscopy };

/// Positions and sizes of one patient's organs. Shapes are defined in millimetres of a reference
/// man, whose surfaces are published (BodyParts3D): positions and sizes were measured there and
/// rounded. Comments call these reference millimetres. Each region of a patient is scaled from them
/// by its own factor, which follows from the patient's dimensions.
struct BodyPlan {
    PatientDimensions dimensions;
    Posture posture = Posture::Laryngoscopy;
    AirwayLandmarks landmarks;
    double airway = 1.0; ///< metres per reference millimetre: trachea and larynx
    double chest = 1.0;  ///< the same for lungs, ribs, diaphragm
    double face = 1.0;   ///< the same for mouth and jaws
    /// How far the throat is drawn out behind the hard palate, from the reference man's: 1 in him,
    /// more in children, whose larynx lies high behind a long tongue.
    double throat = 1.0;
    double infancy =
        0.0;            ///< 1 in a newborn child, 0 in grown people: of forms that change with age
    double youth = 0.0; ///< 1 in a newborn child, 0 from school age on
    /// How far the atlas lies below the level of the palate, where it is in older children: so that
    /// the glottis of an infant is at its vertebra. Metres.
    double atlasBelow = 0.0;

    /// The reference man's first thoracic vertebra, from the lowest edge of his trachea, and his
    /// atlas, from the edge of his upper incisors: it lies at the level of the palate.
    inline static const Vec3 kFirstThoracic_mm{0.0, 7.0, 73.0};
    inline static const Vec3 kAtlas_mm{0.0, 114.0, 18.0};
    /// Behind this y the throat is drawn out; the teeth and the hard palate lie in front of it.
    static constexpr double kBehindPalate_mm = 46.0;

    /// The reference man's carina, from the lowest edge of his trachea.
    inline static const Vec3 kEdgeToCarina_mm{0.0, 2.5, 0.4};

    /// From reference millimetres of the chest, with the origin at the lowest edge of the reference
    /// man's trachea, to A.
    [[nodiscard]] Vec3 inChest(const Vec3& p_mm) const { return chest * (p_mm - kEdgeToCarina_mm); }
    /// From reference millimetres of the face, with the origin at the edge of the upper incisors,
    /// to A.
    [[nodiscard]] Vec3 inFace(const Vec3& p_mm) const
    {
        return landmarks.p_A_incisors + face * p_mm;
    }
    /// The same for what lies in the throat too; and its inverse.
    [[nodiscard]] Vec3 inThroat(const Vec3& p_mm) const
    {
        const double behind = std::max(p_mm.y() - kBehindPalate_mm, 0.0);
        return inFace(p_mm + (throat - 1.0) * behind * Vec3::UnitY());
    }
    [[nodiscard]] Vec3 fromThroat(const Vec3& p_A) const
    {
        const Vec3 p_mm = (p_A - landmarks.p_A_incisors) / face;
        const double behind = std::max(p_mm.y() - kBehindPalate_mm, 0.0);
        return p_mm - (1.0 - 1.0 / throat) * behind * Vec3::UnitY();
    }
};

/// The plan of a patient with these dimensions.
[[nodiscard]] BodyPlan bodyPlanOf(const PatientDimensions& dimensions, Posture posture);

/// A part of a patient before it is meshed.
struct PartPlan {
    std::string name;
    PartRole role = PartRole::Other;
    std::string conceptId; ///< FMA id
    ImplicitShape shape;   ///< in A
    Length voxel;          ///< edge of the grid cells of its mesh
    FinePlace fine{};      ///< where they are smaller
};

} // namespace carina
