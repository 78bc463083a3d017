#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"
#include "engine/lungs/drawing/chest_pose.h"

#include <QString>

#include <span>
#include <vector>

namespace carina::lab
{

/// Points of one person's lungs, found at the end of expiration and again at the end of
/// inspiration.
struct LandmarkCase {
    QString name; ///< of the file
    std::vector<Vec3> p_A_exhaled;
    std::vector<Vec3> p_A_inhaled; ///< as many

    friend bool operator==(const LandmarkCase& a, const LandmarkCase& b)
    {
        return a.p_A_exhaled == b.p_A_exhaled && a.p_A_inhaled == b.p_A_inhaled;
    }
};

/// Reads landmarks as DIR-Lab's are given: columns ee_x_mm, ee_y_mm, ee_z_mm (exhaled) and ei_x_mm,
/// ei_y_mm, ei_z_mm (inhaled); z grows towards the feet.
/// @returns FileNotFound, FileEmpty, FileMalformed with a sentence; TooFewLandmarks where a box
///          around them has no size.
[[nodiscard]] Result<LandmarkCase> readLandmarkCase(const QString& file);

/// How landmarks within the lungs move in quiet breathing, but for how far. Fitted to five people
/// unless given (docs/deformation.md).
struct BreathingConstants {
    double frontShare = ChestField::kFrontShare;
    LungPose breath{.diaphragm = 1.0, .ribs = 0.09, .gravity = 0.15};
};

/// How landmarks that move by the field compare with landmarks that moved.
struct LandmarkResiduals {
    double amplitude = 0.0; ///< of the breath; the least squares' best
    Vec3 size_A = Vec3::Zero();
    double meanMotion_mm = 0.0;
    double meanResidual_mm = 0.0;
    double maxResidual_mm = 0.0;
    /// Means of what simpler models leave, each fitted to these landmarks themselves: a shift to
    /// the feet in proportion to the distance from the apex, and an affine map.
    double meanResidualOfShift_mm = 0.0;
    double meanResidualOfAffine_mm = 0.0;

    [[nodiscard]] double ratio() const { return meanResidual_mm / meanMotion_mm; }
};

/// Moves the exhaled landmarks by the field of a chest that their bounding box stands for, with the
/// hila where they usually are in it, and one amplitude.
[[nodiscard]] LandmarkResiduals residualsOf(const LandmarkCase& landmarks,
                                            const BreathingConstants& constants);

/// The three constants (how far the front descends, how far ribs and inside move with the
/// diaphragm) that leave the least sum of squared residuals, each person's in units of that
/// person's mean motion and each with an amplitude of its own. @pre there are cases.
[[nodiscard]] BreathingConstants fitConstants(std::span<const LandmarkCase> cases);

} // namespace carina::lab
