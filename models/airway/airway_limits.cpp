#include "models/airway/airway_limits.h"

#include "models/patient/laryngoscopy.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

class LimitWords
{
    Q_DECLARE_TR_FUNCTIONS(Airway)

public:
    static QString ofAll(const Error& missing)
    {
        return tr("This patient shows no event of the airway (%1): choose a patient with a whole "
                  "larynx.")
            .arg(QString::fromStdString(missing.detail));
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

private:
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
    for (std::size_t place = 0; place < limits.each.size(); ++place)
        if (const auto kind = static_cast<AirwayEventKind>(place); !laryngoscopy->canShow(kind))
            limits.each[place] = LimitWords::of(kind, patient);
    return limits;
}

} // namespace carina
