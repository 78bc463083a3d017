#include "apps/lab/rendering/headset_series.h"

#include "engine/core/expects.h"

#include <random>

namespace carina::lab
{
namespace
{

/// Numbers that depend on nothing but the seed; the standard library's distributions differ.
class Random
{
public:
    explicit Random(std::uint32_t seed) : m_bits{seed} {}

    double between(double least, double greatest)
    {
        return least + (greatest - least) * (static_cast<double>(m_bits()) / 4294967296.0);
    }
    Vec3 within(double x, double y, double z)
    {
        const double right = between(-x, x);
        const double up = between(-y, y);
        return {right, up, between(-z, z)};
    }

private:
    std::mt19937 m_bits;
};

/// Carina, glottis, incisors, both bases of the lungs, and a place to either side of the head.
std::array<Vec3, HeadsetSeries::kPlaces> placesIn(const AirwayLandmarks& airway)
{
    const Vec3 p_A_aside = 0.5 * (airway.p_A_incisors + airway.p_A_glottis);
    return {airway.p_A_carina,
            airway.p_A_glottis,
            airway.p_A_incisors,
            airway.p_A_carina + Vec3{-0.07, 0.03, -0.10},
            airway.p_A_carina + Vec3{0.07, 0.03, -0.10},
            p_A_aside + Vec3{-0.12, 0.02, 0.01},
            p_A_aside + Vec3{0.12, 0.02, -0.01}};
}

/// A head whose -z axis points from p_A_eyes to a target, and whose y axis is up: before the face
/// of someone who lies on the back, then turned about its own axes.
RigidTransform lookingFrom(const Vec3& p_A_eyes, const Vec3& p_A_target, const Vec3& turn_H)
{
    const Vec3 backward = (p_A_eyes - p_A_target).normalized();
    const Vec3 right = Vec3{0.0, -1.0, 0.0}.cross(backward).normalized();
    Mat3 axes;
    axes << right, backward.cross(right), backward;
    const Quat turned = Quat{Eigen::AngleAxisd{turn_H.norm(), turn_H.normalized()}};
    return {Quat{axes} * turned, p_A_eyes};
}

std::vector<RigidTransform> headPoses(const AirwayLandmarks& airway, int count, Random& random)
{
    std::vector<RigidTransform> poses;
    for (int i = 0; i < count; ++i) {
        const Vec3 p_A_eyes =
            airway.p_A_incisors + Vec3{0.0, -0.30, 0.30} + random.within(0.15, 0.10, 0.15);
        const Vec3 p_A_target =
            0.6 * airway.p_A_incisors + 0.4 * airway.p_A_carina + random.within(0.05, 0.03, 0.05);
        poses.push_back(lookingFrom(p_A_eyes, p_A_target, random.within(0.05, 0.05, 0.35)));
    }
    return poses;
}

/// Eyes 52 to 76 mm apart, not at equal heights and depths; a screen at 0.5 to 2 m that spans about
/// 30 to 70 degrees and lies up to 0.1 of its distance off the middle.
std::vector<DisplayGeometry> displaysOf(int count, Random& random)
{
    std::vector<DisplayGeometry> all;
    for (int i = 0; i < count; ++i) {
        const Vec3 half{0.5 * random.between(0.052, 0.076), 0.0, 0.0};
        const Vec3 between = random.within(0.015, 0.015, 0.015);
        const double distance = random.between(0.5, 2.0);
        const double width = distance * random.between(0.6, 1.4);
        DisplayGeometry display;
        display.p_HDl = between - half + random.within(0.004, 0.004, 0.004);
        display.p_HDr = between + half + random.within(0.004, 0.004, 0.004);
        display.p_HQ_screenCentre =
            Vec3{0.0, 0.0, -distance} + distance * random.within(0.1, 0.1, 0.0);
        display.screenWidth = width;
        display.screenHeight = width / random.between(1.2, 1.9);
        all.push_back(display);
    }
    return all;
}

} // namespace

Result<HeadsetSeries> HeadsetSeries::of(const AirwayLandmarks& airway, const GeometryTrial& trial)
{
    CARINA_EXPECTS(trial.poses > 0 && trial.geometries > 0);
    Random random{trial.seed};
    HeadsetSeries series;
    series.m_p_A = placesIn(airway);
    series.m_X_AH = headPoses(airway, trial.poses, random);
    series.m_displays = displaysOf(trial.geometries, random);
    for (const DisplayGeometry& display : series.m_displays) {
        const auto headset = HeadsetView::of(display);
        if (!headset)
            return tl::unexpected(headset.error());
        series.m_headsets.push_back(*headset);
    }
    return series;
}

std::vector<EyePicture> HeadsetSeries::eyes(std::size_t i) const
{
    PoseSample sample;
    sample.X_FO = head(i);
    return m_headsets[i % m_headsets.size()]
        .eyes(ViewOutput::SideBySide, sample)
        .value_or(std::vector<EyePicture>{});
}

} // namespace carina::lab
