#include "models/airway/airway_limits.h"

#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "models/patient/laryngoscopy.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

/// What upperAirwayOf says is missing, for translators.
[[maybe_unused]] constexpr std::array kMissing{
    QT_TRANSLATE_NOOP("Airway", "the trachea is too short"),
    QT_TRANSLATE_NOOP("Airway", "no epiglottis"), QT_TRANSLATE_NOOP("Airway", "no vocal cords"),
    QT_TRANSLATE_NOOP("Airway", "no soft palate")};

class LimitWords
{
    Q_DECLARE_TR_FUNCTIONS(Airway)

public:
    static QString ofAll(const Error& missing)
    {
        return tr("This patient shows no event of the airway (%1): choose a patient with a whole "
                  "larynx.")
            .arg(QCoreApplication::translate("Airway", missing.detail.c_str()));
    }
    static QString of(AirwayEventKind kind, const PatientModel& patient)
    {
        switch (kind) {
        case AirwayEventKind::TongueOedema:
            if (!has(patient, PartRole::Tongue))
                return tr("Not shown: this patient has no tongue of its own.");
            break;
        case AirwayEventKind::TrachealStenosis:
        case AirwayEventKind::TrachealDeviation:
        case AirwayEventKind::Goitre:
            if (!has(patient, PartRole::Trachea))
                return tr("Not shown: this patient has no trachea of its own.");
            break;
        case AirwayEventKind::ProminentIncisors:
        case AirwayEventKind::FragileTeeth:
            return tr("Not shown: this patient has no teeth where the upper incisors are.");
        default:
            break;
        }
        return tr("Not shown: this patient has too little of what it changes.");
    }
    /// What it lacks beside what an event changes; empty where it lacks nothing.
    static QString ofPart(AirwayEventKind kind, const PatientModel& patient)
    {
        switch (kind) {
        case AirwayEventKind::AngioOedema:
            if (!hasLips(patient))
                return tr("Shown in part: this patient has no lips of its own.");
            [[fallthrough]];
        case AirwayEventKind::Burn:
            if (!has(patient, PartRole::Tongue))
                return tr("Shown in part: this patient has no tongue of its own.");
            break;
        case AirwayEventKind::Goitre:
        case AirwayEventKind::NeckObesity:
            if (!has(patient, PartRole::Skin))
                return tr("Shown in part: this patient has no skin.");
            break;
        case AirwayEventKind::Trismus:
            if (!has(patient, PartRole::Mandible))
                return tr("Shown in part: this patient has no lower jaw of its own.");
            break;
        case AirwayEventKind::FragileTeeth:
            if (!hasLooseTooth(patient))
                return tr("Shown in part: this patient has no right upper central incisor of its "
                          "own.");
            break;
        default:
            break;
        }
        return {};
    }

private:
    static bool hasLips(const PatientModel& patient)
    {
        return std::ranges::any_of(patient.surfaces(), [](const PatientSurface& surface) {
            return isLip(surface.description);
        });
    }
    static bool hasLooseTooth(const PatientModel& patient)
    {
        return std::ranges::any_of(patient.surfaces(), [](const PatientSurface& surface) {
            return regionOf(surface.description) == ChestRegion::LooseTooth;
        });
    }
    static bool has(const PatientModel& patient, PartRole role)
    {
        return std::ranges::any_of(patient.surfaces(), [role](const PatientSurface& surface) {
            return surface.description.role == role;
        });
    }
};

} // namespace

AirwayLimits airwayLimitsOf(const PatientModel& patient)
{
    AirwayLimits limits;
    const auto laryngoscopy = Laryngoscopy::of(patient, bladeOf(kUsualBlade));
    if (!laryngoscopy) {
        limits.all = LimitWords::ofAll(laryngoscopy.error());
        return limits;
    }
    for (std::size_t place = 0; place < limits.each.size(); ++place) {
        const auto kind = static_cast<AirwayEventKind>(place);
        if (laryngoscopy->canShow(kind))
            limits.part[place] = LimitWords::ofPart(kind, patient);
        else
            limits.each[place] = LimitWords::of(kind, patient);
    }
    return limits;
}

} // namespace carina
