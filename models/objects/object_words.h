#pragma once

#include "engine/anatomy/organ_group.h"
#include "models/station/lifted_objects.h"

#include <QString>

namespace carina
{

/// "Heart and vessels"
[[nodiscard]] QString groupWord(OrganGroup group);

/// What an object that is acted on is called: a group of organs by its word, the second tube, any
/// other by the name under which it is shared.
[[nodiscard]] QString objectWord(const SharedObject& object);

/// What a participant is called.
[[nodiscard]] QString participantWord(const SessionState& state, ParticipantId id);

/// What is written beside something that is lifted out: "Lungs (Tom)", or "Lungs (you)".
[[nodiscard]] QString liftedWord(const LiftedObject& lifted);

/// All that is lifted out, as a state: "▲ Lifted out: Lungs (Tom), Airway (you)"; empty where
/// nothing is.
[[nodiscard]] QString liftedText(const std::vector<LiftedObject>& lifted);

} // namespace carina
