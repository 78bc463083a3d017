#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/shapes/implicit_shape.h"

#include <string>

namespace carina
{

/// How a patient lies there: with the mouth shut and the epiglottis over the way into the larynx,
/// or as a laryngoscope holds them, the mouth open, tongue and epiglottis lifted from the way of a
/// tube.
enum class Posture : std::uint8_t { Rest, Laryngoscopy };

/// Where the organs of one patient lie and how large they are. Shapes are written in millimetres of
/// one man, whose surfaces are published (BodyParts3D): positions and sizes were measured there and
/// rounded. Each region has the size against his that its published formulas give.
struct BodyPlan {
    PatientDimensions dimensions;
    Posture posture = Posture::Laryngoscopy;
    AirwayLandmarks landmarks;
    double airway = 1.0; ///< metres for each of his millimetres: windpipe and larynx
    double chest = 1.0;  ///< lungs, ribs, diaphragm
    double face = 1.0;   ///< mouth and jaws

    inline static const Vec3 kEdgeToCarina_mm{0.0, 2.5, 0.4};

    /// From his millimetres, origin at the lowest edge of his trachea, to A: his carina lies 2.5 mm
    /// behind and 0.4 mm above it.
    [[nodiscard]] Vec3 inChest(const Vec3& p_mm) const { return chest * (p_mm - kEdgeToCarina_mm); }
    /// From his millimetres, origin at the edge of his upper incisors, to A.
    [[nodiscard]] Vec3 inFace(const Vec3& p_mm) const
    {
        return landmarks.p_A_incisors + face * p_mm;
    }
};

/// The plan of a patient with these figures.
[[nodiscard]] BodyPlan bodyPlanOf(const PatientDimensions& dimensions, Posture posture);

/// A part of a patient that is still to be meshed.
struct PartPlan {
    std::string name;
    PartRole role = PartRole::Other;
    std::string conceptId;
    ImplicitShape shape;
    Length voxel;
};

} // namespace carina
