#pragma once

#include "engine/session/facts/registration_facts.h"
#include "models/station/headset_view.h"
#include "models/station/station_view.h"

#include <QString>

namespace carina
{

/// The notice shown at a station, as translated lines; empty if there is no problem. The first line
/// is the most important of: the session has ended, refusal by the host, no host (beside a pause of
/// the session), session not running, headset (if there is one) or tube at work not seen, with what
/// to do where no tracker could see it. A line is added while a headset's picture is turned by
/// mouse (looksByMouse), which says how, one while the registration cannot be relied on, one while
/// the tube is drawn beside the tracked one, or not as it bends, one while the patient is displaced
/// from its original pose, and one that names what is lifted out of it.
///
/// A muted participant reads that it is muted, and one whose token was replaced why, for a minute.
/// One whom an instructor moved, or from whom one took what they held, reads that for 15 s.
/// Once the host has removed this program, only its reason is shown.
/// @param registration of this program's manikin; std::nullopt for a program without a tracker
[[nodiscard]] QString stationNotice(const SessionNode& node, const StationMoment& moment,
                                    ViewOutput output,
                                    const std::optional<RegistrationStanding>& registration = {});

/// Whether nothing more happens here: the session has ended, or isRemoved().
[[nodiscard]] bool isOver(const SessionNode& node);

/// Whether a person is offered another session: this one is over, or its host has been silent for
/// some seconds and may never come back.
[[nodiscard]] bool offersAnother(const SessionNode& node);

/// Whether the host removed this program for good, so that nothing it offers has an effect.
[[nodiscard]] bool isRemoved(const SessionNode& node);

} // namespace carina
