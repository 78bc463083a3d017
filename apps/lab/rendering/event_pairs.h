#pragma once

#include "apps/lab/rendering/scope_series.h"

#include <QDir>

namespace carina::lab
{

/// Of which events pictures are wanted.
struct PairOrder {
    ScopeWay way{};
    AirwayEvents events{};  ///< each alone
    bool leavesOut = false; ///< what the patient cannot show, instead of failing
    QDir folder;            ///< made if need be
};

/// Draws what a laryngoscope shows before and after each event, in that of kLaryngoscopySteps in
/// which most of the picture changes, and measures both. The head lies in neutral position, but for
/// a stiff neck in the sniffing one, from which that keeps it. Every picture is a PNG. The keys of
/// what is returned are in the help of `render`.
///
/// @param anatomy with the mouth shut
/// @returns FileUnwritable with the path; what canShowAll, patientOf, Laryngoscopy::of and
///          drawShots fail with
/// @pre as drawShots
[[nodiscard]] Result<QJsonObject> drawEventPairs(Anatomy anatomy, const PairOrder& order);

} // namespace carina::lab
