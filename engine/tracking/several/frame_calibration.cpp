#include "engine/tracking/several/frame_calibration.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/several/body_motion.h"
#include "engine/tracking/time_shift.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

using Mat9 = Eigen::Matrix<double, 9, 9>;
using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;
using Vec12 = Eigen::Matrix<double, 12, 1>;

constexpr int kMostSteps = 20;
constexpr double kDone = 1e-12; ///< change of all parameters together, rad and m
constexpr double kOutlierShare = 6.0;
constexpr int kOutlierRounds = 3;
// Residuals below are rounding; weights are not derived from them.
constexpr double kLeastPosition = 1e-9;
constexpr double kLeastTurn = 1e-9;

struct Frames {
    RigidTransform X_TD;
    RigidTransform X_OP;
};

/// The rotation next to a matrix.
Mat3 nearestRotation(const Mat3& matrix)
{
    const Eigen::JacobiSVD<Mat3> svd{matrix, Eigen::ComputeFullU | Eigen::ComputeFullV};
    Vec3 signs = Vec3::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

Mat3 crossOf(const Vec3& v)
{
    Mat3 cross;
    cross << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return cross;
}

/// How much the body was turned about its second axis, RMS about the mean.
Angle secondTurn(const std::vector<BodySeenTwice>& pairs)
{
    std::vector<RigidTransform> poses;
    for (const BodySeenTwice& pair : pairs)
        poses.push_back(pair.X_TO);
    return bodyMotion(poses).turned[1];
}

/// The rotations by the largest singular value of mean(R_DP kron R_TO), which takes vec(R_OP) to
/// vec(R_TD); then the translations, which are linear in them.
Frames closedForm(const std::vector<BodySeenTwice>& pairs)
{
    Mat9 mean = Mat9::Zero();
    for (const BodySeenTwice& pair : pairs) {
        const Mat3 R_TO = pair.X_TO.rotation().toRotationMatrix();
        const Mat3 R_DP = pair.X_DP.rotation().toRotationMatrix();
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                mean.block<3, 3>(3 * row, 3 * column) += R_DP(row, column) * R_TO;
    }
    const Eigen::JacobiSVD<Mat9> svd{mean, Eigen::ComputeFullU | Eigen::ComputeFullV};
    const Vec9 vec_TD = svd.matrixU().col(0);
    const Vec9 vec_OP = svd.matrixV().col(0);
    Mat3 R_TD = Eigen::Map<const Mat3>(vec_TD.data());
    Mat3 R_OP = Eigen::Map<const Mat3>(vec_OP.data());
    if (R_TD.determinant() < 0.0) { // the sign of both is free
        R_TD = -R_TD;
        R_OP = -R_OP;
    }
    const Quat q_TD{nearestRotation(R_TD)};
    const Quat q_OP{nearestRotation(R_OP)};
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (const BodySeenTwice& pair : pairs) {
        Eigen::Matrix<double, 3, 6> row; // of p_OP and p_TD
        row << pair.X_TO.rotation().toRotationMatrix(), -Mat3::Identity();
        normal += row.transpose() * row;
        right += row.transpose() * (q_TD * pair.X_DP.translation() - pair.X_TO.translation());
    }
    const Eigen::Matrix<double, 6, 1> both = normal.ldlt().solve(right);
    return {{q_TD, both.tail<3>()}, {q_OP, both.head<3>()}};
}

/// How far one pair is off, in axes of T.
struct Misfit {
    Vec3 p;
    Vec3 turn;
};

Misfit misfitOf(const BodySeenTwice& pair, const Frames& frames)
{
    const RigidTransform X_TP_first = pair.X_TO * frames.X_OP;
    const RigidTransform X_TP_second = frames.X_TD * pair.X_DP;
    return {X_TP_first.translation() - X_TP_second.translation(),
            rotationVector(X_TP_first.rotation() * X_TP_second.rotation().conjugate())};
}

/// Root mean squares over pairs.
struct Misfits {
    double p = 0.0;
    double turn = 0.0;
};

Misfits misfitsOf(const std::vector<BodySeenTwice>& pairs, const Frames& frames)
{
    Misfits sums;
    for (const BodySeenTwice& pair : pairs) {
        const Misfit misfit = misfitOf(pair, frames);
        sums.p += misfit.p.squaredNorm();
        sums.turn += misfit.turn.squaredNorm();
    }
    const auto count = double(pairs.size());
    return {std::sqrt(sums.p / count), std::sqrt(sums.turn / count)};
}

/// One Gauss-Newton step, with the weights of the residuals before it: turns and shifts of D in T,
/// and of P in O, on the left. @returns its length.
double improve(const std::vector<BodySeenTwice>& pairs, Frames& frames)
{
    const Misfits before = misfitsOf(pairs, frames);
    const double perPosition = 1.0 / std::max(before.p, kLeastPosition);
    const double perTurn = 1.0 / std::max(before.turn, kLeastTurn);
    Mat12 normal = Mat12::Zero();
    Vec12 right = Vec12::Zero();
    for (const BodySeenTwice& pair : pairs) {
        const Misfit misfit = misfitOf(pair, frames);
        const Mat3 R_TO = pair.X_TO.rotation().toRotationMatrix();
        Eigen::Matrix<double, 6, 12> slope = Eigen::Matrix<double, 6, 12>::Zero();
        // Of D: turn about the origin of T, shift. Of P: turn about its own origin, shift.
        slope.block<3, 3>(0, 0) =
            perPosition * crossOf(frames.X_TD.rotation() * pair.X_DP.translation());
        slope.block<3, 3>(0, 3) = -perPosition * Mat3::Identity();
        slope.block<3, 3>(0, 9) = perPosition * R_TO;
        slope.block<3, 3>(3, 0) = -perTurn * Mat3::Identity();
        slope.block<3, 3>(3, 6) = perTurn * R_TO;
        Eigen::Matrix<double, 6, 1> residual;
        residual << perPosition * misfit.p, perTurn * misfit.turn;
        normal += slope.transpose() * slope;
        right -= slope.transpose() * residual;
    }
    const Vec12 step = normal.ldlt().solve(right);
    const auto moved = [&step](const RigidTransform& X, int from) {
        return RigidTransform{rotationFromVector(step.segment<3>(from)) * X.rotation(),
                              X.translation() + step.segment<3>(from + 3)};
    };
    frames = {moved(frames.X_TD, 0), moved(frames.X_OP, 6)};
    return step.norm();
}

/// Leaves out what is far off. @returns how many pairs those are.
std::size_t leaveOut(std::vector<BodySeenTwice>& pairs, const Frames& frames)
{
    std::vector<double> p;
    std::vector<double> turns;
    for (const BodySeenTwice& pair : pairs) {
        const Misfit misfit = misfitOf(pair, frames);
        p.push_back(misfit.p.norm());
        turns.push_back(misfit.turn.norm());
    }
    const auto limitOf = [](std::vector<double> values, double least) {
        const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return kOutlierShare * std::max(*middle, least);
    };
    const double farthest = limitOf(p, kLeastPosition);
    const double widest = limitOf(turns, kLeastTurn);
    std::vector<BodySeenTwice> kept;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (p[i] <= farthest && turns[i] <= widest)
            kept.push_back(pairs[i]);
    const std::size_t left = pairs.size() - kept.size();
    pairs = std::move(kept);
    return left;
}

Frames bestFrames(const std::vector<BodySeenTwice>& pairs)
{
    Frames frames = closedForm(pairs);
    for (int i = 0; i < kMostSteps && improve(pairs, frames) > kDone; ++i)
        ;
    return frames;
}

bool isFinite(const BodySeenTwice& pair)
{
    return pair.X_TO.matrix().allFinite() && pair.X_DP.matrix().allFinite();
}

} // namespace

std::vector<BodySeenTwice> seenTwice(std::span<const PoseSample> first,
                                     std::span<const PoseSample> second, Duration late)
{
    PoseHistory seconds{{.capacity = second.size()}};
    for (const PoseSample& sample : second)
        seconds.push(sample);
    std::vector<BodySeenTwice> pairs;
    for (const PoseSample& sample : first) {
        if (sample.validity == Validity::Lost)
            continue;
        const auto other = seconds.at(sample.time + late);
        if (other && other->validity != Validity::Lost && other->how != How::Predicted)
            pairs.push_back({sample.X_FO, other->X_FO});
    }
    return pairs;
}

Result<FrameCalibration> calibrateFrames(std::span<const BodySeenTwice> pairs)
{
    if (!std::ranges::all_of(pairs, isFinite))
        return fail(Errc::NotFinite, "a pose");
    std::vector<BodySeenTwice> used{pairs.begin(), pairs.end()};
    Frames frames;
    for (int round = 0; round <= kOutlierRounds; ++round) {
        if (used.size() < kFewestSeenTwice)
            return fail(Errc::TooFewPoses, std::to_string(used.size()) + " moments, and "
                                               + std::to_string(kFewestSeenTwice) + " are due");
        if (secondTurn(used) < kLeastTurnTwice)
            return fail(Errc::NotEnoughMotion, "the body was not turned about two axes");
        frames = bestFrames(used);
        if (round < kOutlierRounds && leaveOut(used, frames) == 0)
            break;
    }
    const Misfits misfits = misfitsOf(used, frames);
    return FrameCalibration{.place = {.X_FD = frames.X_TD},
                            .X_OP = frames.X_OP,
                            .rms = metres(misfits.p),
                            .turn = radians(misfits.turn),
                            .pairs = used.size(),
                            .outliers = pairs.size() - used.size()};
}

Result<FrameCalibration> calibrateFrames(std::span<const PoseSample> first,
                                         std::span<const PoseSample> second)
{
    return timeShift(first, second).and_then([&](const TimeShift& shift) {
        return calibrateFrames(seenTwice(first, second, shift.late))
            .map([&](FrameCalibration calibration) {
                calibration.place.late = shift.late;
                return calibration;
            });
    });
}

bool isAcceptable(const FrameCalibration& found)
{
    return found.rms <= kWorstFit && found.turn <= kWorstTurn;
}

} // namespace carina
