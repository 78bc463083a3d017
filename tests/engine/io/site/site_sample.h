#pragma once

#include "engine/geometry/rotation.h"
#include "engine/io/site/site_file.h"

namespace carina::test
{

/// A covariance with other numbers everywhere, of lengths about a tenth of a millimetre.
template <int Size> Eigen::Matrix<double, Size, Size> someCovariance()
{
    Eigen::Matrix<double, Size, Size> factor = Eigen::Matrix<double, Size, Size>::Identity();
    for (int row = 0; row < Size; ++row)
        for (int column = 0; column <= row; ++column)
            factor(row, column) += 0.1 * row - 0.07 * column;
    return 1e-8 * factor * factor.transpose();
}

inline std::vector<StylusTip> wholeStyluses()
{
    return {{.p_SQ = {0.001, -0.002, -0.15},
             .rms = 0.31e-3,
             .calibratedAt = "2004-03-27T10:15:00Z",
             .tool = "Stylus",
             .covariance_S = someCovariance<3>(),
             .poses = 321,
             .outliers = 7,
             .axis = StylusAxis{.axis_S = Vec3{0.0, -0.6, -0.8},
                                .wobble = degrees(0.25),
                                .calibratedAt = "2004-03-27T10:18:00Z"}},
            {.p_SQ = {0.0, 0.003, -0.21},
             .rms = 0.42e-3,
             .calibratedAt = "2004-02-01T09:00:00Z",
             .tool = "Pointer"}};
}

inline SiteRegistration wholeRegistration(const LandmarkCatalogue& catalogue)
{
    return {.X_AM = {rotationFromVector({0.1, 0.2, -0.3}), {0.01, -0.02, 0.03}},
            .X_AT = {rotationFromVector({1.1, -0.2, 2.0}), {-0.5, 0.25, 1.7}},
            .X_JM = RigidTransform{rotationFromVector({-0.4, 0.0, 0.1}), {0.0, 0.05, -0.2}},
            .X_BM = RigidTransform{rotationFromVector({0.0, 0.7, 0.1}), {0.1, 0.02, -0.3}},
            .rms = 0.72e-3,
            .residuals = {{catalogue.landmarks[0].name, 0.5e-3, 0.8e-3},
                          {catalogue.landmarks[1].name, 0.9e-3, std::nullopt}},
            .covariance_A = someCovariance<6>(),
            .fle = 1.1e-3,
            .degrees = 6.0,
            .pooled = 2,
            .disagreeing = 1,
            .madeAt = "2004-03-27T10:30:00Z",
            .operatorName = "M. Keller",
            .swab = SiteSwab{.surface = "Left fifth rib",
                             .points = 120,
                             .outliers = 3,
                             .startRms = 1.4e-3,
                             .rms = 0.4e-3,
                             .moved = 2.5e-3},
            .relays = {{"2004-03-28T08:00:00Z", "A. Frei", 3, 0.9e-3},
                       {"2004-03-29T08:30:00Z", {}, 4, 0.7e-3}},
            .stale = StaleCause::Touches};
}

inline SiteVerification wholeVerification()
{
    return {.verdict = Verdict::NotGood,
            .at = "2004-03-27T10:40:00Z",
            .operatorName = "A. Frei",
            .points = {{"Upper incisors", {0.0, -0.1, 0.17}, {0.3, 0.2, -1.5}, 1.2e-3, 2.4e-3},
                       {"Place 1", {0.02, -0.11, 0.0}, {0.1, 0.2, -1.6}, 2.6e-3, 2.2e-3}},
            .stale = StaleCause::Fit};
}

inline ManikinProfile wholeManikin()
{
    return {.name = "Our head",
            .note = "Bought in 2003.",
            .landmarks = {"Sternal notch", "Xiphoid process"},
            .landmarksSource = "its handbook",
            .patient = "45 years, 182 cm, man",
            .patientSource = "its maker",
            .teethToCarina = SourcedLength{millimetres(251.0), "CT of 2003"}};
}

inline std::vector<SiteTool> wholeTools()
{
    return {{.role = ToolRole::Tube,
             .tool = "ETT",
             .X_NO = {rotationFromVector({0.2, 0.5, -0.1}), {0.01, -0.05, 0.02}},
             .tube = TubeRest{.length = millimetres(301.0),
                              .bends = {7.0, 6.5},
                              .outerDiameter = millimetres(10.2)},
             .rms = 0.21e-3,
             .fle = 0.35e-3,
             .degrees = 5.0,
             .covariance_N = someCovariance<3>(),
             .touches = 9,
             .calibratedAt = "2004-03-27T10:19:00Z",
             .operatorName = "A. Frei",
             .check = SiteToolCheck{.tip = {millimetres(0.4), millimetres(1.2)},
                                    .at = "2004-03-28T10:19:00Z"},
             .stale = StaleCause::Stylus},
            {.role = ToolRole::Laryngoscope,
             .X_NO = RigidTransform::translation({0.0, -0.17, 0.01}),
             .blade = BladeShape{.heelWidth = millimetres(16.0),
                                 .handle = millimetres(152.0),
                                 .p_L_tip = {0.0, 0.011, -0.131},
                                 .p_L_half = {0.0, -0.012, -0.066}},
             .rms = 0.3e-3,
             .fle = 0.5e-3,
             .degrees = 3.0,
             .touches = 5,
             .calibratedAt = "2004-03-27T10:25:00Z"}};
}

/// A site with everything in it, each value another.
inline Site wholeSite()
{
    const LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), "0f3a");
    Site site;
    site.step = SiteStep::Verify;
    site.operatorName = "A. Frei";
    site.tracker = "simulated";
    site.styluses = wholeStyluses();
    site.tools = wholeTools();
    site.patient = "Adult";
    site.catalogue = catalogue;
    for (const Landmark& landmark : catalogue.landmarks)
        site.touched.push_back(
            {.landmark = landmark.name,
             .p_TQ = landmark.p_AQ + Vec3{0.2, -0.1, -1.7},
             .spread = 0.4e-3,
             .q_TS = rotationFromVector({0.3, double(site.touched.size()), -0.2})});
    site.touched[2].stale = StaleCause::Landmarks;
    site.touched[1].isFitted = true;
    site.touched[3].seenError = 0.63e-3;
    site.registration = wholeRegistration(catalogue);
    site.localisations = {{1.3e-3, 18.0, "2004-02-28T09:30:00Z", "M. Keller"},
                          {0.9e-3, 6.0, {}, {}}};
    site.verification = wholeVerification();
    site.display =
        DisplayGeometry{{-0.032, 0.001, 0.0}, {0.031, 0.002, 0.0}, {0.0, -0.003, -1.0}, 0.8, 0.45};
    site.manikin = {.profile = wholeManikin(),
                    .measuredTeethToCarina = millimetres(247.0),
                    .airway = {{AirwayPlace::Incisors, {0.01, -0.1, 0.2}},
                               {AirwayPlace::Carina, {-0.01, 0.05, 0.003}}},
                    .registeredAt = "2004-03-27T10:30:00Z"};
    return site;
}

} // namespace carina::test
