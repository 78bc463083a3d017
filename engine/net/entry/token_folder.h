#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

#include <filesystem>
#include <map>

namespace carina
{

/// The tokens that a program was issued, by which it comes back into a session without its code: a
/// file for each session, role and name, which only its owner may read.
class TokenFolder
{
public:
    struct Token {
        ParticipantId participant;
        AccessKey key;
    };

    /// @param folder empty: tokens are kept in memory only
    TokenFolder(std::filesystem::path folder, Role role, std::string name);

    /// Nothing where none was kept, or what was kept cannot be read.
    [[nodiscard]] std::optional<Token> find(const std::string& sessionId) const;
    /// Whether one was kept for this role and name, of whichever session.
    [[nodiscard]] bool hasAny() const;
    /// @returns FileUnwritable; it is known until the program ends all the same.
    Result<void> keep(const std::string& sessionId, const Token& token);

private:
    /// What its files' names end with, after the session.
    [[nodiscard]] std::string ending() const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string& sessionId) const;

    std::filesystem::path m_folder;
    Role m_role;
    std::string m_name;
    std::map<std::string, Token> m_known; // by session
};

} // namespace carina
