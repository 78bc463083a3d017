#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"
#include "engine/net/entry/psk_identity.h"

#include <filesystem>

namespace carina
{

/// The secrets of a session: a code for each role with the key derived from it, and a token for
/// each participant. A value; the host has it written to a file that only its owner may read,
/// before anybody hears of a change, so that it survives a crash.
class SessionSecrets
{
public:
    /// Reads the secrets from the file, or creates and writes new ones where there is none.
    /// @param file empty: in memory only
    /// @returns FileMalformed for a damaged file, or one of another session; FileUnwritable.
    [[nodiscard]] static Result<SessionSecrets> open(std::filesystem::path file,
                                                     std::string sessionId);

    [[nodiscard]] const std::string& sessionId() const { return m_sessionId; }
    [[nodiscard]] const JoinCodes& codes() const { return m_codes; }

    /// The key of a role's code; nothing until it is derived.
    [[nodiscard]] std::optional<AccessKey> codeKey(Role role) const;
    void setCodeKey(Role role, const AccessKey& key) { m_codeKeys.insert_or_assign(role, key); }

    /// Replaces a role's code; the old one and its key are void.
    void changeCode(Role role);

    /// The token of a participant in this role; nothing where none was issued.
    [[nodiscard]] std::optional<AccessKey> token(Role role, ParticipantId participant) const;
    /// Sets the token of a participant, in place of one there may be. @returns it
    AccessKey newToken(Role role, ParticipantId participant);
    /// From now on the participant has no token.
    void revokeToken(Role role, ParticipantId participant) { m_tokens.erase({role, participant}); }

    /// Keeps the secrets beside another file from now on, under its name and their ending; in
    /// memory if they were so far.
    void moveBeside(std::filesystem::path file);

    /// Replaces the file. May be called from any thread, on a copy. @returns FileUnwritable.
    [[nodiscard]] Result<void> write() const;

    /// Takes codes and tokens of others; the keys that are known of the codes stay.
    void revertTo(const SessionSecrets& others);

private:
    SessionSecrets(std::filesystem::path file, std::string sessionId);

    [[nodiscard]] Result<void> read();

    std::filesystem::path m_file;
    std::string m_sessionId;
    JoinCodes m_codes;
    std::map<Role, AccessKey> m_codeKeys;
    std::map<std::pair<Role, ParticipantId>, AccessKey> m_tokens;
};

} // namespace carina
