#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

#include <filesystem>
#include <map>

namespace carina
{

/// The tokens issued to a program, with which it joins a session again without its code: one file
/// for each session, role and name, which only its owner may read, in a folder that only its owner
/// may open.
class TokenFolder
{
public:
    struct Token {
        ParticipantId participant;
        AccessKey key;
    };

    /// @param folder empty: tokens are kept in memory only
    TokenFolder(std::filesystem::path folder, Role role, std::string name);

    /// Nothing where no token is stored, or it cannot be read.
    [[nodiscard]] std::optional<Token> find(const std::string& sessionId) const;
    /// Whether a token of any session is stored for this role and name.
    [[nodiscard]] bool hasAny() const;
    /// Stores a token. @returns FileUnwritable; the token is then kept in memory.
    Result<void> keep(const std::string& sessionId, const Token& token);

private:
    /// The end of the file names, after the session id.
    [[nodiscard]] std::string ending() const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string& sessionId) const;

    std::filesystem::path m_folder;
    Role m_role;
    std::string m_name;
    std::map<std::string, Token> m_known; // by session
};

} // namespace carina
