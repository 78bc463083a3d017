#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

// Those who take part and propose facts without end.

/// An observer: that it leaves.
[[nodiscard]] std::unique_ptr<Attack> beginLeaving(const Target& target);
/// A trainee: to share ever more tubes, and to hand them over to the host.
[[nodiscard]] std::unique_ptr<Attack> beginSharing(const Target& target);
/// A trainee: breaths of the manikin.
[[nodiscard]] std::unique_ptr<Attack> beginBreathing(const Target& target);
/// A trainee: the place and the registration that it has already.
[[nodiscard]] std::unique_ptr<Attack> beginRepeating(const Target& target);
/// An instructor: what it may decide about the patient.
[[nodiscard]] std::unique_ptr<Attack> beginInstructing(const Target& target);
/// An instructor: a new code for observers.
[[nodiscard]] std::unique_ptr<Attack> beginNewCodes(const Target& target);

} // namespace carina::lab
