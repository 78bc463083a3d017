#pragma once

#include "engine/anatomy/anatomy.h"

namespace carina::test
{

/// A closed prism over an ellipse from a to b, with the radius `wide` towards +x as near as the
/// axis allows and `deep` across both; 64 corners, four of them on the axes of the ellipse.
TriangleMesh tubeOf(const Vec3& a, const Vec3& b, double wide, double deep);

/// The closed box between two corners.
TriangleMesh boxOf(const Vec3& low, const Vec3& high);

/// Figures of an airway made of tubes; metres, degrees.
struct KnownAirway {
    double lean = 12.0;    ///< of the trachea, forward on its way up
    double length = 0.100; ///< to the cricoid; the tube goes on for 8 mm
    double coronal = 0.020;
    double sagittal = 0.016;
    double rightAngle = 27.0;
    double leftAngle = 46.0;
    double cords = 0.120;
    double teeth = 0.230; ///< along the path
    std::array<double, 5> lobes_ml{200.0, 100.0, 250.0, 220.0, 230.0};
};

/// A patient of these figures, all lengths times `size` (volumes times its cube). The right
/// bronchus has a branch, whose sections lie beside its own.
Anatomy anatomyOf(const KnownAirway& known, double size = 1.0);

} // namespace carina::test
