#pragma once

#include "engine/net/entry/source_limiter.h"
#include "engine/session/session_state.h"

#include <map>

namespace carina
{

/// From which addresses the participants of a session came in since the host's program was started.
/// Of the names and places of a role one address has mostNamesFrom and mostPresentFrom, so that
/// nobody behind it keeps out people elsewhere.
class Origins
{
public:
    struct Comer {
        ParticipantId id;
        Role role = Role::Observer;
        SourcePrefix from{};
    };

    /// Whether one may come in. Who has a place may; not on the strength of one that was kept over
    /// a restart of the host, as nobody knows from which address it was taken. For all others a
    /// place must be left to the address, of which those count that are kept for who has gone, and
    /// for who is new a name.
    [[nodiscard]] bool mayComeIn(const Comer& comer, const SessionState& state,
                                 SessionTime now) const;
    void cameIn(const Comer& comer);
    /// Whose joining could not be stored, and who is thus not in the session, did not come in.
    void forgetOthersThan(const SessionState& state);

private:
    struct Origin {
        Role role = Role::Observer;
        SourcePrefix first{};
        SourcePrefix last{};
    };

    [[nodiscard]] std::size_t namesFrom(const SourcePrefix& from, Role role) const;
    /// Of participants other than the comer.
    [[nodiscard]] std::size_t placesBeside(const Comer& comer, const SessionState& state,
                                           SessionTime now) const;

    std::map<ParticipantId, Origin> m_origins;
};

} // namespace carina
