#pragma once

#include "engine/geometry/rotation.h"
#include "engine/io/site_file.h"

namespace carina::test
{

/// A site with everything in it, each value another.
inline Site wholeSite()
{
    const LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), "0f3a");
    Site site;
    site.step = SiteStep::Verify;
    site.tracker = "simulated";
    site.stylus = StylusTip{{0.001, -0.002, -0.15}, 0.31e-3, "2004-03-27T10:15:00Z"};
    site.catalogue = catalogue;
    for (const Landmark& landmark : catalogue.landmarks)
        site.touched.push_back({landmark.name, landmark.p_AQ + Vec3{0.2, -0.1, -1.7}, 0.4e-3});
    site.registration = SiteRegistration{
        .X_AM = {rotationFromVector({0.1, 0.2, -0.3}), {0.01, -0.02, 0.03}},
        .X_AT = {rotationFromVector({1.1, -0.2, 2.0}), {-0.5, 0.25, 1.7}},
        .X_JM = RigidTransform{rotationFromVector({-0.4, 0.0, 0.1}), {0.0, 0.05, -0.2}},
        .rms = 0.72e-3,
        .residuals = {{catalogue.landmarks[0].name, 0.5e-3},
                      {catalogue.landmarks[1].name, 0.9e-3}}};
    site.display =
        DisplayGeometry{{-0.032, 0.001, 0.0}, {0.031, 0.002, 0.0}, {0.0, -0.003, -1.0}, 0.8, 0.45};
    return site;
}

} // namespace carina::test
