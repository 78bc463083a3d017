#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"
#include "engine/net/entry/psk_identity.h"

#include <filesystem>

namespace carina
{

/// The secrets of a session, stored by its host: a code for each role with the key derived from it,
/// and a token for each participant. They are written before use, to a file that only its owner may
/// read, so that they survive a crash.
class SessionSecrets
{
public:
    /// Reads the secrets from the file, or creates new ones where there is none.
    /// @param file empty: in memory only
    /// @returns FileMalformed for a damaged file, or one of another session; FileUnwritable.
    [[nodiscard]] static Result<SessionSecrets> open(std::filesystem::path file,
                                                     std::string sessionId);

    [[nodiscard]] const std::string& sessionId() const { return m_sessionId; }
    [[nodiscard]] const JoinCodes& codes() const { return m_codes; }

    /// The key of a role's code; nothing until it is derived.
    [[nodiscard]] std::optional<AccessKey> codeKey(Role role) const;
    /// @returns FileUnwritable; the key is used nevertheless, and derived again after a restart.
    Result<void> setCodeKey(Role role, const AccessKey& key);

    /// Replaces a role's code; the old one and its key are void. @returns FileUnwritable; then
    /// nothing has changed.
    [[nodiscard]] Result<void> changeCode(Role role);

    /// The token of a participant in this role; nothing where none was issued.
    [[nodiscard]] std::optional<AccessKey> token(Role role, ParticipantId participant) const;
    /// The token of a participant, created on the first call. @returns FileUnwritable; then no
    /// token exists.
    [[nodiscard]] Result<AccessKey> issueToken(Role role, ParticipantId participant);

    /// Another token in place of the participant's. @returns FileUnwritable; then nothing has
    /// changed.
    [[nodiscard]] Result<AccessKey> replaceToken(Role role, ParticipantId participant);
    /// From now on the participant has no token. @returns FileUnwritable; it is void nevertheless,
    /// until the next start.
    [[nodiscard]] Result<void> revokeToken(Role role, ParticipantId participant);

    /// Keeps the secrets beside another file from now on, under its name and their ending; in
    /// memory if they were so far. @returns FileUnwritable.
    [[nodiscard]] Result<void> moveBeside(std::filesystem::path file);

private:
    SessionSecrets(std::filesystem::path file, std::string sessionId);

    [[nodiscard]] Result<void> read();
    [[nodiscard]] Result<void> write() const;

    std::filesystem::path m_file;
    std::string m_sessionId;
    JoinCodes m_codes;
    std::map<Role, AccessKey> m_codeKeys;
    std::map<std::pair<Role, ParticipantId>, AccessKey> m_tokens;
};

} // namespace carina
