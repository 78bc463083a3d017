#pragma once

#include "apps/lab/attack/attacks.h"

#include <optional>

namespace carina::lab
{

/// The samples of a false tube, which are told from all others by where it is, and what an observer
/// was sent of them.
class FalseSamples
{
public:
    /// Where the false tube is, in A: nobody else has an object metres away from the patient.
    [[nodiscard]] static Vec3 place() { return {3.0, 2.0, 1.0}; }
    /// A sample of it under an object.
    [[nodiscard]] static StreamCpo sample(ObjectId object, std::uint16_t sequence,
                                          SessionTime time);

    /// Counts the false ones of a group that the observer was sent.
    /// @param own the object that the attacker has shared; nothing before it has
    /// @param hostSent session time at which the host sent the group
    void see(const StreamGroup& group, std::optional<ObjectId> own, SessionTime hostSent);

    /// With the bounds that show that samples in time reach the observer under the attacker's own
    /// object, none under another's, and none from ahead of the session.
    [[nodiscard]] std::vector<Measured> measured(Duration length) const;

private:
    std::int64_t m_own = 0;     ///< in time, as the attacker's own object
    std::int64_t m_foreign = 0; ///< in the place of another's
    std::int64_t m_ahead = 0;   ///< from further ahead of the session than the host takes
};

} // namespace carina::lab
