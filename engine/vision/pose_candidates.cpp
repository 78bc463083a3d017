#include "engine/vision/pose_candidates.h"

#include <Eigen/Eigenvalues>

#include <opencv2/calib3d.hpp>

namespace carina
{
namespace
{

constexpr double kFlat = 1e-3; ///< thickness over extent, below which corners are in one plane

bool isFlat(std::span<const SeenCorner> corners)
{
    Vec3 mean = Vec3::Zero();
    for (const SeenCorner& corner : corners)
        mean += corner.p_BQ / double(corners.size());
    Mat3 spread = Mat3::Zero();
    for (const SeenCorner& corner : corners)
        spread += (corner.p_BQ - mean) * (corner.p_BQ - mean).transpose();
    const Vec3 extents = Eigen::SelfAdjointEigenSolver<Mat3>{spread}.eigenvalues();
    return extents[0] < kFlat * kFlat * extents[2];
}

/// From OpenCV's camera, which has +y down and looks along +z.
std::optional<RigidTransform> fromOpenCv(const cv::Mat& rotation, const cv::Mat& translation)
{
    cv::Mat R;
    cv::Rodrigues(rotation, R);
    Mat4 X = Mat4::Identity();
    const Vec3 signs{1.0, -1.0, -1.0};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            X(row, column) = signs[row] * R.at<double>(row, column);
        X(row, 3) = signs[row] * translation.at<double>(row);
    }
    const auto pose = RigidTransform::fromMatrix(X);
    return pose ? std::optional{*pose} : std::nullopt;
}

} // namespace

std::vector<RigidTransform> poseCandidates(const CameraModel& camera,
                                           std::span<const SeenCorner> corners)
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> seen;
    for (const SeenCorner& corner : corners) {
        points.emplace_back(corner.p_BQ.x(), corner.p_BQ.y(), corner.p_BQ.z());
        const Vec3 sight = sightOf(camera, corner.pixel);
        seen.emplace_back(sight.x(), -sight.y());
    }
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    try {
        cv::solvePnPGeneric(points, seen, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), rotations,
                            translations, false,
                            isFlat(corners) ? cv::SOLVEPNP_IPPE : cv::SOLVEPNP_SQPNP);
    } catch (const cv::Exception&) {
        return {}; // corners of which no pose follows
    }
    std::vector<RigidTransform> poses;
    for (std::size_t i = 0; i < rotations.size(); ++i)
        if (const auto pose = fromOpenCv(rotations[i], translations[i]))
            poses.push_back(*pose);
    return poses;
}

} // namespace carina
