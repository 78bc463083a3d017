#include "models/openigtlink/station_offer.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/tracking/igtl/igtl_pose.h"

#include <array>

namespace carina
{
namespace
{

constexpr std::size_t kLongestToolName = 20; ///< in a header of OpenIGTLink

IgtlPoint fiducial(const char* name, const Vec3& p_A)
{
    IgtlPoint point;
    point.name = name;
    point.group = "Landmark";
    point.p = igtlPoint(axesOfSlicer() * p_A);
    return point;
}

/// Cut so that no character is left in part (UTF-8).
std::string cutName(std::string name)
{
    std::size_t end = std::min(name.size(), kLongestToolName);
    while (end < name.size() && end > 0 && (static_cast<unsigned char>(name[end]) >> 6U) == 2U)
        --end;
    name.resize(end);
    return name;
}

/// What a person's own object is called; nullptr for those that are of who is at work.
const char* wordOf(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Head:
        return "Head ";
    case ObjectKind::Hand:
        return "Hand ";
    case ObjectKind::Stylus:
        return "Stylus ";
    case ObjectKind::Laryngoscope:
        return "Blade ";
    case ObjectKind::Jaw:
    case ObjectKind::Tube:
    case ObjectKind::Patient:
    case ObjectKind::OrganGroup:
    case ObjectKind::SpareTube:
    case ObjectKind::View:
    case ObjectKind::Pointer:
        break;
    }
    return nullptr;
}

std::vector<IgtlOffer::Tool> toolsIn(const StationMoment& moment)
{
    const RigidTransform X_RA = axesOfSlicer();
    std::vector<IgtlOffer::Tool> tools;
    const auto add = [&](std::string name, const PoseSample& sample, const RigidTransform& X_AO) {
        tools.push_back({cutName(std::move(name)), X_RA * X_AO, sample.validity != Validity::Lost});
    };
    if (moment.tube)
        add("Tube", *moment.tube, moment.tube->X_FO);
    if (moment.jaw)
        add("Jaw", *moment.jaw, moment.jaw->X_FO);
    for (const PersonPose& person : moment.people)
        if (const char* word = wordOf(person.kind))
            add(word + person.ownerName, person.pose, person.X_AO);
    return tools;
}

std::shared_ptr<const IgtlPoints> landmarksOf(const PatientModel& patient,
                                              const HeadPosition& position)
{
    const AirwayLandmarks airway = bent(patient.landmarks(), patient.neck(position));
    return std::make_shared<const IgtlPoints>(IgtlPoints{{fiducial("Incisors", airway.p_A_incisors),
                                                          fiducial("Glottis", airway.p_A_glottis),
                                                          fiducial("Carina", airway.p_A_carina)}});
}

std::shared_ptr<const IgtlOffer::Surface> lungsOf(const PatientModel& patient,
                                                  const ChestPose& pose, std::uint64_t stamp)
{
    const LungPair& lungs = patient.lungs();
    if (lungs.parts().empty())
        return nullptr;
    auto surface = std::make_shared<IgtlOffer::Surface>();
    surface->name = "Lungs";
    surface->stamp = stamp;
    const std::size_t level = StationOffer::levelOf(patient);
    for (const BreathingPart& part : lungs.parts())
        appendSurface(surface->data, axesOfSlicer(),
                      deformed(levelOf(part, level), lungs.field(),
                               motionOf(part.region, pose, lungs.field())));
    return surface;
}

} // namespace

RigidTransform axesOfSlicer() { return {Quat{0.0, 0.0, 0.0, 1.0}, Vec3::Zero()}; }

std::size_t StationOffer::levelOf(const PatientModel& patient)
{
    const std::size_t levels = patient.lungs().levelCount();
    return levels == 0 ? 0 : levels - 1;
}

std::shared_ptr<const IgtlOffer> StationOffer::at(const PatientModel& patient,
                                                  const StationMoment& moment, Duration since1970)
{
    const bool isAnother = !m_landmarks || m_patient != patient.contentHash();
    if (isAnother || m_position != moment.headPosition) {
        m_patient = patient.contentHash();
        m_position = moment.headPosition;
        m_landmarks = landmarksOf(patient, m_position);
    }
    if (isAnother || since1970 - m_lungsMade >= IgtlSubscriber::kSurfaceInterval) {
        m_lungs = lungsOf(patient, moment.pose, igtlStamp(since1970));
        m_lungsMade = since1970;
    }
    return std::make_shared<const IgtlOffer>(
        IgtlOffer{igtlStamp(since1970), toolsIn(moment), m_landmarks, m_lungs});
}

} // namespace carina
