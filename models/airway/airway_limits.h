#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "models/patient/patient_model.h"

#include <QString>

#include <array>

namespace carina
{

/// What a patient's surfaces cannot show of the events of an airway, each in one sentence; all are
/// empty for a patient that shows everything.
struct AirwayLimits {
    QString all;                                   ///< why it shows no event at all
    std::array<QString, kAirwayEventKinds> each{}; ///< why not this one, where it shows others
    std::array<QString, kAirwayEventKinds> part{}; ///< why not all of one that it does show

    [[nodiscard]] const QString& of(AirwayEventKind kind) const
    {
        return each[static_cast<std::size_t>(kind)];
    }
    /// Why it is not shown, or not all of it.
    [[nodiscard]] const QString& said(AirwayEventKind kind) const
    {
        return of(kind).isEmpty() ? part[static_cast<std::size_t>(kind)] : of(kind);
    }
    [[nodiscard]] bool canShow(AirwayEventKind kind) const
    {
        return all.isEmpty() && of(kind).isEmpty();
    }
    friend bool operator==(const AirwayLimits&, const AirwayLimits&) = default;
};

/// Looks through the surfaces of the throat (Laryngoscopy::of), which takes some milliseconds.
[[nodiscard]] AirwayLimits airwayLimitsOf(const PatientModel& patient);

} // namespace carina
