#include "models/registration/registration_targets.h"

#include "engine/registration/error/target_error.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

constexpr float kFacesDown = -0.7F; ///< z of a normal, beyond which a surface is of the base

class TargetWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationTargets)

public:
    static QString inDirection(BodyAxis axis)
    {
        switch (axis) {
        case BodyAxis::LeftRight:
            return tr("left-right");
        case BodyAxis::FrontBack:
            return tr("front-back");
        case BodyAxis::HeadFeet:
            return tr("head-feet");
        }
        return {};
    }
};

/// The mean of what faces the diaphragm, or nothing for a side without a lung.
std::optional<Vec3> lungBase(const PatientModel& patient, Side side)
{
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (const BreathingPart& part : patient.lungs().parts()) {
        if (part.side != side)
            continue;
        const TriangleMesh& finest = part.levels.front();
        const float middle = float(boundsOf(finest).centre().z());
        for (std::size_t i = 0; i < finest.positions.size(); ++i) {
            if (finest.normals[i].z() > kFacesDown || finest.positions[i].z() > middle)
                continue;
            sum += finest.positions[i].cast<double>();
            ++count;
        }
    }
    return count == 0 ? std::nullopt : std::optional{Vec3{sum / double(count)}};
}

} // namespace

std::vector<RegistrationTarget> registrationTargets(const PatientModel& patient)
{
    const AirwayLandmarks& airway = patient.landmarks();
    std::vector<RegistrationTarget> targets{{TargetWords::tr("Glottis"), airway.p_A_glottis},
                                            {TargetWords::tr("Carina"), airway.p_A_carina},
                                            {TargetWords::tr("Incisors"), airway.p_A_incisors}};
    if (const auto base = lungBase(patient, Side::Left))
        targets.push_back({TargetWords::tr("Left lung base"), *base});
    if (const auto base = lungBase(patient, Side::Right))
        targets.push_back({TargetWords::tr("Right lung base"), *base});
    return targets;
}

std::vector<ExpectedError> expectedErrors(const Mat6& covariance_A, double degrees,
                                          const std::vector<RegistrationTarget>& targets)
{
    std::vector<ExpectedError> errors;
    for (const RegistrationTarget& target : targets) {
        const TargetError error = targetError(covariance_A, target.p_A, degrees);
        errors.push_back({.name = target.name,
                          .rms_mm = inMillimetres(error.rms),
                          .bound_mm = inMillimetres(error.bound),
                          .weakest = TargetWords::inDirection(error.weakestAxis)});
    }
    return errors;
}

} // namespace carina
