#include "apps/lab/deformation/landmark_motion.h"

#include "apps/lab/command/csv_table.h"
#include "engine/core/expects.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <QFileInfo>

#include <algorithm>
#include <numeric>

namespace carina::lab
{
namespace
{

/// Where the airway enters the lungs in the box around their landmarks: u to either side, v, h.
constexpr double kHilum_u = 0.3;
constexpr double kHilum_v = 0.55;
constexpr double kHilum_h = 0.45;

/// The rounds of a fit that takes turns between constants and amplitudes; each at least halves what
/// is left to gain.
constexpr int kRounds = 60;

/// What the constants multiply: descent of the back, what the front adds to it, ribs, gravity.
constexpr int kParts = 4;
using Weights = Eigen::Matrix<double, kParts, 1>;
using Basis = Eigen::Matrix<double, Eigen::Dynamic, kParts>; ///< three rows for each landmark

Box boxAround(const std::vector<Vec3>& points)
{
    Box box;
    for (const Vec3& p : points)
        box.include(p);
    return box;
}

ChestField fieldAround(const LandmarkCase& landmarks, double frontShare)
{
    const Box box_A = boxAround(landmarks.p_A_exhaled);
    const Vec3 size = box_A.size();
    const Vec3 middle{box_A.centre().x(), box_A.min.y() + kHilum_v * size.y(),
                      box_A.max.z() - kHilum_h * size.z()};
    const Vec3 toSide{0.5 * kHilum_u * size.x(), 0.0, 0.0};
    return {box_A, middle - toSide, middle + toSide, frontShare};
}

Eigen::VectorXd displacements(const LandmarkCase& landmarks, double frontShare,
                              const LungPose& lung)
{
    const ChestField field = fieldAround(landmarks, frontShare);
    const ChestMotion motion = motionOf(ChestRegion::Bronchi, {{lung, lung}, 0.0}, field);
    Eigen::VectorXd d(3 * landmarks.p_A_exhaled.size());
    for (std::size_t i = 0; i < landmarks.p_A_exhaled.size(); ++i)
        d.segment<3>(3 * static_cast<Eigen::Index>(i)) =
            field.at(landmarks.p_A_exhaled[i], motion).d_A;
    return d;
}

Eigen::VectorXd motions(const LandmarkCase& landmarks)
{
    Eigen::VectorXd m(3 * landmarks.p_A_exhaled.size());
    for (std::size_t i = 0; i < landmarks.p_A_exhaled.size(); ++i)
        m.segment<3>(3 * static_cast<Eigen::Index>(i)) =
            landmarks.p_A_inhaled[i] - landmarks.p_A_exhaled[i];
    return m;
}

double meanLength(const Eigen::VectorXd& vectors)
{
    const auto columns = vectors.reshaped(3, vectors.size() / 3);
    return columns.colwise().norm().mean();
}

/// One person, in units of that person's mean motion.
struct Person {
    Basis basis;
    Eigen::VectorXd motion;
};

Person personOf(const LandmarkCase& landmarks)
{
    Person person{Basis(3 * landmarks.p_A_exhaled.size(), kParts), motions(landmarks)};
    const Eigen::VectorXd back = displacements(landmarks, 0.0, {.diaphragm = 1.0});
    person.basis.col(0) = back;
    person.basis.col(1) = displacements(landmarks, 1.0, {.diaphragm = 1.0}) - back;
    person.basis.col(2) = displacements(landmarks, 0.0, {.ribs = 1.0});
    person.basis.col(3) = displacements(landmarks, 0.0, {.gravity = 1.0});
    const double unit = meanLength(person.motion) * std::sqrt(double(person.motion.size()));
    person.basis /= unit;
    person.motion /= unit;
    return person;
}

/// Down by the distance from the apex, as a share of the height.
Eigen::VectorXd shiftFromApex(const LandmarkCase& landmarks)
{
    const Box box_A = boxAround(landmarks.p_A_exhaled);
    Eigen::VectorXd d(3 * landmarks.p_A_exhaled.size());
    for (std::size_t i = 0; i < landmarks.p_A_exhaled.size(); ++i) {
        const double below = box_A.max.z() - landmarks.p_A_exhaled[i].z();
        d.segment<3>(3 * static_cast<Eigen::Index>(i)) = -below / box_A.size().z() * Vec3::UnitZ();
    }
    return d;
}

/// What the affine map of least squares leaves of a motion.
Eigen::VectorXd residualOfAffine(const LandmarkCase& landmarks, const Eigen::VectorXd& motion)
{
    const auto count = static_cast<Eigen::Index>(landmarks.p_A_exhaled.size());
    Eigen::MatrixX4d places(count, 4);
    for (Eigen::Index i = 0; i < count; ++i)
        places.row(i) << landmarks.p_A_exhaled[std::size_t(i)].transpose(), 1.0;
    const Eigen::MatrixX3d moved = motion.reshaped(3, count).transpose();
    const Eigen::MatrixX3d left = moved - places * places.colPivHouseholderQr().solve(moved);
    return left.transpose().reshaped();
}

double bestAmplitude(const Eigen::VectorXd& moved, const Eigen::VectorXd& motion)
{
    return moved.dot(motion) / moved.squaredNorm();
}

} // namespace

Result<LandmarkCase> readLandmarkCase(const QString& file)
{
    const auto table =
        CsvTable::read(file, {"ee_x_mm", "ee_y_mm", "ee_z_mm", "ei_x_mm", "ei_y_mm", "ei_z_mm"});
    if (!table)
        return tl::unexpected(table.error());
    LandmarkCase landmarks;
    landmarks.name = QFileInfo{file}.fileName();
    for (std::size_t row = 0; row < table->rows(); ++row) {
        std::array<double, 6> mm{};
        for (std::size_t column = 0; column < mm.size(); ++column) {
            const auto number = table->number(row, column);
            if (!number)
                return tl::unexpected(number.error());
            if (!std::isfinite(*number))
                return fail(Errc::NotFinite, file.toStdString() + " has a landmark without place.");
            mm[column] = *number;
        }
        landmarks.p_A_exhaled.emplace_back(1e-3 * Vec3{mm[0], mm[1], -mm[2]});
        landmarks.p_A_inhaled.emplace_back(1e-3 * Vec3{mm[3], mm[4], -mm[5]});
    }
    if (landmarks.p_A_exhaled.empty()
        || !(boxAround(landmarks.p_A_exhaled).size().array() > 0.0).all())
        return fail(Errc::TooFewLandmarks,
                    file.toStdString() + " has too few landmarks to tell how large the lungs are.");
    return landmarks;
}

LandmarkResiduals residualsOf(const LandmarkCase& landmarks, const BreathingConstants& constants)
{
    const Eigen::VectorXd motion = motions(landmarks);
    const Eigen::VectorXd moved = displacements(landmarks, constants.frontShare, constants.breath);
    LandmarkResiduals residuals;
    residuals.amplitude = bestAmplitude(moved, motion);
    residuals.size_A = boxAround(landmarks.p_A_exhaled).size();
    const Eigen::VectorXd left = motion - residuals.amplitude * moved;
    residuals.meanMotion_mm = 1e3 * meanLength(motion);
    residuals.meanResidual_mm = 1e3 * meanLength(left);
    residuals.maxResidual_mm = 1e3 * left.reshaped(3, left.size() / 3).colwise().norm().maxCoeff();
    const Eigen::VectorXd shift = shiftFromApex(landmarks);
    residuals.meanResidualOfShift_mm =
        1e3 * meanLength(motion - bestAmplitude(shift, motion) * shift);
    residuals.meanResidualOfAffine_mm = 1e3 * meanLength(residualOfAffine(landmarks, motion));
    return residuals;
}

BreathingConstants fitConstants(std::span<const LandmarkCase> cases)
{
    CARINA_EXPECTS(!cases.empty());
    std::vector<Person> people;
    std::ranges::transform(cases, std::back_inserter(people), personOf);
    const BreathingConstants first;
    Weights w{1.0, first.frontShare, first.breath.ribs, first.breath.gravity};
    for (int round = 0; round < kRounds; ++round) {
        Eigen::Matrix<double, kParts, kParts> normal = decltype(normal)::Zero();
        Weights right = Weights::Zero();
        for (const Person& person : people) {
            const double s = bestAmplitude(person.basis * w, person.motion);
            normal += s * s * person.basis.transpose() * person.basis;
            right += s * person.basis.transpose() * person.motion;
        }
        w = normal.ldlt().solve(right);
        w /= w[0];
    }
    return {w[1], {.diaphragm = 1.0, .ribs = w[2], .gravity = w[3]}};
}

} // namespace carina::lab
